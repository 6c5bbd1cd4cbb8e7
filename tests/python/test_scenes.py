"""Scenes from pictures and drawings that the tests draw: known areas, neighbours that share their vertices, decks that the
program accepts."""

import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw
from scipy.spatial import Voronoi

import ddapath
from ddapath import scenes
from ddapath.scenes.chains import chains_of, simplified
from ddapath.scenes.image import Wishes
from ddapath.scenes.scaled import Units

MORTAR, STONE = "#d8d0c0", "#806040"
BRICK = (60, 20)  # pixels
SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">{}</svg>'


def area(corners):
    x, y = np.asarray(corners, float).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def areas(scene):
    return {region["name"]: area(region["vertices"]) for region in scene["regions"]}


def sides(region):
    corners = [tuple(corner) for corner in region["vertices"]]
    return list(zip(corners, corners[1:] + corners[:1]))


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def is_simple(region):
    """No corner twice, no two sides that cross, by a look at every pair."""
    found = sides(region)
    if len({start for start, _ in found}) < len(found):
        return False
    return not any(cross(a, b, c) * cross(a, b, d) < 0 and cross(c, d, a) * cross(c, d, b) < 0
                   for k, (a, b) in enumerate(found) for c, d in found[:k])


def free_length(scene):
    """Of all sides without the same side of a neighbour, there and back."""
    count = Counter(side for region in scene["regions"] for side in sides(region))
    return sum(np.hypot(b[0] - a[0], b[1] - a[1]) for a, b in count if (b, a) not in count)


def wall(joint=2, size=(300, 160)):
    """A running bond of bricks of 60 x 20 pixels with joints of an even breadth, half of it at each edge."""
    picture = Image.new("RGB", size, MORTAR)
    draw, half = ImageDraw.Draw(picture), joint // 2
    for course in range(size[1] // BRICK[1]):
        for k in range(-1, size[0] // BRICK[0] + 1):
            x, y = k * BRICK[0] + (BRICK[0] // 2 if course % 2 else 0), course * BRICK[1]
            draw.rectangle([x + half, y + half, x + BRICK[0] - half - 1, y + BRICK[1] - half - 1], fill=STONE)
    return picture


def voronoi(count, shape, seed):
    """Labels from 1 on of the pixels nearest to random places."""
    places = np.random.default_rng(seed).random((count, 2)) * shape
    pixels = np.stack(np.meshgrid(np.arange(shape[0]), np.arange(shape[1]), indexing="ij"), axis=-1)
    return ((pixels[:, :, None] - places) ** 2).sum(axis=3).argmin(axis=2) + 1


class Scenes(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def saved(self, picture, name="picture.png"):
        picture.save(self.folder / name)
        return self.folder / name

    def written(self, text, name="drawing.svg"):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def assert_blocks(self, scene, outline, total):
        """Simple, counter-clockwise, conforming: free sides are the outline alone."""
        self.assertTrue(all(is_simple(region) for region in scene["regions"]))
        self.assertGreater(min(areas(scene).values()), 0)
        self.assertAlmostEqual(free_length(scene) / outline, 1, delta=1e-9)
        self.assertAlmostEqual(sum(areas(scene).values()) / total, 1, delta=1e-9)

    def assert_accepted(self, scene):
        deck = scenes.deck_to_begin_with(scene, {"length": "mm", "force": "N"})
        file = ddapath.write_deck(deck, self.folder / "deck.yaml")
        done = subprocess.run([ddapath.find_program(), "check", file], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"blocks            {len(scene['regions'])} ", done.stdout)


class Pictures(Scenes):
    def test_bricks_whose_joints_are_lines(self):
        scene = scenes.scene_of_image(self.saved(wall()), width=3000, materials={"mortar": MORTAR, "stone": STONE}, joint="mortar")
        whole, half = BRICK[0] * BRICK[1] * 100, BRICK[0] * BRICK[1] * 50
        self.assert_blocks(scene, 2 * (3000 + 1600), 3000 * 1600)
        self.assertEqual(len(scene["regions"]), 4 * 5 + 4 * 6)
        for size in areas(scene).values():
            self.assertLessEqual(min(abs(size - whole), abs(size - half)), 100)  # a pixel
        self.assertEqual(scene["boundaries"]["top"], [[0, 1600], [3000, 1600]])

    def test_mortar_as_a_region(self):
        scene = scenes.scene_of_image(self.saved(wall(joint=6)), height=160, materials={"mortar": MORTAR, "stone": STONE})
        self.assert_blocks(scene, 2 * (300 + 160), 300 * 160)
        stones = [area(region["vertices"]) for region in scene["regions"] if region["material"] == "stone"]
        self.assertEqual(sorted(set(stones)), [27 * 14, 54 * 14])
        self.assert_accepted(scene)

    def test_turned_bricks(self):
        rows, columns = np.mgrid[0:300, 0:400] + 0.5
        c, s = np.cos(0.3), np.sin(0.3)
        along, up = c * columns + s * rows, c * rows - s * columns
        course = np.floor(up / 40).astype(int)
        brick = np.floor((along + 50 * (course % 2)) / 100).astype(int)
        labels = np.unique(course * 1000 + brick, return_inverse=True)[1].reshape(rows.shape) + 1
        scene = scenes.scene_of_labels(labels, ["stone"] * labels.max(), width=4)
        self.assert_blocks(scene, 2 * (4 + 3), 12)
        inner = [region for region in scene["regions"] if all(0 < x < 4 and 0 < y < 3 for x, y in region["vertices"])]
        self.assertGreater(len(inner), 10)
        for region in inner:
            self.assertAlmostEqual(area(region["vertices"]) / 0.4, 1, delta=0.03)
            self.assertLessEqual(len(region["vertices"]), 12)
        self.assert_accepted(scene)

    def test_a_disc_in_a_matrix(self):
        picture = Image.new("L", (200, 200), 255)
        ImageDraw.Draw(picture).ellipse([60, 60, 139, 139], fill=0)
        scene = scenes.scene_of_image(self.saved(picture, "disc.tif"), width=200, materials=["disc", "matrix"])
        self.assert_blocks(scene, 800, 40000)
        found = areas(scene)
        self.assertEqual(sorted(found), ["disc 1", "matrix 1.1", "matrix 1.2"])
        self.assertAlmostEqual(found["disc 1"] / (np.pi * 40**2), 1, delta=0.02)
        self.assert_accepted(scene)
        deck = scenes.deck_to_begin_with(scene, {"length": "mm", "force": "N"})
        self.assertEqual(list(deck["interfaces"]), ["matrix on disc"])

    def test_many_aggregates_one_inside_another(self):
        picture, random = Image.new("L", (240, 160), 255), np.random.default_rng(5)
        draw = ImageDraw.Draw(picture)
        for x, y in random.random((50, 2)) * [240, 160]:
            a, b = random.uniform(4, 14, 2)
            draw.ellipse([x - a, y - b, x + a, y + b], fill=0)
            draw.ellipse([x - a / 2, y - b / 2, x + a / 2, y + b / 2], fill=128)
        scene = scenes.scene_of_image(self.saved(picture), width=240, materials=["rim", "core", "matrix"], thresholds=[0.25, 0.75])
        self.assert_blocks(scene, 800, 240 * 160)
        self.assert_accepted(scene)

    def test_touching_stones_are_parted_where_asked(self):
        picture = Image.new("L", (160, 100), 255)
        for x in (50, 106):
            ImageDraw.Draw(picture).ellipse([x - 30, 20, x + 30, 80], fill=0)
        how = {"width": 160, "materials": ["stone", "nothing"]}
        one = scenes.scene_of_image(self.saved(picture), wishes=Wishes(without=("nothing",)), **how)
        two = scenes.scene_of_image(self.saved(picture), wishes=Wishes(without=("nothing",), split={"stone": 5}), **how)
        self.assertEqual([len(scene["regions"]) for scene in (one, two)], [1, 2])
        self.assertAlmostEqual(sum(areas(two).values()) / sum(areas(one).values()), 1, delta=0.01)
        shared = set.intersection(*(set(map(tuple, region["vertices"])) for region in two["regions"]))
        self.assertLessEqual({round(x) for x, _ in shared}, {78, 79})
        self.assertGreaterEqual(len(shared), 2)
        self.assert_accepted(two)

    def test_a_noisy_jpeg(self):
        noise = np.random.default_rng(2).normal(0, 25, (160, 300, 3))
        picture = Image.fromarray(np.clip(np.asarray(wall(joint=4)) + noise, 0, 255).astype(np.uint8))
        picture.save(self.folder / "photo.jpg", quality=80)
        scene = scenes.scene_of_image(self.folder / "photo.jpg", width=300, materials={"mortar": MORTAR, "stone": STONE},
                                      joint="mortar", wishes=Wishes(smooth=1.0, least_area=100, tolerance=2))
        self.assert_blocks(scene, 920, 300 * 160)
        self.assertEqual(len(scene["regions"]), 44)
        for size in areas(scene).values():
            self.assertLess(min(abs(size / 1200 - 1), abs(size / 600 - 1)), 0.1)

    def test_random_cells(self):
        for seed in range(8):
            labels = voronoi(10 + 12 * seed, (90, 140), seed)
            scene = scenes.scene_of_labels(labels, ["cell"] * labels.max(), 1.4, wishes=Wishes(tolerance=0.01 * (1 + seed % 3)))
            with self.subTest(seed=seed):
                self.assert_blocks(scene, 2 * (1.4 + 0.9), 1.4 * 0.9)
        self.assert_accepted(scene)

    def test_random_pixels(self):
        """Labels as ragged as can be: parts that touch at corners of pixels, islands in islands."""
        for seed in range(6):
            labels = np.random.default_rng(seed).integers(1, 4, (24, 30))
            scene = scenes.scene_of_labels(labels, ["a", "b", "c"], width=30, wishes=Wishes(least_area=seed))
            with self.subTest(seed=seed):
                self.assert_blocks(scene, 108, 720)

    def test_a_line_is_within_its_tolerance(self):
        labels = voronoi(12, (80, 80), 3)
        for chain in chains_of(labels):
            line = simplified(chain.points, 1.5)
            self.assertTrue((line[[0, -1]] == chain.points[[0, -1]]).all())
            for point in chain.points:
                start, along = line[:-1], np.diff(line, axis=0)
                share = np.clip(((point - start) * along).sum(axis=1) / (along**2).sum(axis=1), 0, 1)
                self.assertLessEqual(np.hypot(*(start + share[:, None] * along - point).T).min(), 1.5 + 1e-12)

    def test_what_is_wrong_with_a_picture(self):
        file = self.saved(wall())
        text = self.written("no picture", "text.png")
        how = {"materials": {"mortar": MORTAR, "stone": STONE}}
        for expected, arguments, more in (
                ("nowhere.png: there is no such file", (self.folder / "nowhere.png", 1), how),
                ("text.png: no picture that can be read", (text, 1), how),
                ("how large is it", (file,), how), ("width is -1: give a number above 0", (file, -1), how),
                ("are not 300 x 200: give the width or the height", (file, 300, 200), how),
                ("'sand' is none of the materials", (file, 300), {**how, "joint": "sand"}),
                ("colour 'blau': give #rrggbb", (file, 300), {"materials": {"mortar": "blau"}}),
                ("brightness 7: give one from 0", (file, 300), {"materials": {"mortar": 7}}),
                ("2 thresholds for 2 materials", (file, 300), {"materials": ["a", "b"], "thresholds": [0.1, 0.2]}),
                ("the threshold 2: give brightness", (file, 300), {"materials": ["a", "b"], "thresholds": [2]}),
                ("no part of it is of stone", (file, 300), {**how, "joint": "mortar", "wishes": Wishes(least_area=1e6)})):
            with self.subTest(expected), self.assertRaisesRegex(scenes.SceneError, expected):
                scenes.scene_of_image(*arguments, **more)

    def test_pictures_of_all_kinds(self):
        grey = np.full((20, 30), 60000, np.uint16)
        grey[:, 10:] = 1000
        clear = Image.new("RGBA", (30, 20), (0, 0, 0, 255))
        clear.paste((0, 0, 0, 0), (0, 0, 10, 20))
        exif = Image.Exif()
        exif[0x0112] = 6  # to be turned clockwise
        Image.fromarray(np.rot90((grey // 256).astype(np.uint8))).save(self.folder / "turned.jpg", exif=exif)
        for file in (self.saved(Image.fromarray(grey), "grey.tif"), self.saved(clear, "clear.png"), self.folder / "turned.jpg",
                     self.saved(Image.fromarray((grey // 256).astype(np.uint8)).convert("CMYK"), "print.tif")):
            scene = scenes.scene_of_image(file, width=30, materials=["dark", "bright"])
            with self.subTest(file.name):
                self.assertEqual(areas(scene), {"bright 1": 200, "dark 1": 400})

    def test_a_module_that_is_missing(self):
        with self.assertRaisesRegex(scenes.ModuleMissing, "no_such_module, which is not installed: apt-get install python3-none"):
            ddapath.needed.from_debian("no_such_module", "python3-none")


class Svg(Scenes):
    def test_regions_by_class_and_group(self):
        file = self.written(SVG.format(
            '<g id="brick"><rect x="0" y="0" width="100" height="50"/></g>'
            '<path id="pier" class="stone" d="M100 0 L200 0.05 L200 50 L100.05 50 Z"/>'
            '<rect class="matrix" x="0" y="50" width="200" height="50"/>'
            '<g class="grain"><circle cx="50" cy="75" r="20"/></g><circle class="hole" cx="150" cy="75" r="10"/>'
            '<polyline class="curve-bed" points="0,50 200,50"/><polyline class="boundary-foot" points="0,100 200,100"/>'))
        scene = scenes.scene_of_svg(file, units=Units(scale=2), tolerance=0.2, without=("hole",))
        found = areas(scene)
        self.assertEqual(sorted(found), ["brick 1", "grain 1", "matrix 1.1", "matrix 1.2", "pier"])
        self.assertTrue(all(is_simple(region) for region in scene["regions"]))
        self.assertAlmostEqual(found["brick 1"], 20000, delta=1e-6)
        self.assertAlmostEqual(found["grain 1"] / (np.pi * 40**2), 1, delta=0.01)
        circles = np.pi * (40**2 + 20**2)
        matrix = sum(size for name, size in found.items() if name.startswith("matrix"))
        self.assertAlmostEqual(matrix / (40000 - circles), 1, delta=0.002)
        self.assertEqual(scene["curves"]["bed"][0], [0, 100])
        self.assertEqual(scene["boundaries"]["foot"], [[0, 0], [400, 0]])
        self.assert_accepted(scene)

    def test_curved_sides_are_shared(self):
        """The same arc, once there and once back, from different starts: flattened apart, joined again."""
        file = self.written(SVG.format('<path class="a" d="M0 0 H100 A60 60 0 0 1 100 100 H0 Z"/>'
                                       '<path class="b" d="M200 0 V100 H100 A60 60 0 0 0 100 0 Z"/>'))
        scene = scenes.scene_of_svg(file, units=Units(width=200), tolerance=0.5)
        self.assert_blocks(scene, 600, 20000)
        segment = 60**2 * np.arcsin(50 / 60) - 50 * np.sqrt(60**2 - 50**2)
        self.assertAlmostEqual(areas(scene)["a 1"] / (10000 + segment), 1, delta=0.005)
        self.assert_accepted(scene)

    def test_cells_drawn_one_by_one(self):
        """Voronoi's cells, each drawn on its own, corners off by a tenth of the tolerance and one more on each side."""
        for seed in range(6):
            random = np.random.default_rng(seed)
            places = random.random((20, 2))
            mirrored = [places, places * [-1, 1], places * [1, -1], [2, 0] + places * [-1, 1], [0, 2] + places * [1, -1]]
            diagram = Voronoi(np.vstack(mirrored))
            paths = []
            for k in range(len(places)):
                corners = np.clip(diagram.vertices[diagram.regions[diagram.point_region[k]]], 0, 1)
                drawn = np.stack([corners, corners + 0.4 * (np.roll(corners, -1, axis=0) - corners)], axis=1).reshape(-1, 2)
                drawn = np.roll(drawn + random.uniform(-1e-4, 1e-4, drawn.shape), seed, axis=0)[::random.choice([-1, 1])]
                text = " ".join(f"{x:.9g},{1 - y:.9g}" for x, y in drawn)
                paths.append(f'<polygon class="cell" points="{text}"/>')
            file = self.written(SVG.format("".join(paths)).replace("200 100", "1 1").replace("200mm", "100mm"))
            scene = scenes.scene_of_svg(file, tolerance=1e-3)
            with self.subTest(seed=seed):
                self.assertEqual(len(scene["regions"]), len(places))
                self.assertTrue(all(is_simple(region) for region in scene["regions"]))
                self.assertAlmostEqual(free_length(scene), 4, delta=0.01)
                self.assertAlmostEqual(sum(areas(scene).values()), 1, delta=2e-3)
        self.assert_accepted(scene)

    def test_what_is_wrong_with_a_drawing(self):
        for expected, text in (("shape 1: an open path: close it", '<path class="a" d="M0 0 L10 0 L10 10"/>'),
                               ("crosses .*'b', shape 2 near", '<rect class="a" width="10" height="10"/>'
                                '<rect class="b" x="5" y="5" width="10" height="10"/>'),
                               ("crosses itself near", '<path class="a" d="M0 0 L10 10 L10 0 L0 10 Z"/>'),
                               ("nothing tells its material", '<rect width="1" height="1"/>'),
                               ("there is no path in it", "<text>a</text>")):
            with self.subTest(expected), self.assertRaisesRegex(scenes.SceneError, expected):
                scenes.scene_of_svg(self.written(SVG.format(text)))
        with self.assertRaisesRegex(scenes.SceneError, "no SVG that can be read"):
            scenes.scene_of_svg(self.written("<svg"))


class Dxf(Scenes):
    def drawn(self, draw):
        import ezdxf

        drawing = ezdxf.new("R2010")
        draw(drawing.modelspace())
        drawing.saveas(self.folder / "drawing.dxf")
        return self.folder / "drawing.dxf"

    def test_regions_by_layer(self):
        def draw(space):
            space.add_lwpolyline([(10, 10), (12, 10), (12, 11), (10, 11)], close=True, dxfattribs={"layer": "stone"})
            for start, end in (((12, 10), (14, 10)), ((14, 11), (14, 10)), ((12, 11), (14, 11)), ((12, 11), (12, 10))):
                space.add_line(start, end, dxfattribs={"layer": "brick"})
            space.add_circle((11, 10.5), 0.25, dxfattribs={"layer": "grain"})
            space.add_lwpolyline([(12, 10), (12, 11)], dxfattribs={"layer": "slit-notch"})
            space.add_text("not a region")

        scene = scenes.scene_of_dxf(self.drawn(draw), units=Units(scale=1000), tolerance=2)
        self.assert_blocks(scene, 10000, 4e6)
        found = areas(scene)
        self.assertEqual(found["brick 1"], 2e6)
        self.assertAlmostEqual(found["grain 1"] / (np.pi * 250**2), 1, delta=0.01)
        self.assertEqual(scene["slits"], {"notch": [[12000, 10000], [12000, 11000]]})
        self.assert_accepted(scene)

    def test_corners_on_sides(self):
        """Two bricks on one, drawn a little off it."""
        def draw(space):
            for corners in ([(0, 0), (4, 0), (4, 1), (0, 1)], [(0, 1.001), (2, 0.999), (2, 2), (0, 2)], [(2, 1), (4, 1), (4, 2), (2, 2)]):
                space.add_lwpolyline(corners, close=True, dxfattribs={"layer": "stone"})

        scene = scenes.scene_of_dxf(self.drawn(draw), tolerance=0.01)
        self.assert_blocks(scene, 12, 8)
        self.assertEqual(len(scene["regions"][0]["vertices"]), 5)
        self.assert_accepted(scene)

    def test_a_line_that_does_not_close(self):
        file = self.drawn(lambda space: space.add_line((0, 0), (1, 1), dxfattribs={"layer": "stone"}))
        with self.assertRaisesRegex(scenes.SceneError, "layer 'stone', LINE .*: an open path"):
            scenes.scene_of_dxf(file)
        with self.assertRaisesRegex(scenes.SceneError, "no DXF that can be read"):
            scenes.scene_of_dxf(self.written("nothing", "text.dxf"))


class CommandLine(Scenes):
    def told(self, *arguments):
        line = [sys.executable, "-B", "-m", "ddapath", "scene", *map(str, arguments)]
        return subprocess.run(line, capture_output=True, text=True, check=False)

    def test_a_deck_that_the_program_accepts(self):
        file, deck = self.saved(wall()), self.folder / "wall.yaml"
        done = self.told(file, "--width", 3000, "--material", f"mortar={MORTAR}", "--material", f"stone={STONE}", "--joint", "mortar",
                         "--out", deck)
        self.assertEqual((done.returncode, done.stdout), (0, f"{deck}: 44 blocks\n"), done.stderr)
        checked = subprocess.run([ddapath.find_program(), "check", deck], capture_output=True, text=True, check=False)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assert_blocks(ddapath.read_deck(deck)["scene"], 9200, 4.8e6)
        again = self.told(file, "--width", 3000, "--material", "a", "--material", "b", "--out", deck)
        self.assertEqual(again.returncode, 2)
        self.assertIn("is there already", again.stderr)

    def test_the_scene_alone(self):
        file = self.written(SVG.format('<rect class="a" width="200" height="100"/>'))
        self.assertEqual(self.told(file, "--scene-only", "--width", 4).returncode, 0)
        deck = ddapath.read_deck(self.folder / "drawing.yaml")
        self.assertEqual((list(deck), areas(deck["scene"])), (["scene"], {"a 1": 8}))
        self.assertNotIn("interfaces", scenes.deck_to_begin_with(deck["scene"], {"length": "m", "force": "N"}))

    def test_wrong_input(self):
        svg = self.written(SVG.format('<rect class="a" width="200" height="100"/>'))
        for expected, arguments in (("there is no such file", [self.folder / "no.png", "--width", 1, "--material", "a"]),
                                    ("no material: give each", [self.saved(wall()), "--width", 1]),
                                    ("its ending is none of", [self.folder / "a.txt"]),
                                    ("--joint belongs to pictures", [svg, "--joint", "mortar"]),
                                    ("no closed path is on a layer 'b'", [svg, "--without", "b"])):
            done = self.told(*arguments)
            with self.subTest(expected):
                self.assertEqual(done.returncode, 2)
                self.assertIn(expected, done.stderr)


if __name__ == "__main__":
    unittest.main()
