import csv
import os

from paraview.simple import *  # noqa: F403

if "__file__" in globals() and os.path.exists(os.path.join(os.path.dirname(os.path.abspath(__file__)), "run.xdmf")):
    FOLDER = os.path.dirname(os.path.abspath(__file__))  # where this file is now


def grids(*kinds):
    """The grids of these kinds, of every stored step."""
    reader = XDMFReader(FileNames=[os.path.join(FOLDER, "run.xdmf")])
    reader.UpdatePipelineInformation()
    reader.GridStatus = [name for name in reader.GridStatus if name.split("[")[0] in kinds]
    return reader


def coloured(source, array, title, **shown):
    display = Show(source, view)
    for name, value in shown.items():
        setattr(display, name, value)
    ColorBy(display, ("CELLS", array))
    display.RescaleTransferFunctionToDataRange(False, True)
    bar = GetScalarBar(GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = title, ""
    display.SetScalarBarVisibility(view, True)
    return display


LoadPalette(paletteName="WhiteBackground")
view = GetActiveViewOrCreate("RenderView")
view.InteractionMode, view.OrientationAxesVisibility = "2D", 0
blocks = grids("blocks", "parts")
moved = WarpByVector(registrationName="blocks, moved", Input=blocks, Vectors=["POINTS", "displacement"], ScaleFactor=SCALE)
cracks = WarpByVector(registrationName="joints, moved", Input=grids("interfaces", "cracks"), Vectors=["POINTS", "displacement"],
                      ScaleFactor=SCALE)
cracked = Threshold(registrationName="cracks", Input=cracks, Scalars=["CELLS", "damage"], LowerThreshold=1e-12, UpperThreshold=1)

scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()
coloured(moved, "principal_stress_1", f"larger principal stress [{STRESS_UNIT}]", Representation="Surface With Edges",
         EdgeColor=[0.6, 0.6, 0.6])
coloured(cracked, "opening_n", f"opening [{LENGTH_UNIT}]", LineWidth=3)
GetColorTransferFunction("opening_n").ApplyPreset("Black-Body Radiation", True)
names = GetColorTransferFunction("region")
names.InterpretValuesAsCategories = 1
names.Annotations = [text for number, name in enumerate(REGIONS) for text in (str(number), name)]

with open(os.path.join(FOLDER, "curve.csv"), encoding="utf-8") as file:
    rows = {int(row["step"]): row for row in csv.DictReader(file)}
texts = {step: f"step {step}: load factor {float(row['load_factor']):.5g}, load {float(row['load']):.5g}" for step, row in rows.items()}
note = PythonAnnotation(registrationName="step and load", Input=blocks, ArrayAssociation="Field Data",
                        Expression=f"dict({list(texts.items())!r}).get(int(time_value), '')")
Show(note, view)
view.ResetCamera(True)
Render(view)
