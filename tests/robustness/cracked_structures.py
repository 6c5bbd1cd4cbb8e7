"""Random structures through whose blocks one crack runs, a deck from a seed.

`cracked_structure(seed)` is the same for the same seed wherever it is asked for. The cohesive zone is several blocks long,
as `dda check` wants it.
"""
from contact_scenes import STEEL, rectangle, region
from random_laws import softening
from structures import Maker, round3

MESHES = ("triangles", "quads", "voronoi", "given")
PLATES = ("consistent", "penalty", "lagrange", "augmented_lagrangian")


class CrackedMaker(Maker):
    """Draws one structure and where its crack begins."""

    def __init__(self, seed):
        super().__init__(seed)
        self.treatment = "consistent"
        self.plate = self.random.choice(PLATES)
        self.mesh = self.random.choice(MESHES)
        self.size = round3(self.depth / self.random.uniform(8, 14))
        self.shape = self.random.choice((self.beam, self.eccentric, self.four_points, self.l_panel, self.holed, self.two_halves,
                                         self.plated))

    def subdivision(self, columns=6):
        if self.mesh == "given":
            return {"type": "grid", "columns": self.random.randint(10, 20), "rows": self.random.randint(9, 14),
                    "shape": self.of("quads", "triangles")}
        return {"type": self.mesh, "size": self.size}

    def concrete(self):
        """E, ν and a law whose zone E Gf/ft² is 4 blocks to 4 depths long."""
        self.elastic = self.material()
        law = softening(self, self.of("linear_softening", "linear_softening", "bilinear_softening", "exponential_softening"))
        length = self.between(max(4 * self.size, 0.3 * self.depth), 4 * self.depth)
        energy = law["fracture_energy"]
        law["fracture_energy"] = float(f"{length * law['tensile_strength'] ** 2 / self.elastic['young_modulus']:.4g}")
        if "shear_fracture_energy" in law:
            law["shear_fracture_energy"] = float(f"{law['fracture_energy'] * law['shear_fracture_energy'] / energy:.4g}")
        out = {"law": law}
        if self.random.random() < 0.2:
            out["field"] = {"coefficient_of_variation": self.of(0.05, 0.1), "correlation_length": round(self.depth / 4, 1),
                            "seed": self.random.randint(1, 1000)}
        return out

    def one_joint(self):
        return {"joints": {"between": ["body", "body"], **self.concrete()}}

    def held(self, span):
        return {"left": {"at": [0, 0], "fix": "xy"}, "right": {"at": [span, 0], "fix": "y"}}

    def beam(self):
        """Three points, notched or not."""
        d, span = self.depth, round3(self.depth * self.random.uniform(2.5, 4))
        notch = self.of(0, round3(d * self.random.uniform(0.1, 0.5)))
        scene = {"regions": [region("body", "body", rectangle(0, 0, span, d))]}
        if notch:
            scene["slits"] = {"notch": [[span / 2, 0], [span / 2, notch]]}
        askew = self.between(-0.2, 0.2)
        return scene, self.one_joint(), self.held(span), ([span / 2, d], [0, -1]), ([span / 2, notch], [askew, 1])

    def eccentric(self):
        """A notch beside the middle: the crack turns towards the load."""
        d, span = self.depth, round3(self.depth * self.random.uniform(2.5, 4))
        x, notch = round3(span * self.random.uniform(0.3, 0.45)), round3(d * self.random.uniform(0.2, 0.5))
        scene = {"regions": [region("body", "body", rectangle(0, 0, span, d))], "slits": {"notch": [[x, 0], [x, notch]]}}
        return scene, self.one_joint(), self.held(span), ([span / 2, d], [0, -1]), ([x, notch], [0, 1])

    def four_points(self):
        d, span = self.depth, round3(self.depth * self.random.uniform(3, 4))
        notch = round3(d * self.random.uniform(0.1, 0.4))
        scene = {"regions": [region("body", "body", rectangle(0, 0, span, d))],
                 "boundaries": {"head": [[round3(0.35 * span), d], [round3(0.65 * span), d]]},
                 "slits": {"notch": [[span / 2, 0], [span / 2, notch]]}}
        self.traction = {"type": "edge_traction", "boundary": "head", "traction": [0, -1]}
        return scene, self.one_joint(), self.held(span), ([span / 2, d], [0, -1]), ([span / 2, notch], [0, 1])

    def l_panel(self):
        d = self.depth
        corners = [[0, 0], [d, 0], [d, d], [2 * d, d], [2 * d, 2 * d], [0, 2 * d]]
        scene = {"regions": [region("body", "body", corners)], "boundaries": {"foot": [[0, 0], [d, 0]]}}
        return scene, self.one_joint(), {"foot": {"boundary": "foot", "fix": "xy"}}, ([2 * d, round3(1.1 * d)], [0, 1]), ([d, d], [-1, 0.5])

    def holed(self):
        """A plate with a square hole, drawn; the crack leaves the hole."""
        d = self.depth
        a, b = round3(0.35 * d), round3(0.65 * d)
        parts = {"lower": rectangle(0, 0, d, a), "upper": rectangle(0, b, d, d), "left": rectangle(0, a, a, b), "right": rectangle(b, a, d, b)}
        scene = {"regions": [region(name, "body", corners) for name, corners in parts.items()],
                 "boundaries": {"foot": [[0, 0], [d, 0]], "head": [[0, d], [d, d]]}}
        self.traction = {"type": "edge_traction", "boundary": "head", "traction": [0, 1]}
        self.through = list(parts)
        self.mesh = self.of("triangles", "quads", "voronoi")
        return scene, self.one_joint(), {"foot": {"boundary": "foot", "fix": "xy"}}, ([d / 2, d], [0, 1]), ([b, d / 2], [1, 0])

    def two_halves(self):
        """A beam of two materials side by side, the notch in the weaker one."""
        d, span = self.depth, round3(self.depth * self.random.uniform(2.5, 4))
        notch, x = round3(d * self.random.uniform(0.2, 0.4)), round3(span * 0.42)
        scene = {"regions": [region("left", "body", rectangle(0, 0, span / 2, d)), region("right", "other", rectangle(span / 2, 0, span, d))],
                 "slits": {"notch": [[x, 0], [x, notch]]}}
        self.through = ["left", "right"]
        return scene, self.one_joint(), self.held(span), ([round3(0.45 * span), d], [0, -1]), ([x, notch], [0, 1])

    def plated(self):
        """A beam that rests on steel plates and is loaded through one."""
        d, span = self.depth, round3(self.depth * self.random.uniform(2.5, 3.5))
        width, thick = round3(span / 8), round3(d / 8)
        plate = rectangle(span / 2 - width / 2, d, span / 2 + width / 2, d + thick)
        scene = {"regions": [region("body", "body", rectangle(0, 0, span, d)), region("plate", "steel", plate)]}
        contact = {"between": ["steel", "body"], "treatment": self.plate, "law": {"type": "friction", "friction_angle": self.of(15, 30, 45)}}
        interfaces = self.one_joint() | {"plate": contact}
        return scene, interfaces, self.held(span), ([span / 2, d + thick], [0, -1]), ([span / 2, 0], [0, 1])

    def loads(self, at, direction):
        scale = self.of(1e-3, 1, 1000)
        load = {"type": "point_load", "at": at, "force": [component * scale for component in direction]}
        main = [self.traction or load]
        dead = self.random.random() < 0.3
        weight = {"name": "weight", "loads": [{"type": "body_force", "force": [0, -self.between(1e-5, 4e-5)]}]}
        return ([weight] if dead else []) + [{"name": "loading", "loads": main}]

    def make(self):
        self.through, self.traction = ["body"], None
        scene, interfaces, supports, (at, direction), (tip, way) = self.shape()
        if self.mesh == "given" and ("slits" in scene or len(scene["regions"][0]["vertices"]) > 4):
            self.mesh = "quads"  # a grid has no notches
        used = {entry["material"] for entry in scene["regions"]}
        materials = {"body": self.elastic, "other": self.material(), "steel": STEEL}
        return {"title": f"One crack: {self.shape.__name__}, {self.mesh}", "units": {"length": "mm", "force": "N"},
                "scene": {"type": "polygons", **scene, "subdivision": self.subdivision()}, "thickness": self.between(10, 200),
                "plane": self.of("stress", "strain"), "materials": {name: materials[name] for name in sorted(used)},
                "interfaces": interfaces, "supports": supports, "stages": self.loads(at, direction),
                "cracks": [{"through_blocks": self.through, "law": "joints", "begin": [{"at": tip, "direction": way}]}],
                "path": {"stop": {"load_below": 0.1}}}


def cracked_structure(seed):
    """A deck and what it is counted under."""
    maker = CrackedMaker(seed)
    return maker.make(), {"shape": maker.shape.__name__, "mesh": maker.mesh, "treatment": maker.treatment, "suited": True}
