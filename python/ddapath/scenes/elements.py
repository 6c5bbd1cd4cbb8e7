"""Scenes of finite-element meshes (Abaqus .inp, code_aster .med, .vtk, .vtu, .xdmf and all else that meshio reads): each element a block."""

import re
import tempfile
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..needed import from_debian
from .faults import SceneError

ENDINGS = (".inp", ".med", ".vtk", ".vtu", ".xdmf", ".xmf", ".bdf", ".nas", ".mesh", ".su2")
CORNERS = {"triangle": 3, "triangle6": 3, "triangle7": 3, "quad": 4, "quad8": 4, "quad9": 4, "line": 2, "line3": 2}
WITHOUT_NAME = "body"
PART = "#"  # between a name and the number of one of its parts


@dataclass(frozen=True)
class Elements:
    """What has been made of a mesh: the section `scene`, and what there is to name in a deck."""

    scene: dict
    blocks: int
    materials: list
    boundaries: list  # the lowest first
    interfaces: list


def scene_of_elements(file, mesh_file, scale=1.0):
    """Elements of a file, which are written to `mesh_file` (.msh, Gmsh 2.2).

    Triangles and quadrilaterals in the plane, of any order: blocks have their corners. Materials are the element sets, the
    smallest that has an element, or `body`; boundaries and interfaces the sets of line elements, or of nodes that have sides
    with both ends in them: a boundary where these are free, an interface where blocks lie on both sides. Free sides at the
    ends of the whole that belong to no set are `left`, `right`, `bottom` and `top`, all `outline` where there are none. `scale` is
    the length of a unit of the file.
    Throws SceneError where there is no such mesh, ModuleMissing without meshio.
    """
    meshio = from_debian("meshio", "python3-meshio")
    if not 0 < scale < float("inf"):
        raise SceneError(f"{file}: the length of a unit is above 0, not {scale:g}")
    if not Path(file).is_file():
        raise SceneError(f"{file}: there is no such file")
    try:
        mesh = read(meshio, Path(file))
    except SceneError:
        raise
    except (Exception, SystemExit) as error:  # each reader of meshio has its own, and some end the interpreter
        raise SceneError(f"{file}: meshio cannot read it: {error or type(error).__name__}") from None
    points = plane(file, mesh.points) * scale
    blocks = elements(file, mesh, points)
    groups = [("material", name, cells) for name, cells in materials(mesh, blocks).items()]
    groups += lines(mesh, blocks, points)
    write(meshio, points, groups, mesh_file)

    def names(kind):
        return [name for its, name, _ in groups if its == kind]

    height = {name: np.mean([points[node, 1] for side in members for node in side]) for _, name, members in groups}
    return Elements({"type": "msh", "file": Path(mesh_file).name}, len(blocks), names("material"),
                    sorted(names("boundary"), key=height.get), names("interface"))


def read(meshio, file):
    """The mesh. Of element sets that an Abaqus file names at several *ELEMENT meshio keeps the last: each is read by a name of its own."""
    if file.suffix.lower() != ".inp":
        return meshio.read(file)
    times = Counter()

    def numbered(found):
        times[found["name"].upper()] += 1
        return f"{found['before']}{found['name']}{PART}{times[found['name'].upper()]}"

    text = file.read_text(encoding="utf-8")
    if re.search(r"(?im)^\*INCLUDE\b", text):
        raise SceneError(f"{file}: *INCLUDE names another file: put the mesh into one")
    text = re.sub(r"(?im)^(?P<before>\*ELEMENT\b[^\n]*\bELSET\s*=\s*)(?P<name>[^,\s]+)", numbered, text)
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / file.name
        copy.write_text(text, encoding="utf-8")
        return meshio.read(copy)


def plane(file, points):
    """x and y of points that have one z."""
    size = np.ptp(points[:, :2], axis=0).max() if len(points) else 0
    if size == 0:
        raise SceneError(f"{file}: has no points in the plane of x and y")
    if points.shape[1] > 2 and np.ptp(points[:, 2]) > 1e-9 * size:
        raise SceneError(f"{file}: is not plane: z goes from {points[:, 2].min():g} to {points[:, 2].max():g}; blocks lie in the plane "
                         "of x and y")
    return points[:, :2]


def cells_of(mesh, dimension):
    """(place of the cell block, place in it, corners) of each element with so many dimensions."""
    for place, block in enumerate(mesh.cells):
        corners = CORNERS.get(block.type, 0)
        if (corners == 2) == (dimension == 1) and corners:
            yield from ((place, index, tuple(int(node) for node in cell[:corners])) for index, cell in enumerate(block.data))


def elements(file, mesh, points):
    """{(place of the cell block, place in it): corners, counter-clockwise}."""
    solid = next((block.type for block in mesh.cells if block.type not in CORNERS and block.type != "vertex"), None)
    if solid:
        raise SceneError(f"{file}: has elements of the type {solid}; blocks are made of triangles and quadrilaterals")
    found = {(place, index): cell if area(points[list(cell)]) > 0 else cell[::-1] for place, index, cell in cells_of(mesh, 2)}
    if not found:
        raise SceneError(f"{file}: has no triangles or quadrilaterals")
    return found


def area(corners):
    x, y = corners.T
    return (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2


def sets_of_cells(mesh):
    """{name: set of (place of the cell block, place in it)}, of Abaqus and of code_aster."""
    found = {}
    for name, by_block in mesh.cell_sets.items():
        found.setdefault(name.partition(PART)[0], set()).update(
            (place, int(index)) for place, indices in enumerate(by_block) if indices is not None for index in indices)
    families = getattr(mesh, "cell_tags", {})
    for place, tags in enumerate(mesh.cell_data.get("cell_tags", [])):
        for index, tag in enumerate(tags):
            for name in families.get(int(tag), []):
                found.setdefault(name, set()).add((place, index))
    return found


def sets_of_points(mesh):
    """{name: set of nodes}."""
    found = {name: {int(node) for node in nodes} for name, nodes in mesh.point_sets.items()}
    families = getattr(mesh, "point_tags", {})
    for node, tag in enumerate(mesh.point_data.get("point_tags", [])):
        for name in families.get(int(tag), []):
            found.setdefault(name, set()).add(node)
    return found


def materials(mesh, blocks):
    """{material: corners of its blocks}; that of a block is the smallest set that has it."""
    sets = sorted(((len(cells), name, cells) for name, cells in sets_of_cells(mesh).items()), key=lambda found: found[:2])
    found = {}
    for key, cell in blocks.items():
        name = next((name for _, name, cells in sets if key in cells), WITHOUT_NAME)
        found.setdefault(plain(name), []).append(cell)
    return found


def plain(name):
    """Without what has a meaning in the names of a mesh."""
    return name.strip().replace("/", "-").replace(":", "-")


def lines(mesh, blocks, points):
    """("boundary" or "interface", name, sides) of all sets of sides, each side in the first that has it."""
    count = Counter(side for cell in blocks.values() for side in sides_of(cell))
    taken, found = set(), []
    for name, sides in named_sides(mesh, count).items():
        for kind, blocks_beside in (("boundary", 1), ("interface", 2)):
            chosen = sorted(side for side in sides if count[side] == blocks_beside and side not in taken)
            if chosen and (kind == "boundary" or len(chosen) == len(sides)):
                found.append((kind, plain(name), chosen))
                taken.update(chosen)
                break
    names = {name for _, name, _ in found}
    free = [side for side, blocks_beside in count.items() if blocks_beside == 1 and side not in taken]
    for name, axis, end in (("left", 0, min), ("right", 0, max), ("bottom", 1, min), ("top", 1, max)):
        level = end(points[node, axis] for side in count for node in side)
        near = 1e-9 * np.ptp(points, axis=0).max()
        chosen = sorted(side for side in free if all(abs(points[node, axis] - level) <= near for node in side))
        if chosen and name not in names:
            found.append(("boundary", name, chosen))
    if all(kind != "boundary" for kind, _, _ in found):
        found.append(("boundary", "outline", sorted(free)))
    return found


def sides_of(cell):
    return [tuple(sorted(side)) for side in zip(cell, (*cell[1:], cell[0]))]


def named_sides(mesh, count):
    """{name: sides}: of line elements, and of nodes where they are not those of the whole."""
    found = {}
    of_lines = {(place, index): tuple(sorted(cell)) for place, index, cell in cells_of(mesh, 1)}
    for name, cells in sets_of_cells(mesh).items():
        if sides := {of_lines[key] for key in cells if key in of_lines} & set(count):
            found[name] = sides
    nodes_of_blocks = {node for side in count for node in side}
    for name, nodes in sets_of_points(mesh).items():
        if not nodes_of_blocks <= nodes and name not in found:
            if sides := {side for side in count if nodes.issuperset(side)}:
                found[name] = free_if_any(sides, count)
    return found


def free_if_any(sides, count):
    """Of nodes along a boundary also sides between blocks may have both ends in the set, across a corner."""
    return {side for side in sides if count[side] == 1} or sides


def write(meshio, points, groups, file):
    """Gmsh 2.2, which says by the name of a group what it is."""
    cells, physical, names = [], [], {}
    for number, (kind, name, members) in enumerate(groups, 1):
        dimension = 2 if kind == "material" else 1
        names[f"{kind}:{name}"] = np.array([number, dimension])
        for corners, cell_type in ((2, "line"), (3, "triangle"), (4, "quad")):
            if chosen := [cell for cell in members if len(cell) == corners]:
                cells.append((cell_type, np.array(chosen)))
                physical.append(np.full(len(chosen), number))
    used = np.unique(np.concatenate([block.ravel() for _, block in cells]))
    place = np.zeros(len(points), dtype=int)
    place[used] = np.arange(len(used))
    mesh = meshio.Mesh(np.column_stack([points[used], np.zeros(len(used))]), [(kind, place[block]) for kind, block in cells],
                       cell_data={"gmsh:physical": physical, "gmsh:geometrical": physical}, field_data=names)
    meshio.write(file, mesh, file_format="gmsh22", binary=False)
