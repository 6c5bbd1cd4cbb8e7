"""The triangles of a run as an ASCII .msh file of version 2.2, so that a run can start from a mesh."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

import ddapath  # noqa: E402

LINE, TRIANGLE = 1, 2
ROUND_OFF = 1e-9  # of the beam


def nodes_of(vertices):
    """Places that differ, and for each vertex the number of its place, from 1."""
    keys = np.round(vertices / (ROUND_OFF * np.abs(vertices).max())).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return vertices[first], inverse.ravel() + 1


def edges_at(triangles, places, x):
    """Edges on the line of that x, each once."""
    found = set()
    for triangle in triangles:
        for a, b in zip(triangle, np.roll(triangle, -1)):
            if np.all(np.abs(places[[a - 1, b - 1], 0] - x) < ROUND_OFF * np.abs(places).max()):
                found.add((min(a, b), max(a, b)))
    return sorted(found)


def write(run, tip, file):
    """The notched beam of a run: slit on x = 0 up to y = tip, ligament above."""
    mesh = ddapath.read_run(run).fields().mesh
    places, numbers = nodes_of(mesh.vertices)
    triangles = numbers.reshape(-1, 3)
    lines = [(LINE, 1 if places[[a - 1, b - 1], 1].mean() > tip else 2, (a, b)) for a, b in edges_at(triangles, places, 0)]
    faces = [(TRIANGLE, 3 + region, tuple(triangle)) for region, triangle in zip(mesh.region, triangles)]
    out = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "4", '1 1 "interface:ligament"', '1 2 "slit:notch"',
           '2 3 "material:concrete/left"', '2 4 "material:concrete/right"', "$EndPhysicalNames", "$Nodes", str(len(places))]
    out += [f"{i} {x:.17g} {y:.17g} 0" for i, (x, y) in enumerate(places, 1)]
    out += ["$EndNodes", "$Elements", str(len(lines) + len(faces))]
    out += [f"{i} {kind} 2 {group} {group} {' '.join(map(str, nodes))}" for i, (kind, group, nodes) in enumerate(lines + faces, 1)]
    file.write_text("\n".join([*out, "$EndElements", ""]), encoding="utf-8")
