"""Animations of real runs: a block that is thrown, without a path, and a path without a motion."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
from PIL import Image

import ddapath
from ddapath.animation import ToolMissing, Wishes, animate, film
from ddapath.animation.__main__ import main
from ddapath.animation.motion_reel import MotionReel, decimals_for, round_number, speed_text, usual_speed
from ddapath.animation.outlines import Outlines, between
from ddapath.animation.path_reel import PathReel, along
from ddapath.animation.stage import Stage

BEAM = Path(__file__).resolve().parents[1] / "program" / "beam.yaml"
STONE = {"type": "linear_elastic", "young_modulus": 1e10, "density": 2500}
THROWN = {
    "title": "A block that is thrown", "units": {"length": "m", "force": "N"}, "thickness": 1,
    "materials": {"stone": STONE, "rock": STONE},
    "scene": {"type": "polygons", "regions": [
        {"name": "ground", "material": "rock", "vertices": [[-20, -1], [20, -1], [20, 0], [-20, 0]]},
        {"name": "block", "material": "stone", "vertices": [[0, 5], [1, 5], [1, 6], [0, 6]]}]},
    "motion": {"time": 0.5, "frame_every": 0.05, "gravity": [0, -9.81], "held": ["ground"], "contact": {"friction": 0.5},
               "velocities": [{"regions": ["block"], "velocity": [2, 0], "spin": 4}]}}


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.folder = Path(cls.scratch.name)
        cls.thrown = ddapath.run(THROWN, folder=cls.folder / "thrown")
        cls.beam = ddapath.run(BEAM, {"path.stop.load_below": 0.6, "record.fields_every": 4}, folder=cls.folder / "beam")


class Films(Runs):
    def test_a_gif_has_a_picture_for_each_instant(self):
        file = self.thrown.animate(self.folder / "thrown.gif", fps=10, speed=0.25)
        with Image.open(file) as picture:
            self.assertEqual((picture.format, picture.n_frames), ("GIF", 21))
            self.assertTrue(all(length % 2 == 0 for length in picture.size))
            durations = []
            for k in range(picture.n_frames):
                picture.seek(k)
                durations.append(picture.info["duration"])
        self.assertEqual(durations, 20 * [100] + [1600])
        self.assertEqual(sorted(self.folder.glob("*.part*")), [])

    def test_pictures_of_a_gif_are_those_that_were_drawn(self):
        pictures = np.full((3, 40, 60, 3), 255, dtype=np.uint8)
        pictures[1, 10:20, 10:20] = (0, 114, 178)
        pictures[2, 30:, :, :] = 0  # and what was there before is gone
        with film.Gif(self.folder / "three.gif", 20, list(pictures), [(255, 255, 255)]) as strip:
            for picture in pictures:
                strip.add(picture)
        with Image.open(self.folder / "three.gif") as stored:
            for k, picture in enumerate(pictures):
                stored.seek(k)
                np.testing.assert_array_equal(np.asarray(stored.convert("RGB")), picture)

    def test_a_path_alone(self):
        file = self.beam.animate(self.folder / "beam.gif", fps=2, path=True)
        with Image.open(file) as picture:
            self.assertEqual(picture.n_frames, 12)

    def test_in_the_folder_of_the_run_by_default(self):
        self.assertEqual(self.thrown.animate(fps=2, speed=0.5), self.thrown.folder / "motion.gif")

    def stand_in(self, folder, script):
        """A program that is found as ffmpeg while the context lasts; its folder is in the one of the runs."""
        tool = self.folder / folder / "ffmpeg"
        tool.parent.mkdir()
        tool.write_text("#!/bin/sh\n" + script)
        tool.chmod(0o755)
        return mock.patch.dict(os.environ, PATH=f"{tool.parent}:{os.environ['PATH']}")

    def test_mp4_is_fed_to_ffmpeg(self):
        with self.stand_in("bin", 'for file; do :; done\necho "$@" > "$0.arguments"\nexec cat > "$file"\n'):
            file = self.thrown.animate(self.folder / "thrown.mp4", fps=10, speed=0.25)
        words = (self.folder / "bin" / "ffmpeg.arguments").read_text().split()
        width, height = map(int, words[words.index("-s") + 1].split("x"))
        self.assertEqual(file.stat().st_size, width * height * 3 * (21 + 15))

    def test_ffmpeg_that_fails_leaves_nothing(self):
        with self.stand_in("broken", "cat > /dev/null\necho no such encoder >&2\nexit 1\n"):
            with self.assertRaisesRegex(ddapath.DdapathError, "no such encoder"):
                self.thrown.animate(self.folder / "no.mp4", fps=2, speed=0.5)
        self.assertEqual(sorted(self.folder.glob("no*")), [])


class Refused(Runs):
    def test_what_cannot_be(self):
        for error, wishes in ((ddapath.NothingStored, {}), (ddapath.NothingStored, {"path": True})):
            run = self.beam if not wishes else self.thrown
            with self.assertRaises(error):
                run.animate(self.folder / "x.gif", **wishes)
        for wishes in ({"fps": 0}, {"fps": 51}, {"speed": 0}, {"speed": float("nan")}, {"speed": 1e-6}, {"magnification": -1}):
            with self.assertRaises(ValueError):
                self.thrown.animate(self.folder / "x.gif", **wishes)
        with self.assertRaisesRegex(ValueError, "called .gif or .mp4, not '.avi'"):
            animate(self.thrown, self.folder / "x.avi")
        self.assertFalse((self.folder / "x.gif").exists())

    def test_without_ffmpeg(self):
        with mock.patch("shutil.which", return_value=None), self.assertRaisesRegex(ToolMissing, "apt-get install ffmpeg"):
            self.thrown.animate(self.folder / "x.mp4")

    def test_the_command(self):
        codes = {(str(self.beam.folder),): 2, (str(self.folder / "nothing"),): 2, (str(self.thrown.folder), "--out=x.avi"): 2,
                 (str(self.thrown.folder), f"--out={self.folder}/none/x.gif"): 2, (str(self.thrown.folder), "--fps=0"): 2}
        with mock.patch("sys.stderr"):
            for arguments, code in codes.items():
                self.assertEqual(main(list(arguments)), code, arguments)

    def test_the_program(self):
        """`dda animate` hands over what it is told."""
        command = [str(ddapath.find_program()), "animate"]
        out = self.folder / "told.gif"
        done = subprocess.run([*command, str(self.thrown.folder), "--output", str(out), "--fps", "4", "--speed", "0.25"],
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith(str(out)))
        with Image.open(out) as picture:
            self.assertEqual(picture.n_frames, 9)
        done = subprocess.run([*command, str(self.beam.folder)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("nothing has moved", done.stderr)


class Reels(Runs):
    def test_what_is_held_and_what_moves(self):
        reel = MotionReel(self.thrown, None, 20)
        self.assertEqual(reel.held.tolist(), [True, False])
        self.assertLess(reel.box[2] - reel.box[0], 5)  # not all of the ground

    def test_a_block_flies_between_stored_states(self):
        reel = MotionReel(self.thrown, None, 20)
        for time in (0.0, 0.123, 0.5):
            block = reel.outlines_at(time).polygons[1]
            np.testing.assert_allclose(block.mean(axis=0), [0.5 + 2 * time, 5.5 - 9.81 / 2 * time**2], atol=5e-3)
            np.testing.assert_allclose(np.linalg.norm(block[1] - block[0]), 1, rtol=1e-6)
            edge = block[1] - block[0]
            self.assertAlmostEqual(np.arctan2(edge[1], edge[0]), 4 * time, delta=1e-3)

    def test_the_instants_end_at_the_end(self):
        reel = MotionReel(self.thrown, 0.3, 7)
        times = [reel.time_of(k) for k in range(reel.count)]
        self.assertEqual((times[0], times[-1]), (0, self.thrown.motion.curve["time"].iloc[-1]))
        np.testing.assert_allclose(np.diff(times)[:-1], 0.3 / 7)

    def test_a_path_goes_through_its_steps(self):
        reel = PathReel(self.beam, 100.0, 10)
        self.assertEqual(reel.step_near(0.4), 0)
        self.assertEqual(reel.step_near(len(self.beam.curve)), self.beam.steps[-1])
        stage = Stage(reel.box, "beam")
        reel.begin(stage)
        for k in (0, reel.count - 1):
            reel.show(stage, k)
        self.assertEqual(stage.picture().shape[2], 3)

    def test_the_point_goes_evenly(self):
        np.testing.assert_allclose(along(np.array([0.0, 3, 3]), np.array([0.0, 0, 4]), 5), [0, 0.5, 1, 1.5, 2])
        np.testing.assert_array_equal(along(np.zeros(3), np.zeros(3), 2), [0, 0])


class Pieces(unittest.TestCase):
    def test_a_turn_keeps_the_shape(self):
        square = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
        angle = 2.0
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        half = between(Outlines.of([square, square]), Outlines.of([square, square @ turn + [3, 0]]), 0.5).polygons
        np.testing.assert_allclose(half[0], square, atol=1e-12)
        np.testing.assert_allclose(np.linalg.norm(np.roll(half[1], 1, axis=0) - half[1], axis=1), 1)
        edge = half[1][1] - half[1][0]
        self.assertAlmostEqual(np.arctan2(edge[1], edge[0]), 1.0)

    def test_round_speeds(self):
        self.assertEqual([round_number(x) for x in (1, 1.3, 1.5, 8, 0.004)], [1, 1, 2, 10, 0.005])
        self.assertEqual([usual_speed(x) for x in (0.04, 5, 80)], [0.005, 1, 10])
        self.assertEqual([speed_text(x) for x in (1, 0.05, 4)], ["in real time", "slowed down 20 times", "speeded up 4 times"])
        self.assertEqual([decimals_for(x) for x in (2, 0.1, 0.05, 0.005)], [0, 1, 2, 3])

    def test_wishes(self):
        self.assertEqual(Wishes().fps, 20)
        self.assertEqual(film.Gif.true_fps(30), 100 / 3)


if __name__ == "__main__":
    sys.exit(unittest.main())
