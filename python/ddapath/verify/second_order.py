"""Blocks of second order: the gradient of their strain is a node of its own behind the blocks.

    g = a (εx,x  εx,y  εy,x  εy,y  γ,x  γ,y),  a² the area;   u = T d + G g,   ε = E d + F g
"""
import numpy as np


def displacement_rows(x, y, size):
    """G of places (x, y) about the centroids, n × 2 × 6."""
    zero = np.zeros_like(x)
    xx, xy, yy = x * x / 2, x * y, y * y / 2
    rows = [np.stack([xx, xy, -yy, zero, zero, yy], -1), np.stack([zero, -xx, xy, yy, xx, zero], -1)]
    return np.stack(rows, 1) / size[:, None, None]


def strain_rows(x, y, size):
    """F, n × 3 × 6."""
    out = np.zeros((len(x), 3, 6))
    for i in range(3):
        out[:, i, 2 * i], out[:, i, 2 * i + 1] = x / size, y / size
    return out


def second_moments(mesh):
    """∫ X Xᵀ dA of every block about its centroid [L⁴]."""
    following = mesh.fans[2]
    of = np.repeat(np.arange(mesh.num_blocks), np.diff(mesh.offsets))
    about = mesh.means(mesh.vertices)[of]
    a, b = mesh.vertices - about, mesh.vertices[following] - about
    area = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
    outer = np.einsum("ni,nj->nij", a, a) + np.einsum("ni,nj->nij", b, b) + np.einsum("ni,nj->nij", a + b, a + b)
    return np.add.reduceat(area[:, None, None] / 12 * outer, mesh.offsets[:-1])


class Gradients:
    """The blocks of second order of a model, and their nodes."""

    def __init__(self, model, blocks):
        self.model, self.blocks = model, blocks
        self.is_second_order = np.zeros(model.mesh.num_blocks, dtype=bool)
        self.is_second_order[blocks] = True
        self.node_of = np.full(model.mesh.num_blocks, -1)
        self.node_of[blocks] = model.mesh.num_blocks + np.arange(len(blocks))
        moments, areas = second_moments(model.mesh)[blocks], model.mesh.areas[blocks]
        self.sizes = np.sqrt(areas)
        of_place = moments / areas[:, None, None]
        self.stiffness = model.thickness * np.einsum("bij,bkl->bikjl", model.stiffness[blocks], of_place).reshape(-1, 6, 6)

    def __len__(self):
        return len(self.blocks)

    def traces(self, of_constant_stress):
        """c of every block: max over linear σ of ∮|σn|² ds / ∫σ:C⁻¹:σ dA where it is of second order [F/L³]."""
        out = of_constant_stress.copy()
        mesh, following = self.model.mesh, self.model.mesh.fans[2]
        centroids = mesh.means(mesh.vertices)
        moments = second_moments(mesh)
        for block, size in zip(self.blocks, self.sizes):
            corners = np.arange(mesh.offsets[block], mesh.offsets[block + 1])
            boundary = np.zeros((9, 9))
            for start, end in zip(mesh.vertices[corners], mesh.vertices[following[corners]]):
                edge = end - start
                length = np.hypot(*edge)
                nx, ny = edge[1] / length, -edge[0] / length
                traction = np.array([[nx, 0, ny], [0, ny, nx]])
                middle, half = ((start + end) / 2 - centroids[block]) / size, edge / (2 * size)
                m, r = np.array([1, *middle]), np.array([0, *half])
                boundary += length * np.kron(traction.T @ traction, np.outer(m, m) + np.outer(r, r) / 3)
            of_place = np.zeros((3, 3))
            of_place[0, 0], of_place[1:, 1:] = mesh.areas[block], moments[block] / mesh.areas[block]
            root = np.linalg.inv(np.linalg.cholesky(np.kron(np.linalg.inv(self.model.stiffness[block]), of_place)))
            out[block] = np.linalg.eigvalsh(root @ boundary @ root.T)[-1]
        return out

    def of_slopes(self, slopes):
        """The g whose stresses have slopes a σ,x and a σ,y, gradients × 6; 0 where there are none."""
        if slopes is None:
            return np.zeros((len(self), 6))
        strains = np.linalg.solve(self.model.stiffness[self.blocks], slopes.reshape(-1, 2, 3).transpose(0, 2, 1))
        return strains.reshape(-1, 6)

    def unknowns(self, fields):
        """g of every block of second order, from the stored gradients."""
        columns = [f"strain_gradient_{of}" for of in ("xx_x", "xx_y", "yy_x", "yy_y", "2xy_x", "2xy_y")]
        if not len(self):
            return np.zeros((0, 6))
        return self.sizes[:, None] * fields.blocks[columns].to_numpy()[self.blocks]

    def moved(self, g, of, x, y):
        """G g of places about the centroids of the blocks `of`."""
        out = np.zeros((len(of), 2))
        chosen = np.flatnonzero(self.is_second_order[of])
        rows = displacement_rows(x[chosen], y[chosen], np.sqrt(self.model.mesh.areas[of[chosen]]))
        out[chosen] = np.einsum("nij,nj->ni", rows, g[self.node_of[of[chosen]] - self.model.mesh.num_blocks])
        return out
