"""What is run: beams with a straight crack and structures with curved ones, on patterns of blocks, at three sizes."""

from dataclasses import dataclass

SEEDS = (1, 2, 3)
ANGLES = (15, 30, 45)
PATTERNS = [f"Voronoi, seed {seed}" for seed in SEEDS] + ["quads"] + [f"squares, {angle}°" for angle in ANGLES] + ["triangles"]
FIVE = ["Voronoi, seed 1", "Voronoi, seed 2", "quads", "squares, 30°", "triangles"]
SIZES = {"coarse": 330, "middle": 1300, "fine": 5200}  # blocks


@dataclass(frozen=True)
class Structure:
    """A deck, the area that is divided, and where its path is measured: x at heights y, or y at places x."""

    name: str
    title: str
    area: float  # mm²
    depth: float  # mm, of the structure
    reference: float | None = None  # N, of the straight crack
    bias: float = 0.022  # allowed at the middle size
    across: str = "y"  # the coordinate along which the path is read
    stations: tuple = ()


BEAMS = [
    Structure("unnotched", "three-point bending, uncracked", 3e4, 100, 11676.0, 0.008),
    Structure("notched", "three-point bending, notch D/2", 4.1e4, 100, 1740.85),
    Structure("four-point", "four-point bending, Kitoh's beam", 4e4, 100, 14997.0),
    Structure("snap-back", "three-point bending, snap-back", 3.2e4, 100, 3412.4),
]
CURVED = [
    Structure("l-panel", "L-shaped panel", 187500, 250, across="x", stations=(200, 150, 100)),
    Structure("eccentric-notch", "eccentric notch, D = 80 mm", 2e4, 80, stations=(30, 50, 70)),
    Structure("shear-beam", "shear beam of Arrea and Ingraffea", 404532, 306, stations=(130, 180, 230)),
    Structure("double-notch", "double-edge notched plate", 40000, 200, across="x", stations=(60, 140)),
]
TRIANGLES_BIAS = 0.025


def subdivision(pattern, area, blocks):
    """Blocks of the same mean area whatever their form."""
    size = (area / blocks) ** 0.5
    kind, _, number = pattern.partition(", ")
    if kind == "Voronoi":
        return {"type": "voronoi", "size": size, "seed": int(number.split()[1])}
    if kind == "squares":
        return {"type": "squares", "size": size, "angle": int(number.rstrip("°"))}
    factor = {"quads": 1.12, "triangles": 1.54}[kind]  # sides of gmsh's elements that have this mean area
    return {"type": kind, "size": factor * size}


def allowed(structure, pattern):
    return max(structure.bias, TRIANGLES_BIAS) if pattern == "triangles" else structure.bias
