"""What studies share: measured processes, tables, regions of a README."""

import tempfile
import unittest
from pathlib import Path

from ddapath import study

DECK = Path(__file__).resolve().parents[1] / "program" / "beam.yaml"


class Study(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def test_a_process_is_measured(self):
        done = study.measured(DECK, self.folder / "run", {"path.stop.after_steps": 3})
        self.assertEqual((done.exit_code, done.run.summary["steps"]), (0, 3))
        self.assertTrue(0 < done.processor < done.seconds + 1)

    def test_what_fails_is_a_result_too(self):
        done = study.measured({"title": "no scene"}, self.folder / "run")
        self.assertEqual(done.exit_code, 2)
        self.assertIn("scene", done.said)

    def test_what_takes_too_long_is_given_up(self):
        self.assertEqual(study.measured(DECK, self.folder / "run", limit=0.01).exit_code, study.GIVEN_UP)

    def test_rows_come_back(self):
        study.write_rows(self.folder / "rows.csv", [{"name": "a", "x": 1 / 3, "n": None}], digits=3)
        self.assertEqual(study.read_rows(self.folder / "rows.csv"), [{"name": "a", "x": 0.333, "n": None}])

    def test_a_region_is_replaced_and_nothing_else(self):
        readme = self.folder / "README.md"
        readme.write_text("one\n<!-- found: begin -->\nold\n<!-- found: end -->\ntwo \\1\n", encoding="utf-8")
        study.write_region(readme, "new \\1", "found")
        self.assertEqual(readme.read_text(encoding="utf-8"),
                         "one\n<!-- found: begin -->\nnew \\1\n<!-- found: end -->\ntwo \\1\n")
        with self.assertRaisesRegex(ValueError, "no region 'results'"):
            study.write_region(readme, "")


if __name__ == "__main__":
    unittest.main()
