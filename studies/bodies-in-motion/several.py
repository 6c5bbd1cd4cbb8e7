"""A chart and an arch: what stands and what does not."""

import math

from scenes import box, inclined, scene

# b/h, inclination, angle of friction [degrees]; a hair off the lines tan α = b/h, α = φ and tan φ = b/h.
CHART = ((0.5, 20, 30), (0.5, 26.3, 40), (0.5, 26.9, 40), (0.5, 30, 25), (0.5, 30, 40), (0.5, 26.2, 26.8), (1.0, 35, 36),
         (1.0, 37, 36), (0.3, 16.4, 40), (0.3, 17.0, 40), (2.0, 50, 30), (0.3, 45, 30))


def behaviour(ratio, degrees, friction):
    """By statics: it slides where α > φ; it turns about its lower corner where tan α > b/h and friction, tan φ > b/h, holds
    its foot well enough."""
    slope, held = math.tan(math.radians(degrees)), math.tan(math.radians(friction))
    slides = slope > held
    topples = min(slope, held) > ratio
    return {(False, False): "stands", (True, False): "slides", (False, True): "topples"}.get((slides, topples), "both")


def chart(run, cases=CHART):
    """(b/h, α, φ, what statics says, what the program says) of each block."""
    rows = []
    for ratio, degrees, friction in cases:
        deck = scene({"ground": box(-5, -1, 20, 0), "block": box(0, 0, ratio, 1)}, inclined(degrees),
                     math.tan(math.radians(friction)),
                     {"foot": ((0, 0), (1, 0)), "heel": ((0, 0), (0, 1))}, time=1.5, stop_at_rest=False)
        last = run(f"chart-{ratio}-{degrees}-{friction}", deck).motion.curve
        slid, lifted = last.foot.iloc[-1] > 2e-3, last.heel.max() > 2e-3
        found = {(False, False): "stands", (True, False): "slides"}.get((slid, lifted), "topples")
        exact = behaviour(ratio, degrees, friction)
        rows.append({"b/h": ratio, "inclination": degrees, "friction angle": friction, "statics": exact, "found": found,
                     "agree": found == exact or (exact == "both" and found == "topples")})
    return rows


def arch(voussoirs, thickness):
    """A semicircular arch of mean radius 1 with radial joints, on ground that stands still: name → vertices."""
    inner, outer = 1 - thickness / 2, 1 + thickness / 2
    at = [(math.cos(math.pi * i / voussoirs), math.sin(math.pi * i / voussoirs)) for i in range(voussoirs + 1)]
    at[0], at[-1] = (1, 0), (-1, 0)
    bodies = {"ground": box(-1.5, -0.5, 1.5, 0)}
    for i in range(voussoirs):
        (c, s), (d, t) = at[i], at[i + 1]
        bodies[f"stone {i + 1}"] = [[inner * c, inner * s], [outer * c, outer * s], [outer * d, outer * t],
                                    [inner * d, inner * t]]
    return bodies


def let_go(run, voussoirs, thickness, time=4):
    """The run of an arch for some time [s]; its gauge is how far the crown has come down."""
    crown = (0, 1 - thickness / 2)
    deck = scene(arch(voussoirs, thickness), friction=10, gauges={"crown": (crown, (0, -1))}, time=time)
    return run(f"arch-{thickness:.5f}", deck)


def stands(run, voussoirs, thickness):
    """Whether the crown has come down by less than a hundredth of the radius."""
    return let_go(run, voussoirs, thickness).motion.curve.crown.iloc[-1] < 0.01


def least_thickness(run, voussoirs=26, low=0.09, high=0.13, precise=3e-4):
    while high - low > precise:
        middle = (low + high) / 2
        if stands(run, voussoirs, middle):
            high = middle
        else:
            low = middle
    return (low + high) / 2

