"""Labels of a picture's pixels: connected parts, small ones given to their neighbours."""

import heapq
from collections import defaultdict

import numpy as np

from ..needed import from_debian

PACKAGE = "python3-skimage"


def connected(classes, background=-1):
    """Numbers 1, 2, ... of parts of one class that hang together by sides of pixels; 0 on the background.

    classes: (height, width) whole numbers from -1 on.
    """
    measure = from_debian("skimage.measure", PACKAGE)
    return measure.label(np.asarray(classes) - background, connectivity=1, background=0)


def class_of_labels(labels, classes):
    """{label: the class of its pixels}."""
    numbers, first = np.unique(labels, return_index=True)
    return dict(zip(numbers.tolist(), np.asarray(classes).ravel()[first].tolist()))


def sides_between(labels):
    """{label: {neighbour: number of pixels' sides between them}}."""
    labels, around = labels.astype(np.int64), defaultdict(lambda: defaultdict(int))
    base = labels.max() + 1
    for one, other in ((labels[:, 1:], labels[:, :-1]), (labels[1:], labels[:-1])):
        differs = one != other
        low, high = np.minimum(one, other)[differs], np.maximum(one, other)[differs]
        for pair, count in zip(*np.unique(low * base + high, return_counts=True)):
            low_label, high_label = divmod(int(pair), int(base))
            around[low_label][high_label] += int(count)
            around[high_label][low_label] += int(count)
    return around


def merge_small(labels, least):
    """Parts of fewer than `least` pixels go to the neighbour with the longest common boundary, the smallest first."""
    numbers, counts = np.unique(labels, return_counts=True)
    size, around, into = dict(zip(numbers.tolist(), counts.tolist())), sides_between(labels), {}
    waiting = [(count, number) for number, count in size.items() if count < least]
    heapq.heapify(waiting)
    while waiting:
        count, number = heapq.heappop(waiting)
        if number in into or size[number] != count or not around[number]:
            continue
        target = max(around[number], key=lambda other: (around[number][other], size[other], -other))
        into[number], size[target] = target, size[target] + count
        for other, length in around.pop(number).items():
            del around[other][number]
            if other != target:
                around[other][target] += length
                around[target][other] += length
        if size[target] < least:
            heapq.heappush(waiting, (size[target], target))
    return renamed(labels, into)


def renamed(labels, into):
    """Labels of which some have gone into others, which may have gone on themselves."""
    table = np.arange(labels.max() + 1)
    for number in into:
        last = number
        while last in into:
            last = into[last]
        table[number] = last
    return table[labels]


def split_touching(inside, depth):
    """Numbers 1, 2, ... of what touches at necks, by a watershed of the distance to the outside; 0 outside.

    inside: (height, width) of truth; depth: by how many pixels a neck's half-width is below that of the narrower part.
    """
    morphology, segmentation = (from_debian(f"skimage.{name}", PACKAGE) for name in ("morphology", "segmentation"))
    measure, ndimage = from_debian("skimage.measure", PACKAGE), from_debian("scipy.ndimage", "python3-scipy")
    distance = ndimage.distance_transform_edt(np.pad(inside, 1, mode="edge"))[1:-1, 1:-1]
    flattened = morphology.reconstruction(distance - depth, distance)
    markers = measure.label(morphology.local_maxima(flattened) & inside, connectivity=2)
    return connected(segmentation.watershed(-distance, markers, mask=inside), background=0)


def grown(labels):
    """Labels grown over the pixels of 0 until they meet, each pixel to the nearest."""
    segmentation = from_debian("skimage.segmentation", PACKAGE)
    return segmentation.expand_labels(labels, distance=float(np.hypot(*labels.shape)) + 1)
