"""What a point of an interface may carry, by law; arrays over points throughout, formulas of docs/theory/laws.md.

A law answers, for its damage and the strength factor f of a random field (strengths × f, fracture energies × f^n):

    excess(t, state)    how far tractions are outside their envelope, and the limit they are compared with [F/L²]
    normal(q_n, state)  the normal traction that the trial opening gives [F/L²]
    stored(t, q, state) the energy that the joint gives back [F/L]
"""
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class State:
    """Of points of one interface at one step: stiffness k, damage, strength factor f, exponent n, whether releasing."""
    stiffness: np.ndarray
    damage: np.ndarray
    factor: np.ndarray
    exponent: float
    releasing: bool

    @property
    def secant(self):
        return self.stiffness * (1 - self.damage)


def tangent(degrees):
    return np.tan(np.radians(degrees))


class Bonded:
    """A bond; also the base of what cannot crack: t = P q."""
    can_crack = False
    is_separate = False
    shear_weight = 1.0

    def traction(self, q, trial):
        return trial * q

    def excess(self, t, state):
        return np.full(len(t), -np.inf), np.ones(len(t))

    def normal(self, opening, state):
        return state.stiffness * opening

    def normal_error(self, t, opening, state):
        """How far normal tractions are from those that the trial opening allows."""
        return np.abs(t - self.normal(opening, state))

    def stored(self, t, q, state):
        return 0.5 * (t * q).sum(axis=1)


class Elastic(Bonded):
    """A layer of stiffness K in series with the trial spring."""

    def __init__(self, law):
        self.layer = np.array([law["normal_stiffness"], law["shear_stiffness"]])

    def traction(self, q, trial):
        return q / (1 / trial + 1 / self.layer)

    def normal(self, opening, state):
        return opening / (1 / state.stiffness + 1 / self.layer[0])


class Friction(Bonded):
    """Contact of separate bodies: t_n ≤ 0, |t_s| ≤ −t_n tan φ."""
    can_crack = True
    is_separate = True

    def __init__(self, law):
        self.slope = tangent(law.get("friction_angle", 0))

    def excess(self, t, state):
        carried = self.slope * np.maximum(-t[:, 0], 0)
        limit = np.where(t[:, 0] > 0, 0.0, carried)
        return np.maximum(t[:, 0], np.abs(t[:, 1]) - carried), limit

    def normal(self, opening, state):
        return state.stiffness * np.minimum(opening, 0)

    def stored(self, t, q, state):
        return 0.5 * (t**2).sum(axis=1) / state.stiffness


class MohrCoulomb(Friction):
    """Tension cut-off and Mohr-Coulomb, released at once: damage 0 intact, 0.5 after shear, 1 after tension.

    What is being released is elastic within limits that shrink from those of the bond to friction: until it is done the
    envelope of the bond holds. What is torn meanwhile carries any tension between none and that of a bond.
    """
    is_separate = False

    def __init__(self, law):
        self.strength, self.cohesion = law["tensile_strength"], law["cohesion"]
        self.bond = tangent(law.get("friction_angle", 0))
        residual = law.get("residual_friction_angle")
        self.slope = self.bond if residual is None else tangent(residual)

    def excess(self, t, state):
        intact = (state.damage < 0.25) | state.releasing
        strength = self.strength * state.factor
        tension = np.where(intact | (state.damage < 0.75), strength, 0.0)
        pressed = np.maximum(-t[:, 0], 0)
        shear = np.where(intact, self.cohesion * state.factor - self.bond * t[:, 0], self.slope * pressed)
        over = np.stack([t[:, 0] - tension, np.abs(t[:, 1]) - np.maximum(shear, 0)])
        worse = over[1] > over[0]
        return np.where(worse, over[1], over[0]), np.where(worse, shear, tension) + 0.01 * strength

    def normal(self, opening, state):
        keeps = state.damage < 0.75
        return state.stiffness * np.where(keeps, opening, np.minimum(opening, 0))

    def normal_error(self, t, opening, state):
        held = np.maximum(np.minimum(state.stiffness * opening, self.strength * state.factor), 0)
        torn = state.releasing & (state.damage >= 0.75) & (opening > 0)
        return np.where(torn, np.abs(t - np.clip(t, 0, held)), super().normal_error(t, opening, state))


class Linear:
    """g = 1 − ω/2."""

    def at_compliance(self, y):
        return np.where(np.isinf(y), 2.0, y / (1 + np.where(np.isinf(y), 0, y) / 2))

    def value(self, omega):
        return np.maximum(1 - omega / 2, 0)


class Bilinear:
    """Straight from (0, 1) over the knee to (end, 0)."""

    def __init__(self, law):
        self.stress = law.get("knee_stress", 1 / 3)
        self.knee = 2 * law.get("initial_share", 0.6) * (1 - self.stress)
        self.end = (2 - self.knee) / self.stress

    def at_compliance(self, y):
        finite = np.where(np.isinf(y), 0, y)
        first = finite / (1 + finite * (1 - self.stress) / self.knee)
        second = finite * self.stress * self.end / (self.end - self.knee + finite * self.stress)
        return np.where(np.isinf(y), self.end, np.where(first <= self.knee, first, second))

    def value(self, omega):
        return np.interp(omega, [0, self.knee, self.end], [1, self.stress, 0])


class Exponential:
    """g = exp(−ω): ω e^ω = y by Newton's method in ln ω."""

    def at_compliance(self, y):
        bounded = np.clip(y, 1e-300, 1e300)
        omega = np.where(bounded < 1, bounded, np.log1p(bounded))
        for _ in range(60):
            omega = omega * (1 + np.log(bounded / omega)) / (1 + omega)
        return np.where(y <= 0, 0.0, omega)

    def value(self, omega):
        return np.exp(-omega)


class Softening(Bonded):
    """Scalar damage with fracture energy, mixed mode and friction on closed cracks.

    The damage fixes the compliance of the crack, ω/g(ω) = ft (1/r − 1/k) ft/Gf(M), and that its traction ft g(ω):

        opened  √(t_n² + (t_s/β)²) ≤ ft g          closed  (|t_s| − tan φ |t_n|)/β ≤ ft g
    """
    can_crack = True

    def __init__(self, law, shape):
        self.shape, self.strength, self.energy = shape, law["tensile_strength"], law["fracture_energy"]
        self.shear_energy = law.get("shear_fracture_energy") or self.energy
        self.exponent = law.get("mixed_mode_exponent", 1)
        self.shear_weight = law["cohesion"] / self.strength if law.get("cohesion") else law.get("shear_weight", 1.0)
        self.slope = tangent(law.get("friction_angle", 0))

    def limit(self, mixity, state):
        """The equivalent traction that the damage leaves."""
        strength, energy = self.strength * state.factor, self.energy * state.factor**state.exponent
        ratio = 1 + (self.shear_energy / self.energy - 1) * mixity**self.exponent
        with np.errstate(divide="ignore"):
            softness = np.where(state.secant > 0, 1 / state.secant, np.inf) - 1 / state.stiffness
        y = np.maximum(strength**2 / (energy * ratio) * softness, 0)
        return strength * self.shape.value(self.shape.at_compliance(y))

    def excess(self, t, state):
        opened = t[:, 0] > 0
        shear = np.where(opened, np.abs(t[:, 1]), np.maximum(np.abs(t[:, 1]) + self.slope * t[:, 0], 0)) / self.shear_weight
        normal = np.maximum(t[:, 0], 0)
        carried = np.hypot(normal, shear)
        mixity = (shear / np.where(carried > 0, carried, 1)) ** 2  # of tractions next to nothing, too
        limit = self.limit(mixity, state)
        rubbing = np.where(opened, 0, -self.slope * t[:, 0])
        return carried - limit, limit + rubbing + 0.01 * self.strength * state.factor

    def normal(self, opening, state):
        return np.where(opening < 0, state.stiffness, state.secant) * opening

    def stored(self, t, q, state):
        beta2, k, r = self.shear_weight**2, state.stiffness, state.secant
        lost = k - r
        rubbing = np.where((q[:, 0] < 0) & (lost > 1e-9 * k), t[:, 1] - beta2 * r * q[:, 1], 0)
        held = 0.5 * rubbing**2 / np.where(lost > 0, beta2 * lost, 1)
        return 0.5 * (t[:, 0] * q[:, 0] + beta2 * r * q[:, 1]**2) + held


class OfPlugin(Bonded):
    """A law that this file does not know: what it gives is stored, and nothing is said about it."""
    can_crack = True

    def __init__(self, law):
        self.name = law["type"]
        strength, cohesion = law.get("tensile_strength"), law.get("cohesion")
        self.shear_weight = cohesion / strength if cohesion and strength else law.get("shear_weight", 1.0)


def make(law):
    """The law of an entry of a deck's `interfaces`."""
    law = {"type": law} if isinstance(law, str) else law
    shapes = {"linear_softening": Linear, "bilinear_softening": lambda: Bilinear(law), "exponential_softening": Exponential}
    if law["type"] in shapes:
        return Softening(law, shapes[law["type"]]())
    made = {"bonded": lambda _: Bonded(), "elastic": Elastic, "friction": Friction, "mohr_coulomb": MohrCoulomb}
    return made.get(law["type"], OfPlugin)(law)
