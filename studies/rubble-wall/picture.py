"""A picture of a wall of rubble, drawn from random numbers: grey and brown stones in light mortar, grain and shade of a photograph."""

import numpy as np
from PIL import Image

STONES = np.array([[0x7A, 0x6A, 0x58], [0x6E, 0x6C, 0x68], [0x86, 0x74, 0x5C], [0x62, 0x5C, 0x54]], float)
MORTAR = np.array([0xDC, 0xD4, 0xC4], float)
FLATNESS = 1.6  # stones are so much longer than high


def relaxed(places, pixels, passes=6):
    """Places moved to the centroids of what is nearest to them, Lloyd's algorithm."""
    for _ in range(passes):
        nearest = distances(places, pixels).argmin(axis=1)
        places = np.array([pixels[nearest == k].mean(axis=0) if (nearest == k).any() else place for k, place in enumerate(places)])
    return places


def distances(places, pixels):
    """(pixels, places): as stones see them, for whom a step up is longer than one along."""
    away = pixels[:, None] - places
    return np.hypot(away[:, :, 0], FLATNESS * away[:, :, 1])


def draw(file, stones, shape, seed):
    """Of so many stones, in an array of (rows, columns) pixels; joints about 5 pixels broad."""
    random = np.random.default_rng(seed)
    rows, columns = shape
    pixels = np.stack(np.meshgrid(np.arange(columns), np.arange(rows)), axis=-1).reshape(-1, 2) + 0.5
    places = relaxed(random.random((stones, 2)) * (columns, rows), pixels[::23])
    away = distances(places, pixels)
    order = np.sort(away, axis=1)
    colours = STONES[random.integers(len(STONES), size=stones)] + random.normal(0, 6, (stones, 1))
    picture = colours[away.argmin(axis=1)]
    picture[order[:, 1] - order[:, 0] < 5] = MORTAR
    shade = 1 + 0.06 * np.sin(pixels[:, 0] / columns * np.pi)
    picture = picture * shade[:, None] + random.normal(0, 9, (len(pixels), 1))
    Image.fromarray(np.clip(picture, 0, 255).reshape(rows, columns, 3).astype(np.uint8)).save(file)
