"""One stored step, taken apart: unknowns, stresses, trial openings, tractions, forces on every block."""
from functools import cached_property

import numpy as np

from . import laws
from .model import displacement_rows

ROUND_OFF = 64 * np.finfo(float).eps


DISPLACEMENT, STRAIN = ["displacement_x", "displacement_y"], ["strain_xx", "strain_yy", "strain_2xy"]


def stretched(strain, x, y):
    """What strains alone make of places (x, y)."""
    return np.stack([strain[:, 0] * x + strain[:, 2] * y / 2, strain[:, 1] * y + strain[:, 2] * x / 2], -1)


def motions(mesh, moved, strain, about):
    """d of every polygon about the points given, from the displacement of its vertices and its strain."""
    centre, centroids = mesh.means(moved), mesh.means(mesh.vertices)
    of = np.repeat(np.arange(mesh.num_blocks), np.diff(mesh.offsets))
    x, y = (mesh.vertices - centroids[of]).T
    turned = moved - centre[of] - stretched(strain[of], x, y)
    lever = np.add.reduceat(x * turned[:, 1] - y * turned[:, 0], mesh.offsets[:-1])
    turn = lever / np.add.reduceat(x**2 + y**2, mesh.offsets[:-1])
    x, y = (about - centroids).T
    centre = centre + stretched(strain, x, y) + np.stack([-turn * y, turn * x], -1)
    return np.column_stack([centre, turn, strain])


def without_gradients(model, g, mesh, of, moved):
    """Displacements of the vertices of polygons that belong to the blocks `of`, without what strain gradients add."""
    of = np.repeat(of, np.diff(mesh.offsets))
    x, y = (mesh.vertices - model.centroids[of]).T
    return moved - model.gradients.moved(g, of, x, y)


def unknowns(model, fields):
    """d of every block, of one that is cut by how its parts move, g of every gradient, and e of every jump."""
    strain, g = fields.blocks[STRAIN].to_numpy(), model.gradients.unknowns(fields)
    moved = without_gradients(model, g, model.mesh, np.arange(model.mesh.num_blocks), fields.vertices[DISPLACEMENT].to_numpy())
    out = motions(model.mesh, moved, strain, model.centroids)
    if not len(fields.cut.block):
        return np.concatenate([out, g, np.zeros((len(model.jumps), 6))])
    block = fields.cut.block
    moved = without_gradients(model, g, fields.cut.parts, block, fields.part_vertices[DISPLACEMENT].to_numpy())
    of_parts = motions(fields.cut.parts, moved, strain[block], model.centroids[block])
    of_blocks, jumps = model.jumps.unknowns(of_parts, model.centroids)
    for b, motion in of_blocks.items():
        out[b] = motion
    return np.concatenate([out, g, jumps])


class Step:
    """Everything about a stored step that does not need another one. `releasing`: it is between two equilibria."""

    def __init__(self, model, fields, releasing=False):
        self.model, self.fields, self.releasing = model.at(fields), fields, releasing
        model = self.model
        self.number, self.load_factor = fields.step, fields.load_factor
        self.load_factors = model.load_factors(fields)
        self.d = unknowns(model, fields)
        self.strain = self.d[:model.mesh.num_blocks, 3:]
        self.stress = np.einsum("bij,bj->bi", model.stiffness, self.strain) + model.initial_stress(self.load_factors)
        self.stressed = self.d[model.mesh.num_blocks:model.num_block_nodes] + model.initial_gradients(self.load_factors)
        self._set_openings()
        self._set_tractions()

    def _of_blocks(self, rows, values):
        first, second = self.model.points.blocks.T
        return np.einsum("pij,pj->pi", rows[0], values[first]) + np.einsum("pij,pj->pi", rows[1], values[second])

    def _set_openings(self):
        points = self.model.points
        self.jump = self._of_blocks(points.jump_rows, self.d)
        point, node, rows = points.jumps
        np.add.at(self.jump, point, np.einsum("pij,pj->pi", rows, self.d[node]))
        self.mean = self._of_blocks(points.stress_rows, self.stress)
        point, node, rows, stress_rows = points.gradients
        np.add.at(self.jump, point, np.einsum("pij,pj->pi", rows, self.d[node]))
        np.add.at(self.mean, point, np.einsum("pij,pj->pi", stress_rows, self.stressed[node - self.model.mesh.num_blocks]))
        self.trial = self.jump + self.mean / points.trial

    def _set_tractions(self):
        """Stored ones, and P q of what cannot crack; unknown where a bond has multipliers of its own."""
        points = self.model.points
        self.traction = np.zeros_like(self.trial)
        self.damage, self.factor = np.zeros(len(self.trial)), np.ones(len(self.trial))
        self.water = np.zeros(len(self.trial))
        if points.active.any():
            self.traction[points.active] = self._stored("traction_n", "traction_s")
            self.damage[points.active] = self._stored("damage")[:, 0]
            for name, values in (("strength_factor", self.factor), ("water_pressure", self.water)):
                if any(name in table for table in (self.fields.points, self.fields.cracks)):
                    values[points.active] = self._stored(name)[:, 0]
        for number, interface in enumerate(self.model.interfaces):
            chosen = self.points_of(number) & ~points.active
            if interface.treatment == "lagrange":
                self.traction[chosen] = np.nan
            elif chosen.any():
                self.traction[chosen] = interface.law.traction(self.trial[chosen], points.trial[chosen])
        self._set_multipliers()

    def _stored(self, *columns):
        """Of the active points: those of sides, and behind them those of cuts."""
        tables = [table for table in (self.fields.points, self.fields.cracks) if len(table)]
        return np.concatenate([np.column_stack([table[column] for column in columns]) for table in tables])

    def _set_multipliers(self):
        """m of unknown multipliers is P⁻¹ t/(1 + δ); of iterated ones what the stored opening w = g + m − P⁻¹ t says."""
        points = self.model.points
        unknown, iterated = (self.model.points.kind == kind for kind in ("lagrange", "augmented_lagrangian"))
        carried, due = self.traction / points.trial, self.traction / points.trial / (1 + points.perturbation[:, None])
        self.multiplier = np.where(unknown[:, None], due, 0)
        if iterated.any():
            opening = np.zeros_like(carried)
            opening[points.active] = self._stored("opening_n", "opening_s")
            self.multiplier[iterated] = (opening + carried - self.jump)[iterated]
        self.gap = np.where(iterated[:, None], due - self.multiplier, 0)
        self.trial = self.trial + self.multiplier

    def points_of(self, number):
        """Mask of the points of an interface, by its place in `model.interfaces`."""
        last = len(self.model.interfaces) - 1
        return self.model.points.interface == (-1 if number == last else number)

    @property
    def borne(self):
        """Traction of the solid: water in a crack presses its faces apart [F/L²]."""
        return self.traction + self.water[:, None] * [1, 0]

    @property
    def seen(self):
        """Trial opening of which `borne` is the traction [L]."""
        return self.trial + self.water[:, None] / self.model.points.trial * [1, 0]

    def law_state(self, chosen, interface):
        return laws.State(self.model.points.trial[chosen, 0], self.damage[chosen], self.factor[chosen],
                          interface.energy_exponent, self.releasing)

    @cached_property
    def noise(self):
        """What rounding of the displacements may make of a point's traction [F/L²]."""
        largest = (self.moved + self.turned_about_origin)[self.model.points.blocks].max(axis=1)
        return ROUND_OFF * self.model.points.trial.max(axis=1) * largest

    def rounding_of_springs(self, moved):
        """What rounding of the displacements may make of every part of a spring [F], of nodes that move so far [L], what turns
        a block being worked out from displacements as well."""
        springs = self.model.springs
        row, d = np.abs(springs["row"]), np.abs(self.d[springs["block"]])
        size = np.ones(len(self.d))
        size[:self.model.mesh.num_blocks] = np.sqrt(self.model.mesh.areas)
        of = springs["block"]
        held = row[:, :2].sum(axis=1) * (moved + self.turned_about_origin)[of] + row[:, 2] / size[of] * moved[of]
        held += (row[:, 3:] * d[:, 3:]).sum(axis=1)
        return ROUND_OFF * springs["stiffness"][springs["spring"]] * held

    @cached_property
    def moved(self):
        """How far every node moves [L]."""
        return np.abs(self.d[:, :2]).max(axis=1, initial=0)

    @cached_property
    def turned_about_origin(self):
        """What turns and strains of blocks make of how far they are from the origin, to the last digits of which places are known [L]."""
        out, blocks = np.zeros(len(self.d)), self.model.mesh.num_blocks
        out[:blocks] = np.abs(self.d[:blocks, 2:]).max(axis=1) * np.abs(self.model.centroids).max(axis=1)
        return out

    @cached_property
    def spring_noise(self):
        """Of every part of a spring [F], where its force follows from the displacements that are stored."""
        return self.rounding_of_springs(self.moved)

    @cached_property
    def told_noise(self):
        """The same of every spring [F] where the program tells its force without displacements, from solutions that add up to
        them: each of these moves blocks as far as the structure moves somewhere, also where they cancel each other."""
        moved, blocks = self.moved.copy(), self.model.mesh.num_blocks
        moved[:blocks] = moved[:blocks].max()
        return np.bincount(self.model.springs["spring"], self.rounding_of_springs(moved), len(self.model.springs["stiffness"]))

    @cached_property
    def spring_forces(self):
        """r = p̄ (δ − l·u) of every support and driven point, on the structure along l."""
        springs = self.model.springs
        moved = np.einsum("ri,ri->r", springs["row"], self.d[springs["block"]])
        total = np.zeros(len(springs["stiffness"]))
        np.add.at(total, springs["spring"], moved)
        there = len(self.fields.rest)
        total[springs["added"][:there, 0]] -= self.fields.rest
        out = springs["stiffness"] * (self.model.far_ends(self.load_factors) - total)
        out[springs["added"][there:, 0]] = 0
        gone, stage = self.gone.T
        out[gone] = self.fields.borne * (1 - self.load_factors[stage])
        return out

    @property
    def forces_on_planes(self):
        """Blocks on planes of symmetry, and what the joint with their mirror image exerts on each of its points, n × 6."""
        points = self.model.points
        force = sum(np.einsum("pij,pi->pj", rows, self.traction) for rows in points.jump_rows)
        return points.blocks[points.is_mirror, 0], -(points.weight[:, None] * force)[points.is_mirror]

    @property
    def gone(self):
        """Springs that have been taken away, and in which of the followed stages: (1 − λ) of what they bore acts for them."""
        return self.model.springs["removed"][:len(self.fields.borne)]

    @cached_property
    def weak_forces(self):
        """Of the weak springs at the centroids, blocks × 3."""
        areas = self.model.mesh.areas
        return -self.model.weak_stiffness * np.column_stack([np.ones((len(areas), 2)), areas]) * self.d[:len(areas), :3]

    @property
    def weak_energy(self):
        return -0.5 * (self.weak_forces * self.d[:len(self.weak_forces), :3]).sum()

    def parts(self):
        """(nodes, forces on their d) of tractions, springs, loads, weak springs and stresses; they sum up to zero."""
        model, points = self.model, self.model.points
        for side in (0, 1):
            block = points.blocks[:, side]
            force = np.einsum("pij,pi->pj", points.jump_rows[side], self.traction)
            of_stress = np.einsum("pij,pi->pj", points.stress_rows[side], (self.traction - self.mean) / points.trial)
            force[:, 3:] += np.einsum("pij,pj->pi", model.stiffness[block], of_stress)
            yield block, -points.weight[:, None] * force
        point, node, rows, stress_rows = points.gradients
        of_stress = (self.traction - self.mean) / points.trial
        force = np.einsum("pij,pi->pj", rows, self.traction[point]) + np.einsum("pij,pi->pj", stress_rows, of_stress[point])
        yield node, -points.weight[point, None] * force
        of_gradients = np.arange(model.mesh.num_blocks, model.num_block_nodes)
        yield of_gradients, -np.einsum("bij,bj->bi", model.gradients.stiffness, self.stressed)
        point, node, rows = points.jumps
        yield node, -points.weight[point, None] * np.einsum("pij,pi->pj", rows, self.traction[point])
        springs = model.springs
        yield springs["block"], springs["row"] * self.spring_forces[springs["spring"], None]
        yield np.arange(len(self.d)), model.forces(self.load_factors)
        yield np.arange(model.mesh.num_blocks), np.column_stack([self.weak_forces, -model.volumes[:, None] * self.stress])

    def centre_rows(self):
        """T of the centroids about the origin: turns forces on d into a resultant force and moment."""
        return displacement_rows(self.model.centroids[:, 0], self.model.centroids[:, 1])
