"""Blocks that cracks have cut: jumps are nodes behind the blocks and gradients, e = (e_x, e_y, ℓ r) of what lies right of a cut.

    J(x) = [1 0 −Y/ℓ; 0 1 X/ℓ],  (X, Y) from the middle of the cut,  ℓ² the area of its block
"""
import numpy as np


def distance_to(x, polygon):
    """Of a point from a polygon, 0 inside."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    edge = b - a
    along = np.clip(((x - a) * edge).sum(axis=1) / (edge**2).sum(axis=1), 0, 1)
    crosses = (a[:, 1] > x[1]) != (b[:, 1] > x[1])
    meets = a[:, 0] + (x[1] - a[:, 1]) * edge[:, 0] / np.where(crosses, edge[:, 1], 1)
    is_inside = np.count_nonzero(crosses & (meets > x[0])) % 2 == 1
    return 0.0 if is_inside else np.hypot(*(a + along[:, None] * edge - x).T).min()


class Jumps:
    """Those across the cuts through blocks at a step, numbered as nodes behind those of the blocks."""

    def __init__(self, model, cut):
        self.cut, self.first = cut, model.num_block_nodes
        through = cut.cuts[cut.cuts["side"] < 0]
        self.node_of_cut = {number: self.first + i for i, number in enumerate(through.index)}
        self.middle = (through[["start_x", "start_y"]].to_numpy() + through[["end_x", "end_y"]].to_numpy()) / 2
        self.length = np.sqrt(model.mesh.areas[through["block"]])
        self.block = through["block"].to_numpy()
        self.tolerance = tolerance_of(model)
        self.lines = through[["start_x", "start_y", "end_x", "end_y"]].to_numpy().reshape(-1, 2, 2)
        self.moves = [[] for _ in cut.block]
        for part, number in cut.moves:
            self.moves[part].append(self.node_of_cut[number])
        self.parts_of = {}
        for part, block in enumerate(cut.block):
            self.parts_of.setdefault(int(block), []).append(part)

    def __len__(self):
        return len(self.block)

    def rows(self, node, x):
        """J(x), 2 × 6 with nothing in the last three columns."""
        i = node - self.first
        out = np.zeros((2, 6))
        out[:, :2] = np.eye(2)
        out[:, 2] = (self.middle[i][1] - x[1]) / self.length[i], (x[0] - self.middle[i][0]) / self.length[i]
        return out

    def at(self, block, x):
        """Nodes of the jumps by which a block moves at one of its points, beside itself."""
        parts = self.parts_of.get(int(block), [])
        if not parts:
            return []
        outlines = self.cut.parts
        away = [distance_to(x, outlines.vertices[outlines.offsets[part]:outlines.offsets[part + 1]]) for part in parts]
        return self.moves[parts[int(np.argmin(away))]]

    def along(self, blocks, line, normal, rule):
        """By which jumps each point of a line opens, [(node, rows)] for each of its points, shares of its length.

        A jump along all of the line enters by its value at the point. Where a cut ends on the line it moves but a piece
        of it; then a point has what its share N of a traction that varies linearly along the line works on there,
        rows_i = 1/w_i ∫_piece N_i [n s]ᵀ J ds / L, with two Gauss points.
        """
        (start, end), shares = line, rule[0]
        ends = self.lines[np.isin(self.block, blocks)].reshape(-1, 2)
        at = stations(start, end, [x for x in ends if is_between(x, start, end, self.tolerance)], self.tolerance)
        frame = np.stack([normal, [-normal[1], normal[0]]])
        moved = {}
        for a, b in zip(at, at[1:]):
            for node, sign in self._across(blocks, (a + b) / 2, normal).items():
                moved.setdefault(node, []).append((a, b, sign))
        out = [[] for _ in shares]
        for node, pieces in moved.items():
            for i, share in enumerate(shares):
                if len(pieces) == len(at) - 1:
                    rows = pieces[0][2] * self.rows(node, start + share * (end - start))
                else:
                    rows = sum(sign * self._mean(node, (a, b), line, rule, i) for a, b, sign in pieces)
                out[i].append((node, frame @ rows))
        return out

    def _across(self, blocks, x, normal):
        """The jumps between what lies behind a place of a line, of the second block, and before it, with their signs."""
        off = 1e3 * self.tolerance * normal
        signs = {}
        for block, sign in zip(blocks, (-1, 1)):
            for node in self.at(block, x + sign * off):
                signs[node] = signs.get(node, 0) + sign
        return {node: sign for node, sign in signs.items() if sign}

    def _mean(self, node, piece, line, rule, i):
        (start, end), (a, b), (shares, weights) = line, piece, rule
        along = end - start
        out = np.zeros((2, 6))
        for gauss in (0.5 - 0.5 / np.sqrt(3), 0.5 + 0.5 / np.sqrt(3)):
            x = a + gauss * (b - a)
            xi = (x - start) @ along / (along @ along)
            weight = np.prod([(xi - other) / (shares[i] - other) for other in shares if other != shares[i]])
            out += weight * self.rows(node, x)
        return out / (2 * weights[i]) * np.hypot(*(b - a)) / np.hypot(*along)

    def unknowns(self, of_parts, centroids):
        """The motion of every cut block itself, 6 by block, and e of every jump, jumps × 6, from the motions of the parts about
        the centroids of their blocks. Where cuts are opposed no part need go with its block alone."""
        out, of_blocks = np.zeros((len(self), 6)), {}
        for block, parts in self.parts_of.items():
            own = [i for i in range(len(self)) if self.block[i] == block]
            system, right = np.zeros((3 * len(parts), 3 + 3 * len(own))), of_parts[parts, :3].ravel()
            for k, part in enumerate(parts):
                system[3 * k:3 * k + 3, :3] = np.eye(3)
                for j, i in enumerate(own, start=1):
                    if self.first + i not in self.moves[part]:
                        continue
                    here = self.rows(self.first + i, centroids[block])
                    system[3 * k:3 * k + 2, 3 * j:3 * j + 3] = here[:, :3]
                    system[3 * k + 2, 3 * j + 2] = 1 / self.length[i]
            found = np.linalg.lstsq(system, right, rcond=None)[0].reshape(-1, 3)
            of_blocks[block] = np.concatenate([found[0], of_parts[parts[0], 3:]])
            out[own, :3] = found[1:]
        return of_blocks, out


def tolerance_of(model):
    return 1e-9 * np.sqrt(np.sort(model.mesh.areas)[len(model.mesh.areas) // 2])


def is_between(x, start, end, tolerance):
    along = end - start
    share = np.clip((x - start) @ along / (along @ along), 0, 1)
    off = np.hypot(*(start + share * along - x))
    return off <= tolerance and np.hypot(*(x - start)) > tolerance and np.hypot(*(x - end)) > tolerance


def stations(start, end, marks, tolerance):
    """Ends of the pieces into which marks divide a line, in their order."""
    along = end - start
    out = []
    for x in sorted([start, *marks], key=lambda x: float(along @ (x - start))):
        if np.hypot(*(x - end)) > tolerance and (not out or np.hypot(*(x - out[-1])) > tolerance):
            out.append(x)
    return [*out, end]


def pieces_of_sides(model, cut):
    """The table of sides with those that cuts divide or open replaced by what is left of them, and the cuts behind it."""
    sides, cuts = model.sides, cut.cuts
    tolerance = tolerance_of(model)
    remembers = np.array([interface.is_active or interface.treatment == "lagrange" for interface in model.interfaces])
    starts, ends = cuts[["start_x", "start_y"]].to_numpy(), cuts[["end_x", "end_y"]].to_numpy()
    side_of, block_of = cuts["side"].to_numpy(), cuts["block"].to_numpy()
    touched = np.isin(sides["blocks"], block_of).any(axis=1) | np.isin(np.arange(len(sides["blocks"])), side_of)
    index, line = [], []
    for s, (x0, y0, x1, y1) in enumerate(sides["ends"]):
        start, end = np.array([x0, y0]), np.array([x1, y1])
        if not touched[s] or remembers[sides["interface"][s]]:
            index.append(s)
            line.append((start, end))
            continue
        near = np.isin(block_of, sides["blocks"][s]) | (side_of == s)
        marks = [x for x in [*starts[near], *ends[near]] if is_between(x, start, end, tolerance)]
        at = stations(start, end, marks, tolerance)
        for a, b in zip(at, at[1:]):
            opened = any(is_between((a + b) / 2, starts[c], ends[c], tolerance) for c in np.flatnonzero(side_of == s))
            if not opened:
                index.append(s)
                line.append((a, b))
    along = np.where(side_of >= 0, side_of, 0)
    blocks = np.where((side_of >= 0)[:, None], sides["blocks"][along], block_of[:, None])
    edge = np.where((side_of >= 0)[:, None], sides["edge"][along], ends - starts)
    return {"blocks": np.concatenate([sides["blocks"][index], blocks]),
            "ends": np.concatenate([np.array([[*a, *b] for a, b in line]).reshape(-1, 4), np.column_stack([starts, ends])]),
            "edge": np.concatenate([sides["edge"][index], edge]),
            "stiffness": np.concatenate([sides["stiffness"][index], cuts["stiffness"]]),
            "interface": np.concatenate([sides["interface"][index], cuts["interface"]]).astype(int),
            "is_through": np.concatenate([np.zeros(len(index), dtype=bool), side_of < 0])}
