"""Scenes from pictures of masonry, or of aggregates in a matrix."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ..needed import from_debian
from .assembled import Block, Scale, scene_of_blocks
from .chains import blocks_of
from .faults import SceneError
from .labels import PACKAGE, class_of_labels, connected, grown, merge_small, split_touching

LEAST_AREA = 16  # pixels
TOLERANCE = 1.5  # pixels; below it slanted sides keep steps of pixels
MOST_BLOCKS = 20000


@dataclass(frozen=True)
class Wishes:
    """tolerance: how far a side may be from the boundary in the picture [L]; None: 1.5 pixels. least_area: smaller parts go to
    a neighbour [L²]; None: 16 pixels. split: {material: depth}, parts of it that touch at a neck whose half-width is so much
    below that of the narrower part become several [L]. smooth: standard deviation of a Gaussian filter of the colours [L].
    without: materials that become nothing."""

    tolerance: float | None = None
    least_area: float | None = None
    split: dict = field(default_factory=dict)
    smooth: float = 0.0
    without: tuple = ()

    def __post_init__(self):
        values = {name: getattr(self, name) for name in ("tolerance", "least_area", "smooth")}
        for name, value in (values | {f"split of {material}": depth for material, depth in self.split.items()}).items():
            if value is not None and not 0 <= value < float("inf"):
                raise SceneError(f"{name} is {value:g}: give a number from 0 on")


def scene_of_image(file, width=None, height=None, *, materials, joint=None, thresholds=None, wishes=Wishes()):
    """The scene of a picture (PNG, JPEG, TIFF), its lower left corner at (0, 0).

    width or height: of what the picture shows [L]; a pixel is a square.
    materials: {name: colour}, a colour "#rrggbb" or by name, or a brightness from 0 to 1: each pixel is of the material of
    the nearest colour (CIELAB). Or a list of names, the darkest first: told apart by brightness, at `thresholds` from
    0 to 1, one fewer than names, by default Otsu's.
    joint: the material whose pixels are shared out to what is nearest, so that stones grow until they meet; without it
    every material becomes blocks.
    Regions are named `MATERIAL NUMBER`, the pieces of one that had holes `MATERIAL NUMBER.PIECE`; boundaries left, right,
    bottom, top as far as there are blocks.
    Throws SceneError with file and place, ModuleMissing.
    """
    colours = read(file)
    scale = Scale.of_picture(file, colours.shape[:2], (width, height))
    number = list(materials).index(joint) if joint in materials else None
    names = list(materials)
    for name in [*wishes.without, *wishes.split, *([joint] if joint is not None else [])]:
        if name not in names:
            raise SceneError(f"{file}: '{name}' is none of the materials {', '.join(names)}: name it as one, with its colour")
    classes = classified(file, smoothed(colours, wishes.smooth / scale.unit), (materials, thresholds))
    depths = {names.index(name): depth / scale.unit for name, depth in wishes.split.items()}
    labels = divided(connected(np.where(classes == number, -1, classes)), classes, depths)
    labels, of_class = parts(labels, classes, least_pixels(scale, wishes))
    if not of_class:
        raise SceneError(f"{file}: no part of it is of {' or '.join(name for name in names if name != joint)}: check the colours "
                         "of the materials, or lower the least area")
    dropped = {names.index(name) for name in wishes.without}
    labels = np.where(np.isin(labels, [label for label, kind in of_class.items() if kind in dropped]), 0, labels)
    return assembled(file, labels, {label: names[kind] for label, kind in of_class.items()}, (scale, wishes))


def scene_of_labels(labels, materials, width=None, height=None, *, wishes=Wishes()):
    """The scene of an array of whole numbers (rows from the top), 0 where nothing is; parts of one number that do not
    touch are several blocks. materials: {number: name} or a list, the first of number 1. See scene_of_image for the rest.
    """
    labels = np.asarray(labels)
    if labels.ndim != 2 or not labels.size or not np.issubdtype(labels.dtype, np.integer) or labels.min() < 0:
        raise SceneError("labels: an array of two dimensions with whole numbers from 0 on")
    named = materials if isinstance(materials, dict) else dict(enumerate(materials, 1))
    missing = sorted(set(np.unique(labels).tolist()) - {0} - set(named))
    if missing:
        raise SceneError(f"labels: {missing[0]} has no material: give one for each number")
    scale = Scale.of_picture("labels", labels.shape, (width, height))
    parted, of_class = parts(connected(labels), labels - 1, least_pixels(scale, wishes))
    empty = [label for label, kind in of_class.items() if kind < 0]
    parted = np.where(np.isin(parted, empty), 0, parted)
    return assembled("labels", parted, {label: named[kind + 1] for label, kind in of_class.items() if kind >= 0}, (scale, wishes))


def read(file):
    """(height, width, 3) sRGB from 0 to 1, turned as the camera says; what is transparent is on white."""
    image = from_debian("PIL.Image", "python3-pil")
    if not Path(file).is_file():
        raise SceneError(f"{file}: there is no such file")
    try:
        with image.open(file) as picture:
            return colours_of(from_debian("PIL.ImageOps", "python3-pil").exif_transpose(picture), image)
    except (OSError, ValueError, SyntaxError, image.DecompressionBombError) as error:
        raise SceneError(f"{file}: no picture that can be read ({error}): save it as PNG, JPEG or TIFF") from error


def colours_of(picture, image):
    """Of a picture in any mode of Pillow; greys of more than 8 bits are from 0 to the brightest in it."""
    if picture.mode[0] in "IF":
        grey = np.clip(np.asarray(picture, float), 0, None)
        return np.repeat((grey / max(grey.max(), 1e-300))[:, :, None], 3, axis=2)
    if picture.mode in ("RGBA", "LA", "PA") or "transparency" in picture.info:
        whole = picture.convert("RGBA")
        picture = image.alpha_composite(image.new("RGBA", whole.size, "white"), whole)
    return np.asarray(picture.convert("RGB"), float) / 255


def smoothed(colours, deviation):
    """Colours after a Gaussian filter of so many pixels."""
    ndimage = from_debian("scipy.ndimage", "python3-scipy")
    return ndimage.gaussian_filter(colours, (deviation, deviation, 0)) if deviation > 0 else colours


def colour_of(file, name, value):
    """sRGB from 0 to 1 of "#rrggbb", a colour's name, or a brightness."""
    try:
        grey = float(value)
    except ValueError:
        pass
    else:
        if 0 <= grey <= 1:
            return [grey] * 3
        raise SceneError(f"{file}: material '{name}' has brightness {grey:g}: give one from 0, black, to 1, white")
    try:
        return [part / 255 for part in from_debian("PIL.ImageColor", "python3-pil").getrgb(str(value))[:3]]
    except ValueError as error:
        raise SceneError(f"{file}: material '{name}' has colour '{value}': give #rrggbb, a colour's name, or a brightness "
                         "from 0 to 1") from error


def classified(file, colours, how):
    """The number of each pixel's material; how: (materials, thresholds)."""
    materials, thresholds = how
    if not materials:
        raise SceneError(f"{file}: no material: give names, the darkest first, or names with colours")
    if not isinstance(materials, dict):
        return by_brightness(file, colours, how)
    if thresholds is not None:
        raise SceneError(f"{file}: thresholds belong to materials without colours: leave out one or the other")
    lab = from_debian("skimage.color", PACKAGE).rgb2lab
    pixels, nearest, least = lab(colours), np.zeros(colours.shape[:2], int), np.full(colours.shape[:2], np.inf)
    for k, (name, value) in enumerate(materials.items()):
        away = ((pixels - lab(np.array([[colour_of(file, name, value)]]))) ** 2).sum(axis=2)
        nearest[away < least] = k
        least = np.minimum(away, least)
    return nearest


def by_brightness(file, colours, how):
    """Classes between thresholds, the darkest 0."""
    names, thresholds = how
    grey = from_debian("skimage.color", PACKAGE).rgb2gray(colours)
    if thresholds is None:
        try:
            thresholds = from_debian("skimage.filters", PACKAGE).threshold_multiotsu(grey, len(names)) if len(names) > 1 else []
        except ValueError as error:
            raise SceneError(f"{file}: its brightness does not fall into {len(names)} classes: give thresholds, or colours of the "
                             "materials") from error
    if len(thresholds) != len(names) - 1:
        raise SceneError(f"{file}: {len(thresholds)} thresholds for {len(names)} materials: give one fewer than materials")
    outside = [value for value in thresholds if not 0 <= value <= 1]
    if outside:
        raise SceneError(f"{file}: the threshold {outside[0]:g}: give brightness from 0, black, to 1, white")
    return np.digitize(grey, sorted(thresholds))


def divided(labels, classes, depths):
    """Labels of which those of some classes are split where they touch; depths: {class: pixels}."""
    for kind, depth in depths.items():
        inside = (classes == kind) & (labels > 0)
        labels = np.where(inside, labels.max() + split_touching(inside, depth), labels)
    return labels


def least_pixels(scale, wishes):
    return LEAST_AREA if wishes.least_area is None else wishes.least_area / scale.unit**2


def parts(labels, classes, least):
    """(labels of connected parts from 1 on that leave no pixel out, {label: class}); what is 0 is shared out first."""
    if (labels == 0).any():
        sizes = np.bincount(labels.ravel())
        labels = np.where(sizes[labels] < least, 0, labels)
        if not labels.any():
            return labels, {}
        kinds = class_of_labels(labels, classes)
        labels = grown(labels)
        numbers, places = np.unique(labels, return_inverse=True)
        classes = np.array([kinds[number] for number in numbers.tolist()])[places].reshape(labels.shape)
        labels = connected(labels, background=0)
    labels = merge_small(labels, least)
    return labels, merged_classes(labels, classes)


def merged_classes(labels, classes):
    """{label: the class that most of its pixels have}."""
    kinds = classes - classes.min()
    count = int(kinds.max()) + 1
    numbers, votes = np.unique(labels.astype(np.int64) * count + kinds, return_counts=True)
    best = {}
    for number, vote in sorted(zip(numbers.tolist(), votes.tolist()), key=lambda pair: pair[1]):
        best[number // count] = number % count + int(classes.min())
    return best


def assembled(file, labels, materials, how):
    """The scene of labelled pixels; materials: {label: name}; how: (scale, wishes)."""
    scale, wishes = how
    if not labels.any():
        raise SceneError(f"{file}: nothing is left of it: name fewer materials in `without`")
    if len(np.unique(labels)) > MOST_BLOCKS:
        raise SceneError(f"{file}: more than {MOST_BLOCKS} parts: smooth it, or raise the least area")
    tolerance = TOLERANCE if wishes.tolerance is None else wishes.tolerance / scale.unit
    points, blocks = blocks_of(labels, tolerance)
    return scene_of_blocks(np.array(points) * scale.unit, [Block(ring, label, materials[label]) for label, ring in sorted(blocks)])
