"""Outlines of blocks for pyvista and meshio, each imported when it is asked for: the package does without them."""

import numpy as np

from .needed import from_debian, needed


def in_space(vectors):
    """n × 2 with a zero z."""
    return np.column_stack([vectors, np.zeros(len(vectors))])


def polygons(offsets):
    """Numbers of the vertices of each outline."""
    return [np.arange(begin, end) for begin, end in zip(offsets[:-1], offsets[1:])]


def outlines_to_pyvista(outlines, fields=None):
    """pyvista.PolyData of the deformed outlines, a face per outline; `fields` are arrays per outline by name."""
    pyvista = needed("pyvista", "pip install pyvista")
    faces = np.concatenate([np.concatenate([[len(corners)], corners]) for corners in polygons(outlines["offsets"])])
    mesh = pyvista.PolyData(in_space(outlines["vertices"] + outlines["displacements"]), faces=faces)
    mesh.point_data["displacement"] = in_space(outlines["displacements"])
    for name, values in {"region": outlines["region"], **(fields or {})}.items():
        mesh.cell_data[name] = values
    return mesh


def outlines_to_meshio(outlines, fields=None):
    """meshio.Mesh of the undeformed outlines, with `displacement` at the points.

    Cells stand in blocks of one number of corners: triangles, quads, and polygons of 5, 6 ...; `fields` are arrays per
    outline by name.
    """
    meshio = from_debian("meshio", "python3-meshio")
    corners = polygons(outlines["offsets"])
    order = {}
    for number, outline in enumerate(corners):
        order.setdefault(len(outline), []).append(number)
    kinds = {3: "triangle", 4: "quad"}
    cells = [(kinds.get(size, "polygon"), np.array([corners[i] for i in numbers])) for size, numbers in order.items()]
    data = {name: [np.asarray(values)[numbers] for numbers in order.values()]
            for name, values in {"region": outlines["region"], **(fields or {})}.items()}
    return meshio.Mesh(in_space(outlines["vertices"]), cells, point_data={"displacement": in_space(outlines["displacements"])},
                       cell_data=data)


def outlines_of(fields):
    """Outlines of stored fields, of cut blocks part by part, as of `Point.outlines`, and which rows of `blocks` they have."""
    whole = np.setdiff1d(np.arange(fields.mesh.num_blocks), fields.cut.block)
    corners, moved, region = [], [], []
    tables = [(fields.mesh, fields.vertices, whole, fields.mesh.region[whole])]
    if len(fields.cut.block):
        tables.append((fields.cut.parts, fields.part_vertices, np.arange(len(fields.cut.block)), fields.cut.parts.region))
    for mesh, table, chosen, regions in tables:
        displacement = mesh.by_block(table[["displacement_x", "displacement_y"]].to_numpy())
        corners += [mesh.polygons[i] for i in chosen]
        moved += [displacement[i] for i in chosen]
        region.append(regions)
    outlines = {"vertices": np.concatenate(corners), "displacements": np.concatenate(moved),
                "offsets": np.concatenate([[0], np.cumsum([len(outline) for outline in corners])]),
                "region": np.concatenate(region)}
    return outlines, np.concatenate([whole, fields.cut.block]).astype(int)


def block_values(fields, rows):
    """Strain and stress of each outline, by name."""
    names = [name for name in fields.blocks if name.startswith(("strain_", "stress_"))]
    return {name: fields.blocks[name].to_numpy()[rows] for name in names}


def fields_to_pyvista(fields):
    outlines, rows = outlines_of(fields)
    return outlines_to_pyvista(outlines, block_values(fields, rows))


def fields_to_meshio(fields):
    outlines, rows = outlines_of(fields)
    return outlines_to_meshio(outlines, block_values(fields, rows))
