"""Laws of interfaces as classes of Python, for trying: slow, since each evaluation at each point calls Python.

    @ddapath.register_law("straight")
    class Straight(ddapath.SofteningCurve):
        "Linear softening down to a stress-free crack."

        def value(self, omega):
            return max(1 - omega / 2, 0.0)
        ...

A deck of `ddapath.follow` in the same process then says `law: {type: straight, tensile_strength: 3, fracture_energy: 0.1}`.
What is good is worth a plugin in C++ (docs/manual/plugins.md), which has the same functions.
"""

import json
import math

from . import deck as decks
from .compiled import core
from .declared import Declaring, registered

class SofteningCurve(Declaring):
    """A softening curve: traction over strength, g, against ω = w ft/Gf, w the physical opening. No units.

        g(0) = 1,   ∫₀^∞ g dω = 1,   g never rises

    A subclass gives the functions below; mixed mode, friction, unloading, contact, energy and the tangent are those of all
    softening laws. A deck gives it the keys of `linear_softening` (tensile_strength, fracture_energy, ...) and the Numbers
    that the class declares, which are attributes of the object:

        class Kinked(ddapath.SofteningCurve):
            kink = ddapath.Number(at_least=0.1, at_most=1, fallback=0.3, text="Traction at the kink over the strength.")

    `at_trial_opening` and `at_same_compliance` have general solutions here, by bisection, which a subclass may replace.
    """

    is_curve = True

    def value(self, omega):
        """g(ω)."""
        raise NotImplementedError(f"{type(self).__name__}.value(omega) is to give the curve g(ω)")

    def slope(self, omega):
        """dg/dω, at a corner that on its right."""
        raise NotImplementedError(f"{type(self).__name__}.slope(omega) is to give dg/dω")

    def steepest(self):
        """max |dg/dω|."""
        raise NotImplementedError(f"{type(self).__name__}.steepest() is to give the largest |dg/dω|")

    def end(self):
        """ω at which the traction has vanished; math.inf when it never does."""
        return math.inf

    def next_corner(self, omega):
        """Where beyond ω the slope jumps next; math.inf when it never does."""
        return self.end() if omega < self.end() else math.inf

    def spent(self, omega):
        """Share of Gf that is spent for good at ω, unloading to the origin: ∫₀^ω g − ½ ω g(ω)."""
        raise NotImplementedError(f"{type(self).__name__}.spent(omega) is to give ∫₀^ω g − ½ ω g(ω)")

    def at_trial_opening(self, opening, scale, kappa0):
        """ω ≥ 0 with scale ω + kappa0 g(ω) = opening; the left side rises with ω."""
        if opening <= kappa0:
            return 0.0
        return bisected(lambda omega: scale * omega + kappa0 * self.value(omega) - opening, opening / scale)

    def at_same_compliance(self, omega, ratio):
        """ω' with ω'/g(ω') = ratio ω/g(ω)."""
        end = self.end()
        if omega >= end:
            return omega
        wanted = ratio * omega / self.value(omega)
        high = end if math.isfinite(end) else max(omega, wanted)
        return bisected(lambda other: other - wanted * self.value(other), high)


def bisected(rising, high):
    """Where a rising function is 0 between 0 and `high`, to the last digit."""
    low = 0.0
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return high
        if rising(middle) < 0:
            low = middle
        else:
            high = middle


class InterfaceLaw(Declaring):
    """What an interface does with the trial opening q = (q_n, q_s) of its two sides [L], q_n > 0 opens.

        t = law(q; h)      traction (t_n, t_s)                      [F/L²]
        D = ∂t/∂q          tangent, 2 × 2                           [F/L³]
        intact: t = k (q_n, β² q_s), β the shear weight

    k is the trial stiffness of the point [F/L³], h its history at the last accepted step: h.loading (it stands on its damage
    surface, and the path leaves it by loading), h.sliding, h.share, h.dissipated [F/L], and h[0], h[1], ... (ten numbers at
    most), which are the law's own and zero at first; `memory` names them, (name, power of length) each. h is never changed: `accept`
    gives a copy. A law is "rigid until strength, then ..." in series with the trial spring; its physical opening is
    w = q − t/k. Functions are pure: the same arguments, the same answer.

    This class is a law of scalar damage without friction: κ = max(h[0], q_eq), q_eq = √(⟨q_n⟩² + β² q_s²),

        t_n = r ⟨q_n⟩ − k ⟨−q_n⟩,   t_s = β² r q_s,   r = t_eq(κ)/κ,   ψ = ½ r (⟨q_n⟩² + β² q_s²) + ½ k ⟨−q_n⟩²

    A subclass gives `strength`, `secant`, `secant_slope`, `spent`, `rupture_kappa` and `steepest_slope`, or whatever else of
    it is to be another.
    """

    memory = (("kappa", 1),)
    ON_SURFACE = 1e-10  # share of κ within which a point stands on its surface
    ROUND_OFF = 1e-11

    def strength(self):
        """ft [F/L²]."""
        raise NotImplementedError(f"{type(self).__name__}.strength() is to give ft")

    def secant(self, kappa, k):
        """r beyond initiation, κ > ft/k [F/L³]."""
        raise NotImplementedError(f"{type(self).__name__}.secant(kappa, k) is to give t_eq/κ")

    def secant_slope(self, kappa, k):
        """dr/dκ [F/L⁴]."""
        raise NotImplementedError(f"{type(self).__name__}.secant_slope(kappa, k) is to give dr/dκ")

    def spent(self, kappa, k):
        """Energy per area spent up to κ, and its derivative with respect to κ [F/L, F/L²]."""
        raise NotImplementedError(f"{type(self).__name__}.spent(kappa, k) is to give energy and its derivative")

    def rupture_kappa(self, k):
        """κ at which the traction has vanished [L]; math.inf when that is nowhere."""
        raise NotImplementedError(f"{type(self).__name__}.rupture_kappa(k) is to give κ of rupture")

    def steepest_slope(self):
        """Largest slope −dt/dw of the softening branch [F/L³]; k is chosen above it."""
        raise NotImplementedError(f"{type(self).__name__}.steepest_slope() is to give the largest −dt/dw")

    def shear_weight(self):
        """β."""
        return 1.0

    def initial_kappa(self, k):
        """κ at which an intact point reaches its strength [L]."""
        return self.strength() / k

    def kappa(self, h, k):
        """κ of a history, at least that of initiation [L]."""
        return max(h[0], self.initial_kappa(k))

    def next_corner(self, h, k):
        """κ of the next corner of the curve beyond the history's [L]."""
        return self.rupture_kappa(k)

    def intact_bound(self, h, k):
        """√(⟨q_n⟩² + β² q_s²) below which a point that has spent nothing need not be asked [L]; 0: always ask."""
        return 0.0 if self.kappa(h, k) > self.initial_kappa(k) else self.initial_kappa(k)

    def equivalent_opening(self, qn, qs, h, k):
        """q_eq, to be compared with κ [L]."""
        return math.hypot(max(qn, 0.0), self.shear_weight() * qs)

    def opening_gradient(self, qn, qs, h, k):
        """∂q_eq/∂q, two numbers."""
        opening = self.equivalent_opening(qn, qs, h, k)
        return (max(qn, 0.0) / opening, self.shear_weight()**2 * qs / opening) if opening > 0 else (0.0, 0.0)

    def secant_at(self, kappa, k):
        """r, before initiation k."""
        return self.secant(kappa, k) if kappa > self.initial_kappa(k) else k

    def is_loading(self, opening, kappa, flag):
        """On its surface a point loads where the path has chosen so."""
        return opening >= kappa * (1 - self.ON_SURFACE) if flag else opening > kappa * (1 + self.ROUND_OFF)

    def _response(self, qn, qs, kappa, k):
        r, beta2 = self.secant_at(kappa, k), self.shear_weight()**2
        normal = k if qn < 0 else r
        return (normal * qn, beta2 * r * qs), ((normal, 0.0), (0.0, beta2 * r))

    def respond(self, qn, qs, h, k):
        """Traction and consistent tangent at q: ((t_n, t_s), ((D_nn, D_ns), (D_sn, D_ss)))."""
        reached, opening = self.kappa(h, k), self.equivalent_opening(qn, qs, h, k)
        kappa = max(reached, opening)
        traction, ((nn, ns), (sn, ss)) = self._response(qn, qs, kappa, k)
        if not self.is_loading(opening, reached, h.loading):
            return traction, ((nn, ns), (sn, ss))
        slope, (gn, gs) = self.secant_slope(kappa, k), self.opening_gradient(qn, qs, h, k)
        n, s = slope * max(qn, 0.0), slope * self.shear_weight()**2 * qs
        return traction, ((nn + n * gn, ns + n * gs), (sn + s * gn, ss + s * gs))

    def respond_frozen(self, qn, qs, h, k):
        """The same with the damage of h."""
        return self._response(qn, qs, self.kappa(h, k), k)

    def spending(self, qn, qs, h, k):
        """Energy per area that accepting q would add to h.dissipated, and its gradient: (value, (∂/∂q_n, ∂/∂q_s))."""
        reached, opening = self.kappa(h, k), self.equivalent_opening(qn, qs, h, k)
        now = max(reached, opening)
        value = self.spent(now, k)[0] - self.spent(reached, k)[0] if now > reached else 0.0
        if not self.is_loading(opening, reached, h.loading):
            return value, (0.0, 0.0)
        rate, (gn, gs) = self.spent(now, k)[1], self.opening_gradient(qn, qs, h, k)
        return value, (rate * gn, rate * gs)

    def accept(self, qn, qs, h, k):
        """The history after q has been accepted, a copy of h with what is new."""
        reached, opening = self.kappa(h, k), self.equivalent_opening(qn, qs, h, k)
        out = h.copy()
        out.dissipated += self.spending(qn, qs, h, k)[0]
        out.loading = opening >= reached * (1 - self.ON_SURFACE)
        if opening > reached:
            out[0] = opening
        return out

    def stored(self, qn, qs, h, k):
        """ψ(q; h), energy per area stored in the trial spring [F/L]."""
        r = self.secant_at(max(self.kappa(h, k), self.equivalent_opening(qn, qs, h, k)), k)
        return 0.5 * ((k if qn < 0 else r) * qn * qn + r * self.shear_weight()**2 * qs * qs)

    def damage(self, h, k):
        """Lost share of the secant stiffness, 0 intact to 1 released."""
        return 1 - self.secant_at(self.kappa(h, k), k) / k

    def grown(self, h, k, factor):
        """The history with κ grown by a factor, for sequentially linear steps."""
        out = h.copy()
        reached = self.kappa(h, k)
        out[0] = min(factor * reached, self.rupture_kappa(k))
        out.dissipated += self.spent(out[0], k)[0] - self.spent(reached, k)[0]
        return out

    def piece(self, qn, qs, h, k):
        """Which smooth piece of the law q lies on, a small whole number; 0 for the intact one."""
        reached, opening = self.kappa(h, k), self.equivalent_opening(qn, qs, h, k)
        damaged = reached > self.initial_kappa(k)
        return (1 if opening > reached else 0) + (2 if damaged and qn < 0 else 0) + (4 if opening >= self.rupture_kappa(k) else 0)


def respond(law, openings, stiffness):
    """What a law, as a deck has it, answers to a sequence of trial openings, each accepted before the next.

        w = numpy.linspace(0, 0.05, 100)
        tractions, damage, dissipated = ddapath.respond({"type": "linear_softening", "tensile_strength": 3,
                                                         "fracture_energy": 0.05}, numpy.column_stack([w, 0 * w]), 1e5)

    law: a name or a dictionary. openings: n × 2, (q_n, q_s) [L]. stiffness: k of the point [F/L³].
    Gives tractions, n × 2 [F/L²], damage, n, and the energy dissipated so far, n [F/L]. Throws InputError for a wrong law.
    """
    return core().respond_along(json.dumps(decks.plain(law)), openings, stiffness)


def register_law(name):
    """Decorator of a SofteningCurve or an InterfaceLaw: decks of this process may say `law: {type: name, ...}` from then on.

    Under the same name a class with the same parameters replaces the earlier one, in paths that begin later. Throws TypeError
    for another class, ValueError for a name of the program's and for other parameters under the same name.
    """
    return registered(core().register_law, name, SofteningCurve, InterfaceLaw)
