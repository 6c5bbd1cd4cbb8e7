"""The picture, the blocks that are made of it, how they fail, and where they go."""

from ddapath import study
from matplotlib.collections import PolyCollection
from PIL import Image

STONE, GROUND = "#b9ab95", "#8f8f8f"


def blocks(axis, polygons, regions):
    colours = [GROUND if region == 0 else STONE for region in regions]
    axis.add_collection(PolyCollection(polygons, facecolors=colours, edgecolors="black", linewidths=0.6))


def draw(folder, scene, run):
    pyplot = study.plots("rubble")
    figure, axes = pyplot.subplots(1, 4, figsize=(12, 4.4), sharey=True, layout="constrained")
    width, height = (max(corner[axis] for region in scene["regions"][1:] for corner in region["vertices"]) for axis in (0, 1))
    axes[0].imshow(Image.open(folder / "wall.jpg"), extent=(0, width, 0, height), interpolation="nearest")
    corners = [region["vertices"] for region in scene["regions"]]
    blocks(axes[1], corners, range(len(corners)))
    path, motion = run.fields(run.steps[-1]), run.motion.fields()
    magnified = 10
    blocks(axes[2], path.polygons(magnified), path.polygon_regions)
    blocks(axes[3], motion.polygons(1), motion.polygon_regions)
    limit, time = run.curve.load_factor.max(), run.summary["motion"]["time"]
    titles = ("the picture", f"{len(corners) - 1} stones of it", f"at {limit:.3f} of the weight, × {magnified}", f"{time:.2g} s later")
    for axis, title in zip(axes, titles):
        axis.set(title=title, xlabel="x [m]", xlim=(-0.5, width + 0.5), ylim=(-0.3, height + 0.2), aspect="equal")
    axes[0].set_ylabel("y [m]")
    study.save(figure, folder / "wall.svg")
