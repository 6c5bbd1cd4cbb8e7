"""Random structures, a deck from a seed: shapes, meshes, materials, laws, treatments, contacts, loads, programmes.

`structure(seed)` is the same for the same seed wherever it is asked for. Structures are small: some hundred blocks.
"""
import random

from contact_scenes import STEEL, rectangle, region
from random_laws import joint

MESHES = ("triangles", "quads", "voronoi", "given")
TREATMENTS = ("consistent", "penalty", "lagrange", "augmented_lagrangian")


def round3(value):
    """Three digits, so that a deck reads well."""
    return float(f"{value:.3g}")


class Maker:
    """Draws the parts of one structure."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.treatment = self.random.choice(TREATMENTS)
        self.mesh = self.random.choice(MESHES)
        self.depth = round3(self.random.uniform(60, 200))
        self.shape = self.random.choice((self.beam, self.cantilever, self.corbel, self.panel, self.wall, self.l_shape, self.plated))
        if not is_suited(self) and self.random.random() < 0.75:
            self.mesh = "triangles"

    def of(self, *choices):
        return self.random.choice(choices)

    def between(self, low, high):
        return round3(self.random.uniform(low, high))

    def material(self):
        return {"type": "linear_elastic", "young_modulus": self.between(5000, 50000), "poisson_ratio": self.of(0.0, 0.15, 0.2, 0.3)}

    def subdivision(self, columns=6):
        """`given` is a grid of blocks: the regions themselves would be too few to be a structure."""
        if self.mesh == "given":
            return {"type": "grid", "columns": columns, "rows": self.random.randint(2, 4), "shape": self.of("quads", "triangles")}
        return {"type": self.mesh, "size": round3(self.depth / self.random.uniform(3.5, 6))}

    def cracks_everywhere(self):
        return {"body": {"between": ["body", "body"], **joint(self, self.treatment)}}

    def along(self, curve, name="ligament"):
        return {name: joint(self, self.treatment)}, {name: curve}

    def beam(self):
        """Simply supported, notched or not, cracking along a ligament or everywhere."""
        d, span = self.depth, round3(self.depth * self.random.uniform(2, 4))
        notch = round3(d * self.random.uniform(0.1, 0.5))
        scene = {"regions": [region("left", "body", rectangle(0, 0, span / 2, d)), region("right", "body", rectangle(span / 2, 0, span, d))]}
        if self.of(True, False):
            interfaces, scene["curves"] = self.along([[span / 2, notch], [span / 2, d]])
        else:
            interfaces = self.cracks_everywhere()
        scene["slits"] = {"notch": [[span / 2, 0], [span / 2, notch]]}
        supports = {"left": {"at": [0, 0], "fix": "xy"}, "right": {"at": [span, 0], "fix": "y"}}
        return scene, interfaces, supports, ([span / 2, d], [0, -1])

    def cantilever(self):
        d, span = self.depth, round3(self.depth * self.random.uniform(1.5, 3))
        scene = {"regions": [region("arm", "body", rectangle(0, 0, span, d))], "boundaries": {"wall": [[0, 0], [0, d]]}}
        return scene, self.cracks_everywhere(), {"wall": {"boundary": "wall", "fix": "xy"}}, ([span, d], [0, -1])

    def corbel(self):
        """A bracket on a column; a weak joint between them."""
        d = self.depth
        out = round3(d * self.random.uniform(0.6, 1.2))
        scene = {"regions": [region("column", "body", rectangle(-d, -d, 0, 2 * d)), region("bracket", "other", rectangle(0, 0, out, d))],
                 "boundaries": {"foot": [[-d, -d], [0, -d]], "top": [[-d, 2 * d], [0, 2 * d]]}}
        interfaces = {"joint": {"between": ["body", "other"], **joint(self, self.treatment)}}
        return scene, interfaces, {"foot": {"boundary": "foot", "fix": "xy"}, "top": {"boundary": "top", "fix": "x"}}, ([out, d], [0, -1])

    def panel(self):
        """A block sheared along a joint that is pressed first."""
        d = self.depth
        scene = {"regions": [region("lower", "body", rectangle(0, 0, 2 * d, d / 2)), region("upper", "other", rectangle(0, d / 2, 2 * d, d))],
                 "boundaries": {"foot": [[0, 0], [2 * d, 0]], "head": [[0, d], [2 * d, d]]}}
        interfaces = {"joint": {"between": ["body", "other"], **joint(self, self.treatment)}}
        self.dead = [{"type": "edge_traction", "boundary": "head", "traction": [0, -self.between(0.1, 2)]}]
        return scene, interfaces, {"foot": {"boundary": "foot", "fix": "xy"}}, ([0, d / 2 + d / 4], [1, 0])

    def wall(self):
        """Courses of mortar or dry joints under a top load, pushed at the top."""
        d, courses, width = self.depth, self.random.randint(2, 4), round3(self.depth * self.random.uniform(1, 2))
        height = round3(d / courses)
        scene = {"regions": [region(f"course_{i}", ("body", "other")[i % 2], rectangle(0, i * height, width, (i + 1) * height))
                             for i in range(courses)],
                 "boundaries": {"foot": [[0, 0], [width, 0]], "head": [[0, courses * height], [width, courses * height]]}}
        interfaces = {"bed": {"between": ["body", "other"], **joint(self, self.treatment, dry=self.of(True, False))}}
        self.dead = [{"type": "edge_traction", "boundary": "head", "traction": [0, -self.between(0.2, 2)]}]
        return scene, interfaces, {"foot": {"boundary": "foot", "fix": "xy"}}, ([0, courses * height], [1, 0])

    def l_shape(self):
        d = self.depth
        scene = {"regions": [region("leg", "body", rectangle(0, 0, d, d)), region("corner", "body", rectangle(0, d, d, 2 * d)),
                             region("arm", "body", rectangle(d, d, 2 * d, 2 * d))],
                 "boundaries": {"foot": [[0, 0], [d, 0]]}}
        return scene, self.cracks_everywhere(), {"foot": {"boundary": "foot", "fix": "xy"}}, ([2 * d, 2 * d], [0, 1])

    def plated(self):
        """A beam of concrete with a steel plate that only rests on it, the load on the plate."""
        d, span = self.depth, round3(self.depth * self.random.uniform(2, 3.5))
        width, thick = round3(span / 8), round3(d / 10)
        scene = {"regions": [region("beam", "body", rectangle(0, 0, span, d)),
                             region("plate", "steel", rectangle(span / 2 - width / 2, d, span / 2 + width / 2, d + thick))]}
        interfaces = {"body": {"between": ["body", "body"], **joint(self, "consistent")},
                      "plate": {"between": ["steel", "body"], "treatment": self.treatment,
                                "law": {"type": "friction", "friction_angle": self.of(0, 5, 15, 30, 45)}}}
        supports = {"left": {"at": [0, 0], "fix": "xy"}, "right": {"at": [span, 0], "fix": "y"}}
        return scene, interfaces, supports, ([span / 2, d + thick], [0, -1])

    def stages(self, at, direction, scale):
        """Dead loads, the load itself (a force or a driven point), and sometimes unloading and loading again."""
        load = {"type": "point_load", "at": at, "force": [component * scale for component in direction]}
        if self.random.random() < 0.15:
            load = {"type": "prescribed_displacement", "at": at, "direction": direction, "displacement": 1.0}
        out = [{"name": "dead", "loads": self.dead}] if self.dead else []
        if not self.dead and self.random.random() < 0.2:
            out = [{"name": "weight", "loads": [{"type": "body_force", "force": [0, -2.4e-5]}]}]
        out.append({"name": "loading", "loads": [load]})
        if self.random.random() < 0.15:
            moved = round3(self.depth * 1e-4)
            out[-1]["until"] = {"deflection": moved}
            out += [{"name": "unloading", "until": {"deflection": moved / 2}, "unload": True}, {"name": "reloading"}]
        return out

    def make(self):
        self.dead = []
        scene, interfaces, supports, (at, direction) = self.shape()
        used = {entry["material"] for entry in scene["regions"]}
        materials = {name: STEEL if name == "steel" else self.material() for name in sorted(used)}
        deck = {"title": f"{self.shape.__name__}, {self.mesh}, {self.treatment}", "units": {"length": "mm", "force": "N"},
                "scene": {"type": "polygons", **scene, "subdivision": self.subdivision()}, "thickness": self.between(10, 200),
                "plane": self.of("stress", "strain"), "materials": materials, "interfaces": interfaces, "supports": supports,
                "stages": self.stages(at, direction, self.of(1e-3, 1, 1000)),
                "gauges": {"deflection": {"type": "displacement", "at": at, "direction": direction}},
                "path": {"stop": {"load_below": self.of(0.1, 0.3, 0.5), "gauges": {"deflection": round3(self.depth * 2e-3)}}}}
        return deck


def structure(seed):
    """A deck and what it is counted under."""
    maker = Maker(seed)
    return maker.make(), {"shape": maker.shape.__name__, "mesh": maker.mesh, "treatment": maker.treatment,
                          "suited": is_suited(maker)}


def is_suited(maker):
    """Whether the treatment is for this mesh: exact joints lock sub-blocks that are no triangles, and separate bodies
    whose corners do not meet along the joint (`dda check` says so)."""
    if maker.treatment in ("consistent", "penalty"):
        return True
    shape = maker.shape.__name__
    meets = maker.mesh == "quads" or (maker.mesh == "given" and shape in ("panel", "wall"))
    return maker.mesh == "triangles" or (meets and shape in ("corbel", "panel", "wall", "plated"))
