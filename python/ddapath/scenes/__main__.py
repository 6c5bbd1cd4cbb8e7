"""`python -m ddapath scene FILE`: the scene of a picture (.png, .jpg, .tif), a drawing (.svg, .dxf, .step) or a finite-element mesh
(.inp, .med, .vtk, ...), in a deck to begin with.

    python -m ddapath scene wall.jpg --width 2000 --material mortar=#d8d0c0 --material stone=#806040 --joint mortar --out wall.yaml
    python -m ddapath scene concrete.png --width 100 --material aggregate --material matrix --scene-only --out scene.yaml
    python -m ddapath scene vault.dxf --scale 1000 --out vault.yaml
    python -m ddapath scene wall.inp --out wall.yaml     # and wall.msh

Lengths are in the units of the deck. Exit code 2 where no scene can be made of the file, 4 where a Python module is missing.
"""

import argparse
import math
import sys
from pathlib import Path

from .. import deck as decks
from ..commands import Parser, exit_code, number
from . import deck_of_elements, deck_to_begin_with, scene_of_dxf, scene_of_elements, scene_of_image, scene_of_step, scene_of_svg
from .elements import ENDINGS
from .faults import SceneError
from .image import Wishes
from .scaled import Units
from .starter import FORCES, LENGTHS

PICTURES = (".png", ".jpg", ".jpeg", ".tif", ".tiff")
DRAWINGS = {".svg": scene_of_svg, ".dxf": scene_of_dxf, ".step": scene_of_step, ".stp": scene_of_step}
OF_PICTURES = ("material", "threshold", "joint", "split", "smooth", "least_area")
DIGITS = 10  # of coordinates, of the larger extent
ALL = 60  # decimals: densities are small numbers in mm and MN


def parser():
    out = Parser(prog="python -m ddapath scene", description=__doc__,
                 formatter_class=argparse.RawDescriptionHelpFormatter)
    out.add_argument("file", metavar="FILE", help="the picture, drawing or mesh")
    out.add_argument("--out", "--output", metavar="FILE", help="the deck; by default FILE with the ending .yaml")
    out.add_argument("--scene-only", action="store_true", help="the section `scene` alone, for a deck that `extends` it")
    out.add_argument("--length", choices=LENGTHS, default="mm", help="unit of the deck, by default mm")
    out.add_argument("--force", choices=FORCES, default="N", help="unit of the deck, by default N")
    out.add_argument("--width", type=number, help="of the picture, or of all that is drawn")
    out.add_argument("--height", type=number, help="likewise")
    out.add_argument("--tolerance", type=number, help="of a picture: how far sides may be from boundaries, by default 1.5 pixels; of a "
                                                     "drawing: a corner so near to a side is on it, by default a thousandth of the extent")
    out.add_argument("--without", action="append", metavar="NAME", help="material, or layer, that becomes nothing")
    out.add_argument("--overwrite", action="store_true", help="replace the deck where there is one")
    drawing = out.add_argument_group("drawings and meshes")
    drawing.add_argument("--scale", type=number, help="of a unit of the file; by default 1")
    picture = out.add_argument_group("pictures")
    picture.add_argument("--material", action="append", metavar="NAME[=COLOUR]",
                         help="colour: #rrggbb, a name, or a brightness from 0 to 1; without colours: the darkest first")
    picture.add_argument("--threshold", action="append", type=number, help="of brightness, between materials without colours; by "
                                                                          "default Otsu's")
    picture.add_argument("--joint", metavar="NAME", help="material that is shared out until stones meet")
    picture.add_argument("--split", action="append", metavar="NAME=DEPTH", help="blocks of a material that touch at necks are parted")
    picture.add_argument("--smooth", type=number, help="standard deviation of a Gaussian filter")
    picture.add_argument("--least-area", type=number, help="smaller parts go to a neighbour; by default 16 pixels")
    return out


def named(option, words):
    """{name: what follows the last =, or None}."""
    found = {}
    for word in words or ():
        name, equals, value = word.rpartition("=")
        name, value = (name, value) if equals else (word, None)
        if not name or name in found:
            raise SceneError(f"{option} {word}: {'there is no name' if not name else 'that name is given twice'}")
        found[name] = value
    return found


def materials_of(asked):
    """A dictionary with colours or a list without."""
    found = named("--material", asked.material)
    if not found:
        raise SceneError(f"{asked.file}: no material: give each with --material NAME=COLOUR, or without colours, the darkest first")
    if all(value is None for value in found.values()):
        return list(found)
    bare = next((name for name, value in found.items() if value is None), None)
    if bare is not None:
        raise SceneError(f"--material {bare}: has no colour while others have: give all or none")
    return found


def depths_of(asked):
    found = named("--split", asked.split)
    try:
        return {name: float(value) for name, value in found.items()}
    except (TypeError, ValueError):
        raise SceneError(f"--split {' '.join(asked.split)}: give MATERIAL=DEPTH, a length") from None


def scene_of(asked):
    """Of the file by its ending."""
    ending = Path(asked.file).suffix.lower()
    if ending in DRAWINGS:
        given = next((name for name in OF_PICTURES if getattr(asked, name) is not None), None)
        if given:
            raise SceneError(f"--{given.replace('_', '-')} belongs to pictures: leave it out for {asked.file}")
        return DRAWINGS[ending](asked.file, units=Units(asked.scale, asked.width, asked.height), tolerance=asked.tolerance,
                                without=tuple(asked.without or ()))
    if ending not in PICTURES:
        raise SceneError(f"{asked.file}: its ending is none of {', '.join([*PICTURES, *DRAWINGS, *ENDINGS])}: save it as one of these")
    if asked.scale is not None:
        raise SceneError(f"--scale belongs to drawings: give the width or the height of {asked.file}")
    wishes = Wishes(asked.tolerance, asked.least_area, depths_of(asked), asked.smooth or 0.0, tuple(asked.without or ()))
    return scene_of_image(asked.file, asked.width, asked.height, materials=materials_of(asked), joint=asked.joint,
                          thresholds=asked.threshold, wishes=wishes)


def rounded(scene):
    """The scene with coordinates of ten digits of the larger extent, so that common points stay common."""
    size = max(abs(value) for region in scene["regions"] for vertex in region["vertices"] for value in vertex)
    decimals = DIGITS - math.ceil(math.log10(size)) if size > 0 else DIGITS

    def points(corners):
        return [[round(value, decimals) + 0.0 for value in corner] for corner in corners]

    lines = {name: {line: points(corners) for line, corners in scene[name].items()}
             for name in ("boundaries", "curves", "slits") if name in scene}
    return {**scene, **lines, "regions": [{**region, "vertices": points(region["vertices"])} for region in scene["regions"]]}


def free(file, asked):
    """The file, that nothing is overwritten in unasked."""
    if file.exists() and not asked.overwrite:
        raise SceneError(f"{file}: is there already: give another name with --out, or --overwrite")
    file.parent.mkdir(parents=True, exist_ok=True)
    return file


def of_elements(asked, file):
    """(scene, deck, number of blocks) of a finite-element mesh, which is written beside the deck."""
    given = next((name for name in (*OF_PICTURES, "width", "height", "tolerance", "without") if getattr(asked, name) is not None), None)
    if given:
        raise SceneError(f"--{given.replace('_', '-')} belongs to pictures and drawings: leave it out for {asked.file}")
    found = scene_of_elements(asked.file, free(file.with_suffix(".msh"), asked), 1.0 if asked.scale is None else asked.scale)
    return found.scene, lambda units, title: deck_of_elements(found, units, title), found.blocks


def of_polygons(asked):
    """The same of a picture or drawing."""
    scene = rounded(scene_of(asked))
    return scene, lambda units, title: deck_to_begin_with(scene, units, title), len(scene["regions"])


def written(asked):
    """The file, and how many blocks are in it."""
    file = free(Path(asked.out or Path(asked.file).with_suffix(".yaml")), asked)
    is_mesh = Path(asked.file).suffix.lower() in ENDINGS
    scene, deck, count = of_elements(asked, file) if is_mesh else of_polygons(asked)
    units = {"length": asked.length, "force": asked.force}
    tree = {"scene": scene} if asked.scene_only else deck(units, f"Blocks from {Path(asked.file).name}")
    file.write_text(decks.lines(tree, ALL), encoding="utf-8")
    return file, count


def main(arguments):
    def work():
        file, count = written(parser().parse_args(arguments))
        return f"{file}: {count} blocks"

    return exit_code("ddapath scene", work)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
