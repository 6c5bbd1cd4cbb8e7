"""A deck to begin with, around a scene."""

import math

LENGTHS = {"m": 1.0, "cm": 0.01, "mm": 0.001}
FORCES = {"N": 1.0, "kN": 1e3, "MN": 1e6}
STONE = {"young_modulus": 1e10, "density": 2000.0}  # Pa, kg/m³
FRICTION_ANGLE = 31.0  # degrees, a coefficient of 0.6
GRAVITY = 9.81  # m/s²


def materials_of(scene):
    return list(dict.fromkeys(region["material"] for region in scene["regions"]))


def sides_of(scene):
    """{(a corner, the next): region} of all regions."""
    return {(tuple(start), tuple(end)): region for region in scene["regions"]
            for start, end in zip(region["vertices"], [*region["vertices"][1:], region["vertices"][0]])}


def part_of(region):
    """Of which a region is a piece: `stone 3` of `stone 3.1`."""
    stem, _, piece = region["name"].rpartition(".")
    return stem if stem and piece.isdigit() else region["name"]


def touching(scene):
    """Pairs of materials that touch, but for pieces of one part alone, in the order of the scene."""
    names, sides, found = materials_of(scene), sides_of(scene), set()
    for (start, end), region in sides.items():
        other = sides.get((end, start))
        if other and part_of(other) != part_of(region):
            found.add(tuple(sorted((region["material"], other["material"]), key=names.index)))
    return sorted(found, key=lambda pair: [names.index(name) for name in pair])


def at_the_bottom(scene):
    """Regions with a side on the lowest level of the scene, or at least a corner; none where these are all."""
    lowest = min(y for region in scene["regions"] for _, y in region["vertices"])
    touching = {region["name"]: sum(y == lowest for _, y in region["vertices"]) for region in scene["regions"]}
    found = [name for name, count in touching.items() if count >= min(2, max(touching.values()))]
    return found if len(found) < len(touching) else []


def is_on(point, line):
    """Whether a point lies on a polyline."""
    def reach(start, end):
        return math.dist(start, point) + math.dist(point, end) - math.dist(start, end)
    return any(reach(start, end) <= 1e-9 * math.dist(start, end) for start, end in zip(line, line[1:]))


def grounded(boundaries, ground):
    """Boundaries of which `ground` is the first, so that what it shares with others is its own; without those that lie on it."""
    others = {name: line for name, line in boundaries.items() if name != "ground" and not all(is_on(point, ground) for point in line)}
    return {"ground": ground, **others}


def foot_of(scene):
    """(held regions, supports, boundaries of the scene): the boundary `ground` where there is one; else the lowest regions, or, where
    these are all, their lowest sides.

    Throws ValueError where all regions stand on corners alone.
    """
    boundaries = scene.get("boundaries", {})
    supports = {"ground": {"boundary": "ground", "fix": "xy"}}
    if "ground" in boundaries:
        return [], supports, grounded(boundaries, boundaries["ground"])
    if held := at_the_bottom(scene):
        return held, {}, boundaries
    lowest = min(y for region in scene["regions"] for _, y in region["vertices"])
    ends = [x for side in sides_of(scene) if all(y == lowest for _, y in side) for x, _ in side]
    if not ends:
        raise ValueError("all blocks stand on corners alone and nothing holds them: draw a boundary `ground` or a block below them")
    return [], supports, grounded(boundaries, [[min(ends), lowest], [max(ends), lowest]])


def deck_to_begin_with(scene, units, title="Blocks from a picture or drawing"):
    """The deck of blocks that touch with dry friction and are let go under their weight, held at the boundary `ground` of the scene;
    without one the lowest of them are held, or their lowest sides where these are all.

    units: {"length": "m", "cm" or "mm", "force": "N", "kN" or "MN"}. All materials get the stiffness 10 GPa, Poisson's
    ratio 0.2 and the density 2000 kg/m³, all joints 31 degrees of friction, 1 as thickness: numbers to replace by one's own.
    Pieces of one part that has been cut, since blocks have no holes, stay bonded where no two parts of their material touch.
    Throws ValueError for other units, and where there is nothing to hold.
    """
    material, gravity = stone(units)
    held, supports, boundaries = foot_of(scene)
    if boundaries:
        scene = {**scene, "boundaries": boundaries}
    names = materials_of(scene)
    law = {"type": "friction", "friction_angle": FRICTION_ANGLE}
    joints = {f"{one} on {other}": {"between": [one, other], "law": dict(law)} for one, other in touching(scene)}
    joints |= {name: {"law": dict(law)} for name in scene.get("curves", {})}
    return {"title": title, "units": dict(units), "scene": scene, "thickness": 1,
            "materials": {name: dict(material) for name in names},
            **({"interfaces": joints} if joints else {}), **({"supports": supports} if supports else {}),
            "motion": {"gravity": [0, -gravity], "held": held, "contact": {"friction": 0.6}}}


def deck_of_elements(elements, units, title="Blocks from finite elements"):
    """The deck of bonded blocks that bear their weight, held along the lowest boundary, interfaces with dry friction; all materials
    and joints as above.

    elements: of `scenes.elements`. Throws ValueError for other units.
    """
    material, gravity = stone(units)
    weight = {"type": "body_force", "force": [0, -significant(material["density"] * gravity)]}
    law = {"type": "friction", "friction_angle": FRICTION_ANGLE}
    interfaces = {"interfaces": {name: {"law": dict(law)} for name in elements.interfaces}} if elements.interfaces else {}
    return {"title": title, "units": dict(units), "scene": elements.scene, "thickness": 1,
            "materials": {name: dict(material) for name in elements.materials}, **interfaces,
            "supports": {"foot": {"boundary": elements.boundaries[0], "fix": "xy"}},
            "stages": [{"name": "weight", "loads": [weight]}]}


def stone(units):
    """A material, and gravity, in these units."""
    if units["length"] not in LENGTHS or units["force"] not in FORCES:
        raise ValueError(f"units are {', '.join(LENGTHS)} and {', '.join(FORCES)}, not {units['length']} and {units['force']}")
    length, force = LENGTHS[units["length"]], FORCES[units["force"]]
    return ({"type": "linear_elastic", "young_modulus": significant(STONE["young_modulus"] * length**2 / force),
             "poisson_ratio": 0.2, "density": significant(STONE["density"] * length**4 / force)}, significant(GRAVITY / length))


def significant(value):
    """Without the last digits that multiplications leave."""
    return float(f"{value:.12g}")
