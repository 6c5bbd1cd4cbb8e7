"""Scenes from pictures, drawings and finite-element meshes: dictionaries that are the section `scene` of a deck.

    from ddapath import scenes

    scene = scenes.scene_of_image("wall.png", width=2000, materials={"mortar": "#d8d0c0", "stone": "#806040"}, joint="mortar")
    scene = scenes.scene_of_labels(labels, ["stone"] * 200, width=2000)      # an array of whole numbers, a block for each
    scene = scenes.scene_of_svg("vault.svg", width=4000)
    scene = scenes.scene_of_dxf("section.dxf", scale=0.001)
    scene = scenes.scene_of_step("section.step")
    ddapath.write_deck(scenes.deck_to_begin_with(scene, {"length": "mm", "force": "N"}), "wall.yaml")

    elements = scenes.scene_of_elements("wall.inp", "wall.msh")              # each element a block
    ddapath.write_deck(scenes.deck_of_elements(elements, {"length": "mm", "force": "N"}), "wall.yaml")

Blocks of pictures and drawings are simple polygons, counter-clockwise, without holes; neighbours share their vertices exactly.
"""

from .drawing import scene_of_paths
from .dxf import scene_of_dxf
from .elements import scene_of_elements
from ..errors import ModuleMissing
from .faults import SceneError
from .image import scene_of_image, scene_of_labels
from .starter import deck_of_elements, deck_to_begin_with
from .step import scene_of_step
from .svg import scene_of_svg

__all__ = ["ModuleMissing", "SceneError", "deck_of_elements", "deck_to_begin_with", "scene_of_dxf", "scene_of_elements",
           "scene_of_image", "scene_of_labels", "scene_of_paths", "scene_of_step", "scene_of_svg"]
