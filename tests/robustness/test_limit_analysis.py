"""The linear program of rigid blocks against closed forms: sliding, rocking, the dry wall, triliths."""
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from contact_scenes import TREATMENTS, rectangle  # noqa: E402
from contact_structures import brick_rows, wall_limit  # noqa: E402
from limit_analysis import collapse_factor, decided_by_hinges, joints, weight, wrench  # noqa: E402
from masonry_structures import TRILITHS, limit, places, rocking_trilith, trilith  # noqa: E402

NOTHING = wrench((0, 0), (0, 0))


def pushed_block(height, friction, where):
    """A block of 60 mm on a floor of 100 mm, of weight 1, pushed at its top by λ."""
    blocks = [rectangle(0, -10, 100, 0), rectangle(20, 0, 80, height)]
    loads = [NOTHING, weight(blocks[1], (0, -1 / (60 * height)), 1)], [NOTHING, wrench((1, 0), (20, height))]
    return blocks, {0}, loads, friction, where


class OneBlock(unittest.TestCase):
    def test_slides_at_the_friction_of_its_weight(self):
        problem = pushed_block(20, 0.4, "vertices")
        self.assertAlmostEqual(collapse_factor(*problem), 0.4, delta=1e-9)
        self.assertFalse(decided_by_hinges(*problem))

    def test_rocks_about_its_last_contact_point(self):
        for where, arm in (("vertices", 30), ("gauss", 30 / math.sqrt(3))):
            problem = pushed_block(200, 0.4, where)
            self.assertAlmostEqual(collapse_factor(*problem), arm / 200, delta=1e-9)
            self.assertTrue(decided_by_hinges(*problem))

    def test_what_cannot_bear_its_weight_is_refused(self):
        blocks = [rectangle(0, 0, 10, 10), rectangle(9, 10, 29, 20)]
        with self.assertRaises(ValueError):
            collapse_factor(blocks, {0}, ([NOTHING, weight(blocks[1], (0, -1), 1)], [NOTHING, NOTHING]), 0.4, "vertices")


class Structures(unittest.TestCase):
    def test_sides_that_overlap_are_joints_along_what_they_share(self):
        (first, second, start, end), = joints([rectangle(0, 0, 10, 10), rectangle(6, 10, 20, 20)])
        self.assertEqual((first, second), (0, 1))
        self.assertEqual(sorted([list(start), list(end)]), [[6, 10], [10, 10]])

    def test_dry_wall(self):
        rows = brick_rows()
        shapes = [rectangle(a, c, b, d) for a, b, c, d, _ in rows]
        kinds = [kind for *_, kind in rows]
        dead = [wrench((0, -30 if kind == "top" else 0), (500, 540)) for kind in kinds]
        live = [wrench((kind == "top", 0), (0, 480)) for kind in kinds]
        for treatment in TREATMENTS:
            for friction in (0.2, 0.75, 1.2, 1.5):
                expected, _ = wall_limit("given", treatment, math.degrees(math.atan(friction)))
                found = collapse_factor(shapes, {0}, (dead, live), friction, places(treatment))
                self.assertAlmostEqual(found, expected, delta=1e-8 * expected, msg=f"{treatment}, {friction}")

    def test_triliths(self):
        for height in TRILITHS:
            for treatment in TREATMENTS:
                deck = trilith(height, treatment).deck
                blocks = [(region["material"], region["vertices"]) for region in deck["scene"]["regions"]]
                found, expected = limit(blocks, deck["stages"][1]["loads"][0], treatment), rocking_trilith(height, treatment)
                self.assertAlmostEqual(found, expected, delta=1e-8 * expected, msg=f"{treatment}, {height}")


if __name__ == "__main__":
    unittest.main()
