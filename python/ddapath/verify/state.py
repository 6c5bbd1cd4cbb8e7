"""One stored step, taken apart: unknowns, stresses, trial openings, tractions, forces on every block."""
from functools import cached_property

import numpy as np

from . import laws
from .model import displacement_rows

ROUND_OFF = 64 * np.finfo(float).eps


def unknowns(model, fields):
    """d of every block, from the displacement of its vertices and its strain."""
    moved = fields.vertices[["displacement_x", "displacement_y"]].to_numpy()
    strain = fields.blocks[["strain_xx", "strain_yy", "strain_2xy"]].to_numpy()
    centre = model.mesh.means(moved)
    of = np.repeat(np.arange(model.mesh.num_blocks), np.diff(model.mesh.offsets))
    x, y = (model.mesh.vertices - model.centroids[of]).T
    e = strain[of]
    turned = moved - centre[of] - np.stack([e[:, 0] * x + e[:, 2] * y / 2, e[:, 1] * y + e[:, 2] * x / 2], -1)
    lever = np.add.reduceat(x * turned[:, 1] - y * turned[:, 0], model.mesh.offsets[:-1])
    return np.column_stack([centre, lever / np.add.reduceat(x**2 + y**2, model.mesh.offsets[:-1]), strain])


class Step:
    """Everything about a stored step that does not need another one. `releasing`: it is between two equilibria."""

    def __init__(self, model, fields, releasing=False):
        self.model, self.fields, self.releasing = model, fields, releasing
        self.number, self.load_factor = fields.step, fields.load_factor
        self.d = unknowns(model, fields)
        self.stress = np.einsum("bij,bj->bi", model.stiffness, self.d[:, 3:]) + model.initial_stress(self.load_factor)
        self._set_openings()
        self._set_tractions()

    def _of_blocks(self, rows, values):
        first, second = self.model.points.blocks.T
        return np.einsum("pij,pj->pi", rows[0], values[first]) + np.einsum("pij,pj->pi", rows[1], values[second])

    def _set_openings(self):
        points = self.model.points
        self.jump = self._of_blocks(points.jump_rows, self.d)
        self.mean = self._of_blocks(points.stress_rows, self.stress)
        self.trial = self.jump + self.mean / points.trial

    def _set_tractions(self):
        """Stored ones, and P q of what cannot crack; unknown where a bond has multipliers of its own."""
        points = self.model.points
        self.traction = np.zeros_like(self.trial)
        self.damage, self.factor = np.zeros(len(self.trial)), np.ones(len(self.trial))
        if points.active.any():
            table = self.fields.points
            self.traction[points.active] = table[["traction_n", "traction_s"]].to_numpy()
            self.damage[points.active] = table["damage"]
            if "strength_factor" in table:
                self.factor[points.active] = table["strength_factor"]
        for number, interface in enumerate(self.model.interfaces):
            chosen = self.points_of(number) & ~points.active
            if interface.treatment == "lagrange":
                self.traction[chosen] = np.nan
            elif chosen.any():
                self.traction[chosen] = interface.law.traction(self.trial[chosen], points.trial[chosen])
        self._set_multipliers()

    def _set_multipliers(self):
        """m of unknown multipliers is P⁻¹ t/(1 + δ); of iterated ones what the stored opening w = g + m − P⁻¹ t says."""
        points = self.model.points
        unknown, iterated = (self.model.points.kind == kind for kind in ("lagrange", "augmented_lagrangian"))
        carried, due = self.traction / points.trial, self.traction / points.trial / (1 + points.perturbation[:, None])
        self.multiplier = np.where(unknown[:, None], due, 0)
        if iterated.any():
            opening = np.zeros_like(carried)
            opening[points.active] = self.fields.points[["opening_n", "opening_s"]].to_numpy()
            self.multiplier[iterated] = (opening + carried - self.jump)[iterated]
        self.gap = np.where(iterated[:, None], due - self.multiplier, 0)
        self.trial = self.trial + self.multiplier

    def points_of(self, number):
        """Mask of the points of an interface, by its place in `model.interfaces`."""
        last = len(self.model.interfaces) - 1
        return self.model.points.interface == (-1 if number == last else number)

    def law_state(self, chosen, interface):
        return laws.State(self.model.points.trial[chosen, 0], self.damage[chosen], self.factor[chosen],
                          interface.energy_exponent, self.releasing)

    @cached_property
    def noise(self):
        """What rounding of the displacements may make of a point's traction [F/L²]."""
        largest = np.abs(self.d[:, :2]).max(axis=1)[self.model.points.blocks].max(axis=1)
        return ROUND_OFF * self.model.points.trial.max(axis=1) * largest

    @cached_property
    def spring_noise(self):
        """The same of every part of a spring [F]."""
        springs = self.model.springs
        held = np.abs(springs["row"][:, :2]).sum(axis=1) * np.abs(self.d[springs["block"], :2]).max(axis=1, initial=0)
        return ROUND_OFF * springs["stiffness"][springs["spring"]] * held

    @cached_property
    def spring_forces(self):
        """r = p̄ (δ − l·u) of every support and driven point, on the structure along l."""
        springs = self.model.springs
        moved = np.einsum("ri,ri->r", springs["row"], self.d[springs["block"]])
        total = np.zeros(len(springs["stiffness"]))
        np.add.at(total, springs["spring"], moved)
        return springs["stiffness"] * (springs["dead"] + self.load_factor * springs["reference"] - total)

    @cached_property
    def weak_forces(self):
        """Of the weak springs at the centroids, blocks × 3."""
        scale = np.column_stack([np.ones((len(self.d), 2)), self.model.mesh.areas])
        return -self.model.weak_stiffness * scale * self.d[:, :3]

    @property
    def weak_energy(self):
        return -0.5 * (self.weak_forces * self.d[:, :3]).sum()

    def parts(self):
        """(blocks, forces on their d) of tractions, springs, loads, weak springs and stresses; they sum up to zero."""
        model, points = self.model, self.model.points
        for side in (0, 1):
            block = points.blocks[:, side]
            force = np.einsum("pij,pi->pj", points.jump_rows[side], self.traction)
            of_stress = np.einsum("pij,pi->pj", points.stress_rows[side], (self.traction - self.mean) / points.trial)
            force[:, 3:] += np.einsum("pij,pj->pi", model.stiffness[block], of_stress)
            yield block, -points.weight[:, None] * force
        springs = model.springs
        yield springs["block"], springs["row"] * self.spring_forces[springs["spring"], None]
        every = np.arange(model.mesh.num_blocks)
        yield every, model.forces(self.load_factor)
        yield every, np.column_stack([self.weak_forces, -model.volumes[:, None] * self.stress])

    def centre_rows(self):
        """T of the centroids about the origin: turns forces on d into a resultant force and moment."""
        return displacement_rows(self.model.centroids[:, 0], self.model.centroids[:, 1])
