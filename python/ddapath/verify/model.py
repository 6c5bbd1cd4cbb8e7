"""What a run's equilibrium is checked with: blocks, points, loads and springs, from fields/mesh.h5 and the deck alone.

Per block d = (u0, v0, r0, εx, εy, γxy) about the centroid, u(x) = T(x) d; per point a trial opening q in (n, s).
Nodes are the blocks, behind them the strain gradients of blocks of second order (second_order.py) and, where cracks cut
blocks, the jumps of cuts.py.
"""
import copy
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import NothingStored
from ..fields import read_mesh, text_of
from . import cuts, laws, second_order

GAUSS, GAUSS_3 = 0.5 / np.sqrt(3.0), 0.5 * np.sqrt(0.6)
RULES = {"gauss": (0.5 - GAUSS, 0.5 + GAUSS), "gauss_3": (0.5 - GAUSS_3, 0.5, 0.5 + GAUSS_3), "vertices": (0.0, 1.0),
         "midpoint": (0.5,)}
WEIGHTS = {"gauss": (1 / 2, 1 / 2), "gauss_3": (5 / 18, 8 / 18, 5 / 18), "vertices": (1 / 2, 1 / 2), "midpoint": (1.0,)}
WITH_MULTIPLIERS = ("lagrange", "augmented_lagrangian")


def displacement_rows(x, y):
    """T of places (x, y) about the centroids, n × 2 × 6."""
    one, zero = np.ones_like(x), np.zeros_like(x)
    return np.stack([np.stack([one, zero, -y, x, zero, y / 2], -1), np.stack([zero, one, x, zero, y, x / 2], -1)], 1)


def elastic_stiffness(material, plane):
    """C of a material of the deck [F/L²]."""
    e, nu = material["young_modulus"], material["poisson_ratio"]
    if plane == "strain":
        e, nu = e / (1 - nu**2), nu / (1 - nu)
    return e / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])


def trace_constants(mesh, stiffness):
    """c = max over σ of ∮|σn|² ds / (A σ:C⁻¹:σ) of every block [F/L³]."""
    following = mesh.fans[2]
    edge = mesh.vertices[following] - mesh.vertices
    length = np.hypot(edge[:, 0], edge[:, 1])
    nx, ny, zero = edge[:, 1] / length, -edge[:, 0] / length, np.zeros(len(edge))
    rows = np.stack([np.stack([nx, zero, ny], -1), np.stack([zero, ny, nx], -1)], 1)
    parts = length[:, None, None] * np.einsum("eia,eib->eab", rows, rows)
    sums = np.add.reduceat(parts, mesh.offsets[:-1]) / mesh.areas[:, None, None]
    root = np.linalg.cholesky(stiffness)
    return np.linalg.eigvalsh(np.einsum("bki,bkl,blj->bij", root, sums, root))[:, -1]


@dataclass(frozen=True)
class Interface:
    """How the sides of one name are joined."""
    name: str
    law: object
    treatment: str
    points: str
    second_order_points: str
    perturbation: float
    energy_exponent: float

    @property
    def is_active(self):
        return self.law.can_crack or self.treatment == "augmented_lagrangian"


def perturbation_of(kind, given, is_separate):
    """δ of a joint's multipliers, t = (1 + δ) P m; bodies that only touch have their own."""
    if kind == "lagrange":
        return given.get("contact_perturbation", 1e-3) if is_separate else given.get("perturbation", 1e-7)
    if kind == "augmented_lagrangian" and is_separate:
        return given.get("factor", 1000.0) / given.get("contact_factor", 1e4)
    return 0.0


def interface_of(name, deck):
    entry = deck["interfaces"][name]
    treatment = entry["treatment"]
    kind = treatment if isinstance(treatment, str) else treatment["type"]
    given = {} if isinstance(treatment, str) else treatment
    law = laws.make(entry["law"])
    has_multipliers, given_points = kind in WITH_MULTIPLIERS, entry.get("points")
    points = {"gauss_2": "gauss"}.get(given_points, given_points) or ("vertices" if has_multipliers else "gauss")
    second_order_points = "gauss_3" if (given_points or ("gauss_2" if has_multipliers else "gauss")) == "gauss" else "gauss"
    field = entry.get("field") or {}
    return Interface(name, law, kind, points, second_order_points, perturbation_of(kind, given, law.is_separate),
                     field.get("energy_exponent", 2.0))


BOND = Interface("", laws.make({"type": "bonded"}), "consistent", "gauss", "gauss_3", 0.0, 2.0)


class Tables:
    """The group /model of fields/mesh.h5."""

    def __init__(self, group):
        self._group = group

    def __getitem__(self, name):
        values = self._group[name][()]
        return [text_of(value) for value in values] if values.dtype.kind in "OS" else values

    def rows(self, name, width):
        return self[name].reshape(-1, width) if name in self._group else None


class Model:
    """Geometry, stiffness, points, loads and springs of a run; `jumps` is empty as long as no block is cut."""

    def __init__(self, file, deck):
        if "model" not in file:
            raise NothingStored(f"{file.filename}: has no /model; this run was written by a version before `dda verify`")
        self.deck, self.mesh, self.thickness, self._last = deck, read_mesh(file), deck["thickness"], None
        tables = Tables(file["model"])
        self._set_stages(tables)
        self._set_blocks(tables)
        self._set_sides(tables)
        self._set_loads(tables)
        self._set_springs(tables)

    def at(self, fields):
        """With the blocks as cracks have cut them at a step; steps between which no crack grows share it."""
        if not len(fields.cut.cuts):
            return self
        if self._last is None or not fields.cut.equals(self._last[0]):
            self._last = fields.cut, self._cut(fields.cut)
        return self._last[1]

    def _cut(self, cut):
        out = copy.copy(self)
        out.jumps = cuts.Jumps(self, cut)
        out.sides = cuts.pieces_of_sides(self, cut)
        out.points = Points(out)
        nodes = list(out.jumps.node_of_cut)
        none = np.zeros((len(cut.cuts), 3))  # of a stage that came once the step was stored
        out.loads = {part: np.concatenate([force, np.pad(cut.forces.get(part, none)[nodes], ((0, 0), (0, 3)))])
                     for part, force in self.loads.items()}
        felt = cut.spring_parts
        node = np.array([out.jumps.node_of_cut[number] for number in felt["cut"]], dtype=int)
        out.springs = self.springs | {
            "spring": np.concatenate([self.springs["spring"], felt["spring"]]),
            "block": np.concatenate([self.springs["block"], node]),
            "row": np.concatenate([self.springs["row"], np.pad(felt["row"], ((0, 0), (0, 3)))])}
        return out

    def _set_stages(self, tables):
        """Numbers of the stages that are followed, where these are several, and the tables of each."""
        numbers = tables.rows("followed_stages", 1)
        self.stages = [] if numbers is None else [int(number) for number in numbers[:, 0]]
        self.references = ["reference", *(f"reference_{number}" for number in self.stages[1:])]

    def load_factors(self, fields):
        """Of every stage that is followed: those before are held, those to come are 0, as are those that came once it was stored."""
        if not self.stages:
            return np.array([fields.load_factor])
        first, *others = self.stages
        known = fields.numbers
        return np.array([known.get(f"load_factor_{first}", fields.load_factor), *(known.get(f"load_factor_{number}", 0.0) for number in others)])

    def _set_blocks(self, tables):
        materials = [self.deck["materials"][name] for name in tables["region_materials"]]
        each = np.array([elastic_stiffness(material, self.deck["plane"]) for material in materials])
        self.stiffness = each[self.mesh.region]
        self.volumes = self.mesh.areas * self.thickness
        self.centroids = self.mesh.means(self.mesh.vertices)
        self.moduli = np.array([material["young_modulus"] for material in materials])[self.mesh.region]
        self.largest_modulus = max(material["young_modulus"] for material in materials)
        self.weak_stiffness = self.deck["weak_springs"] * self.largest_modulus * self.thickness
        numbers = tables.rows("second_order/block", 1)
        self.gradients = second_order.Gradients(self, np.zeros(0, dtype=int) if numbers is None else numbers[:, 0].astype(int))
        parts = ("dead", *self.references)
        none = np.zeros((self.mesh.num_blocks, 3))
        self.stress = [none if found is None else found for found in (tables.rows(f"initial_stress/{part}", 3) for part in parts)]
        self.stress_gradients = [self.gradients.of_slopes(tables.rows(f"initial_stress_slopes/{part}", 6)) for part in parts]

    def _set_sides(self, tables):
        self.interfaces = [interface_of(name, self.deck) for name in tables["interface_names"]] + [BOND]
        self.sides = {"blocks": tables.rows("side/blocks", 2).astype(int), "ends": tables.rows("side/ends", 4),
                      "stiffness": tables["side/stiffness"], "interface": tables["side/interface"].astype(int)}
        ends = self.sides["ends"]
        self.sides |= {"edge": ends[:, 2:] - ends[:, :2], "is_through": np.zeros(len(ends), dtype=bool)}
        self.jumps = ()
        self.points = Points(self)

    def _set_loads(self, tables):
        self.loads = {}
        blocks = tables["load/block"].astype(int)
        for part in ("dead", *self.references):
            force = np.zeros((self.num_block_nodes, 6))
            force[blocks] = tables.rows(f"load/{part}", 6)
            self.loads[part] = force

    def _set_springs(self, tables):
        self.springs = {name: tables[f"spring/{name}"] for name in ("stiffness", "names", "dead", *self.references)}
        self.springs |= {"spring": tables["spring_part/spring"].astype(int), "block": tables["spring_part/block"].astype(int),
                         "row": tables.rows("spring_part/row", 6)}
        for name in ("added", "removed"):  # by stages: spring, followed stage
            rows = tables.rows(f"spring/{name}", 2)
            self.springs[name] = np.zeros((0, 2), dtype=int) if rows is None else rows.astype(int)

    @property
    def num_block_nodes(self):
        """Of blocks and strain gradients."""
        return self.mesh.num_blocks + len(self.gradients)

    def rule_of(self, side):
        """Shares of the points of a side, and their weights."""
        interface = self.interfaces[self.sides["interface"][side]]
        name = interface.second_order_points if self.gradients.is_second_order[self.sides["blocks"][side]].any() else interface.points
        return RULES[name], WEIGHTS[name]

    @cached_property
    def size(self):
        """Diagonal of the structure [L]."""
        return float(np.hypot(*np.ptp(self.mesh.vertices, axis=0)))

    @cached_property
    def traces(self):
        """c of every block [F/L³], whatever cuts it."""
        return self.gradients.traces(trace_constants(self.mesh, self.stiffness))

    def forces(self, load_factors):
        """External forces on d without those of springs and initial stress, nodes × 6."""
        return self.loads["dead"] + sum(factor * self.loads[name] for factor, name in zip(load_factors, self.references))

    def initial_stress(self, load_factors):
        return self.stress[0] + sum(factor * stress for factor, stress in zip(load_factors, self.stress[1:]))

    def initial_gradients(self, load_factors):
        """Gradients of strain that would make the slopes of the initial stress, gradients × 6."""
        first, *others = self.stress_gradients
        return first + sum(factor * of for factor, of in zip(load_factors, others))

    def far_ends(self, load_factors):
        """δ of every support and driven point [L]."""
        return self.springs["dead"] + sum(factor * self.springs[name] for factor, name in zip(load_factors, self.references))


class Points:
    """All points of all sides, side after side; the active ones are those whose tractions are stored, in that order.

    Of a cut through a block both sides are the block, whose own motion does not open it: `jumps` are (point, node, rows) of
    the jumps by which either face moves beside its block.
    """

    def __init__(self, model):
        sides = model.sides
        rules = [model.rule_of(side) for side in range(len(sides["interface"]))]
        counts = np.array([len(shares) for shares, _ in rules], dtype=int)
        self.side = np.repeat(np.arange(len(counts)), counts)
        self.interface = sides["interface"][self.side]
        share, weight = (np.concatenate([rule[i] for rule in rules]) if rules else np.zeros(0) for i in (0, 1))
        start, end = sides["ends"][self.side, :2], sides["ends"][self.side, 2:]
        length = np.hypot(*(end - start).T)
        self.place = start + share[:, None] * (end - start)
        edge = sides["edge"][self.side]
        self.normal = np.stack([edge[:, 1], -edge[:, 0]], -1) / np.hypot(edge[:, 0], edge[:, 1])[:, None]
        self.tangent = np.stack([-self.normal[:, 1], self.normal[:, 0]], -1)
        self.blocks = sides["blocks"][self.side]
        self.is_through = sides["is_through"][self.side]
        self.is_mirror = (self.blocks[:, 0] == self.blocks[:, 1]) & ~self.is_through  # on a plane of symmetry
        self.weight = length * model.thickness * weight / np.where(self.is_mirror, 2, 1)
        self._set_laws(model)
        self._set_rows(model)
        self._set_gradients(model)
        self._set_jumps(model)

    def _set_laws(self, model):
        of = [model.interfaces[i] for i in range(len(model.interfaces))]
        beta = np.array([interface.law.shear_weight for interface in of])[self.interface]
        k = model.sides["stiffness"][self.side]
        self.trial = np.stack([k, k * beta**2], -1)
        self.active = np.array([interface.is_active for interface in of], dtype=bool)[self.interface]
        self.kind = np.array([interface.treatment for interface in of])[self.interface]
        first, second = model.moduli[self.blocks].T
        apart = model.centroids[self.blocks[:, 1]] - model.centroids[self.blocks[:, 0]]
        distance = np.where(self.is_through, np.sqrt(model.mesh.areas[self.blocks[:, 0]]), np.hypot(apart[:, 0], apart[:, 1]))
        off_plane = np.einsum("pi,pi->p", self.normal, self.place - model.centroids[self.blocks[:, 0]])
        distance = np.where(self.is_mirror, 2 * np.abs(off_plane), distance)
        self.spring_unit = 2 * first * second / (first + second) / distance
        self.perturbation = np.array([interface.perturbation for interface in of])[self.interface]

    def _set_rows(self, model):
        """Rows of the jump and, for consistent joints, of the mean traction: [first, second], each n × 2 × 6."""
        frame = np.stack([self.normal, self.tangent], 1)
        n, s = self.normal, self.tangent
        traction = np.stack([np.stack([n[:, 0]**2, n[:, 1]**2, 2 * n[:, 0] * n[:, 1]], -1),
                             np.stack([s[:, 0] * n[:, 0], s[:, 1] * n[:, 1], s[:, 0] * n[:, 1] + s[:, 1] * n[:, 0]], -1)], 1)
        trace = model.traces[self.blocks]
        shares = np.where((self.kind == "consistent")[:, None], trace[:, ::-1] / trace.sum(axis=1, keepdims=True), 0.0)
        shares[self.is_through] = 1, 0
        self.jump_rows, self.stress_rows = [], []
        for side, sign in ((0, -1.0), (1, 1.0)):
            offset = self.place - model.centroids[self.blocks[:, side]]
            rows = sign * frame @ displacement_rows(offset[:, 0], offset[:, 1])
            self.jump_rows.append(np.where(self.is_through[:, None, None], 0, rows))
            self.stress_rows.append(shares[:, side, None, None] * traction)
        # Of a mirror image the displacement along n and the traction along s are turned round.
        self.jump_rows[1][self.is_mirror, 0] *= -1
        self.stress_rows[1][self.is_mirror, 1] *= -1

    def _set_gradients(self, model):
        """(point, node, rows of the jump, rows of the mean traction) by the strain gradients of either side's block."""
        frame, out = np.stack([self.normal, self.tangent], 1), [[], [], [], []]
        for side, sign in ((0, -1.0), (1, 1.0)):
            block = self.blocks[:, side]
            points = np.flatnonzero(model.gradients.is_second_order[block])
            points = points[~self.is_through[points] | (side == 0)]
            block = block[points]
            x, y = (self.place[points] - model.centroids[block]).T
            size = np.sqrt(model.mesh.areas[block])
            jump = sign * frame[points] @ second_order.displacement_rows(x, y, size)
            jump[self.is_mirror[points] & (side == 1), 0] *= -1
            jump[self.is_through[points]] = 0
            stress = self.stress_rows[side][points] @ model.stiffness[block] @ second_order.strain_rows(x, y, size)
            for to, values in zip(out, (points, model.gradients.node_of[block], jump, stress)):
                to.append(values)
        self.gradients = [np.concatenate(values) for values in out]

    def _set_jumps(self, model):
        jumps, point, node, rows = model.jumps, [], [], []
        is_cut = np.isin(model.sides["blocks"], list(jumps.parts_of)).any(axis=1) if jumps else np.zeros(0, dtype=bool)
        first = np.searchsorted(self.side, np.arange(len(is_cut)))
        for s in np.flatnonzero(is_cut):
            moved = jumps.along(model.sides["blocks"][s], model.sides["ends"][s].reshape(2, 2), self.normal[first[s]],
                                model.rule_of(s))
            for p, found in enumerate(moved, start=first[s]):
                for of, opens in found:
                    point.append(p)
                    node.append(of)
                    rows.append(opens)
        self.jumps = np.array(point, dtype=int), np.array(node, dtype=int), np.array(rows).reshape(-1, 2, 6)
