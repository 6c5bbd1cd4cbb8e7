"""Arches and walls of blocks as polygons (name → corners), and decks of them: m, N, s; stone, 1 m thick."""

import math

GRAVITY = 9.81
STONE = {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2, "density": 2500}


def box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


def semicircular_arch(stones, thickness):
    """Of mean radius 1 with radial joints, between two held imposts."""
    inner, outer = 1 - thickness / 2, 1 + thickness / 2
    at = [(math.cos(math.pi * i / stones), math.sin(math.pi * i / stones)) for i in range(stones + 1)]
    at[0], at[-1] = (1, 0), (-1, 0)
    blocks = {"right impost": box(inner - 0.1, -0.2, outer + 0.1, 0), "left impost": box(-outer - 0.1, -0.2, 0.1 - inner, 0)}
    for i, ((c, s), (d, t)) in enumerate(zip(at, at[1:])):
        blocks[f"stone {i + 1}"] = [[inner * c, inner * s], [outer * c, outer * s], [outer * d, outer * t],
                                    [inner * d, inner * t]]
    return blocks


def flat_arch(stones, span, depth, centre):
    """A jack arch over an opening, y = 0 its soffit, whose joints point to a place so far below the soffit's middle."""
    low = [span * (i / stones - 0.5) for i in range(stones + 1)]
    high = [x * (centre + depth) / centre for x in low]
    return {f"stone {i + 1}": [[low[i], 0], [low[i + 1], 0], [high[i + 1], depth], [high[i], depth]] for i in range(stones)}


def between_abutments(arch, span, depth, centre):
    """The flat arch and two held abutments with its skewbacks."""
    low, high = span / 2, span / 2 * (centre + depth) / centre
    return arch | {"right abutment": [[low, 0], [high + 0.3, 0], [high + 0.3, depth], [high, depth]],
                   "left abutment": [[-high - 0.3, 0], [-low, 0], [-high, depth], [-high - 0.3, depth]]}


def between_buttresses(arch, span, depth, centre, breadth=0.5, height=0.3):
    """The flat arch between two buttresses that rest on the ground, their heads its skewbacks."""
    low, high = span / 2, span / 2 * (centre + depth) / centre
    outer = high + breadth
    return arch | {"right buttress": [[low, -height], [outer, -height], [outer, depth], [high, depth], [low, 0]],
                   "left buttress": [[-outer, -height], [-low, -height], [-low, 0], [-high, depth], [-outer, depth]],
                   "ground": box(-2 * span, -height - 0.2, 2 * span, -height)}


def deck(title, blocks, held, friction, **motion):
    """Blocks that touch with a coefficient of friction; gauges: name → (place, direction)."""
    gauges, pairs = motion.pop("gauges", {}), motion.pop("beds", {})
    material = motion.pop("materials", lambda name: "ground" if name in held else "stone")
    angle = math.degrees(math.atan(friction))
    interfaces = {"joints": {"between": ["stone", "stone"], "law": {"type": "friction", "friction_angle": angle}},
                  "beds": {"between": ["stone", "ground"], "law": {"type": "friction", "friction_angle": angle}}} | pairs
    used = {material(name) for name in blocks} | {"stone", "ground"}
    return {"title": title, "units": {"length": "m", "force": "N"},
            "scene": {"regions": [{"name": name, "material": material(name), "vertices": corners}
                                  for name, corners in blocks.items()]},
            "thickness": 1, "materials": {name: dict(STONE) for name in sorted(used)}, "interfaces": interfaces,
            "gauges": {name: {"type": "displacement", "at": list(at), "direction": list(direction)}
                       for name, (at, direction) in gauges.items()},
            "motion": {"gravity": [0, -GRAVITY], "held": list(held), "contact": {"friction": friction}} | motion}
