"""Blocks that no single subdivision makes: graded, mirrored about a straight line, read back from a run.

A polygon is a list of [x, y]; lengths in mm.
"""

import tempfile
from pathlib import Path

import numpy as np

import ddapath

TOUCHING = 1e-9  # of the largest coordinate


def rectangle(x0, y0, x1, y1):
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def regions(polygons):
    return [{"name": f"part{i}", "material": "concrete", "vertices": polygon} for i, polygon in enumerate(polygons)]


def voronoi(outline, size, seed=1):
    """Centroidal Voronoi cells of a rectangle, by the program itself; `size` is the root of their mean area."""
    (x0, y0), (x1, y1) = outline[0], outline[2]
    deck = {
        "scene": {"regions": regions([outline]),
                  "subdivision": {"type": "voronoi", "size": size, "seed": seed, "iterations": 100}},
        "thickness": 1,
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 1, "poisson_ratio": 0}},
        "supports": {"pin": {"at": [x0, y0], "fix": "xy"}, "roller": {"at": [x1, y0], "fix": "y"}},
        "stages": [{"loads": [{"type": "point_load", "at": [x1, y1], "force": [1, 0]}]}],
        "path": {"control": "load", "stop": {"after_steps": 1}},
    }
    with tempfile.TemporaryDirectory() as folder:
        cells = ddapath.run(deck, folder=Path(folder) / "run").fields().mesh.polygons
    return snapped(cells, (x0, x1), (y0, y1))


def snapped(polygons, xs, ys):
    """Coordinates that are a line's but for round-off become the line's, so that mirrored cells coincide."""
    for axis, lines in enumerate((xs, ys)):
        for line in lines:
            for cell in polygons:
                near = np.abs(cell[:, axis] - line) < TOUCHING * max(map(abs, (*xs, *ys)))
                cell[near, axis] = line
    return [cell.tolist() for cell in polygons]


def mirrored(polygons, axis):
    """The polygons and their mirror images, axis 0: x → −x, axis 1: y → −y."""
    images = [[[-x, y] if axis == 0 else [x, -y] for x, y in reversed(polygon)] for polygon in polygons]
    return polygons + images


def with_vertex(polygons, point):
    """The polygons with a vertex at a point of their sides: names change there, at a crack's tip for example."""
    p = np.array(point, dtype=float)
    out = []
    for polygon in polygons:
        sides = zip(polygon, polygon[1:] + polygon[:1])
        made = []
        for a, b in sides:
            made.append(a)
            if inside_side(np.array(a), np.array(b), p):
                made.append(list(point))
        out.append(made)
    return out


def inside_side(a, b, p):
    along, to = b - a, p - a
    length = np.hypot(*along)
    off = abs(along[0] * to[1] - along[1] * to[0]) / length
    return off < 1e-9 * length and 1e-6 < along @ to / length**2 < 1 - 1e-6
