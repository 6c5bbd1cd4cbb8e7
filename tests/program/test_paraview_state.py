"""paraview_state.py of a run, with a stand-in for ParaView that notes what it is told.

    test_paraview_state.py        with PYTHONPATH=python, and DDA naming the program
"""

import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest.mock import MagicMock

import ddapath

ROOT = Path(__file__).resolve().parents[2]


def opened(script):
    """The stand-in after it has run the script; its reader knows the grids of two steps."""
    simple = MagicMock()
    simple.__all__ = ["XDMFReader", "Show", "ColorBy", "GetScalarBar", "GetColorTransferFunction", "LoadPalette",
                      "GetActiveViewOrCreate", "WarpByVector", "Threshold", "GetAnimationScene", "PythonAnnotation", "Render"]
    readers = []

    def reader(FileNames):
        readers.append(types.SimpleNamespace(files=FileNames, UpdatePipelineInformation=lambda: None,
                                             GridStatus=["blocks", "blocks[1]", "interfaces", "interfaces[1]"]))
        return readers[-1]

    simple.XDMFReader.side_effect = reader
    packages = {"paraview": MagicMock(simple=simple), "paraview.simple": simple}
    before = {name: sys.modules.get(name) for name in packages}
    sys.modules.update(packages)
    try:
        exec(compile(script.read_text(encoding="utf-8"), str(script), "exec"), {"__file__": str(script)})
    finally:
        for name, module in before.items():
            sys.modules.pop(name) if module is None else sys.modules.update({name: module})
    return simple, readers


class ParaViewState(unittest.TestCase):
    def test_opens_the_run_beside_it(self):
        with tempfile.TemporaryDirectory() as scratch:
            run = ddapath.run(ROOT / "tests/program/beam.yaml", {"path.stop.after_steps": 6}, folder=Path(scratch) / "ma'de")
            last = run.curve.iloc[-1]
            moved = run.folder.rename(Path(scratch) / "moved")
            simple, (blocks, joints) = opened(moved / "paraview_state.py")
            self.assertEqual(blocks.files, [str(moved / "run.xdmf")])
            self.assertEqual((blocks.GridStatus, joints.GridStatus), (["blocks", "blocks[1]"], ["interfaces", "interfaces[1]"]))
            told = simple.PythonAnnotation.call_args.kwargs["Expression"]
            self.assertEqual(eval(told, {"time_value": 6.0}),
                             f"step 6: load factor {last['load_factor']:.5g}, load {last['load']:.5g}")
            self.assertEqual(eval(told, {"time_value": 99.0}), "")
            self.assertGreater(simple.WarpByVector.call_args.kwargs["ScaleFactor"], 1)
            names = simple.GetColorTransferFunction.return_value.Annotations
            self.assertEqual(names[::2], [str(i) for i in range(len(names) // 2)])


if __name__ == "__main__":
    unittest.main()
