"""The runner of the studies over expectations that are right, wrong and senseless: `python3 test_run_study.py`."""

import json
import tempfile
import unittest
from pathlib import Path

import expectations
import run_study
import taken_steps


def check(**wanted):
    names = {"peak": run_study.as_namespace({"load": 100.0}), "curve": [1.0, float("nan")], "status": "goal_reached"}
    return run_study.complaint(wanted, names)


class Expectations(unittest.TestCase):
    def test_a_file_is_maps_lists_and_scalars(self):
        tree = expectations.parse("# note\na:\n  set:\n    - x.y=[[0, 1], [2: 3]]\n  exit: 3\n  expect:\n"
                                  "    - quantity: len(curve)\n      at_most: 1e-3\n    - quantity: b\n      is: c\n")
        self.assertEqual(tree, {"a": {"set": ["x.y=[[0, 1], [2: 3]]"], "exit": 3, "expect": [
            {"quantity": "len(curve)", "at_most": 1e-3}, {"quantity": "b", "is": "c"}]}})

    def test_a_name_twice_and_wrong_indentation_are_refused(self):
        for text in ("a:\n  b: 1\n  b: 2\n", "a:\n    b: 1\n  c: 2\n"):
            self.assertRaises(ValueError, expectations.parse, text)

    def test_a_case_that_expects_nothing_is_refused(self):
        for text in ("a:\n  exit: 0\n", "a:\n  expct:\n    - quantity: b\n"):
            with tempfile.TemporaryDirectory() as folder:
                file = Path(folder) / "expect.yaml"
                file.write_text(text, encoding="utf-8")
                self.assertRaises(SystemExit, run_study.cases, file)


class Complaints(unittest.TestCase):
    def test_what_holds_is_not_complained_about(self):
        self.assertEqual(check(quantity="peak.load", value=101, relative=0.01), "")
        self.assertEqual(check(quantity="peak.load", value=101, absolute=1), "")
        self.assertEqual(check(quantity="peak.load", at_least=100, at_most=100), "")
        self.assertEqual(check(quantity="status", **{"is": "goal_reached"}), "")

    def test_what_does_not_hold_is(self):
        self.assertTrue(check(quantity="peak.load", value=102, relative=0.01))
        self.assertTrue(check(quantity="peak.load", value=101))
        self.assertTrue(check(quantity="peak.load", at_least=99, at_most=99.9))
        self.assertTrue(check(quantity="status", **{"is": "stopped_early"}))

    def test_a_check_without_a_limit_or_with_an_unknown_one_is_complained_about(self):
        self.assertTrue(check(quantity="peak.load", relative=1))
        self.assertTrue(check(quantity="peak.load", at_most=200, at_mots=1))

    def test_what_is_not_a_number_never_passes(self):
        self.assertTrue(check(quantity="curve[1]", at_most=1e9))
        self.assertRaises(ValueError, check, quantity="max(curve)", at_most=1e9)


class TakenSteps(unittest.TestCase):
    def of(self, rows, **counts):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "summary.json").write_text(json.dumps(counts), encoding="utf-8")
            (Path(folder) / "curve.csv").write_text("step\n" + "".join(f"{row}\n" for row in rows), encoding="utf-8")
            return len(list(taken_steps.complaints(Path(folder))))

    def test_all_taken(self):
        self.assertEqual(self.of((0, 1, 2, 3), steps=3, cracked_steps=2, whole_steps=1), 0)

    def test_what_loca_has_not_taken_is_seen(self):
        self.assertEqual(self.of((0, 1, 2, 3), steps=3, cracked_steps=2, whole_steps=0), 1)
        self.assertEqual(self.of((0, 1, 2), steps=3, cracked_steps=2, whole_steps=1), 1)


if __name__ == "__main__":
    unittest.main()
