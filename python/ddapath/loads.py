"""Loads as classes of Python, for trying.

    @ddapath.register_load("point_weights")
    class PointWeights(ddapath.Load):
        "The weight of each block, at its centroid."

        unit_weight = ddapath.Number("body_force", above=0, text="Weight of a volume.")

        def point_forces(self, blocks):
            weights = self.unit_weight * blocks.thickness * blocks.areas
            return [(place, (0, -weight)) for place, weight in zip(blocks.centroids, weights)]

A deck of `ddapath.follow` in the same process then says `loads: [{type: point_weights, unit_weight: 2.4e-5}]`.
"""

from .compiled import core
from .declared import Declaring, registered


class Load(Declaring):
    """Forces at points, at full value of the stage. A subclass gives `point_forces`; its Numbers are keys of the deck."""

    def point_forces(self, blocks):
        """((x, y), (Fx, Fy)) of each force [L, F]; blocks that meet at a point share it equally.

        blocks has arrays by block: centroids, n × 2 [L], areas [L²], outlines, a list of m × 2 [L], regions and materials,
        lists of names; and thickness [L]. It is asked again when cracks through blocks grow, and must answer the same.
        Points outside the structure are an InputError at the load's place in the deck.
        """
        raise NotImplementedError(f"{type(self).__name__}.point_forces(blocks) is to give places and forces")


def register_load(name):
    """Decorator of a Load: decks of this process may say `{type: name, ...}` among `loads` from then on.

    Under the same name a class with the same parameters replaces the earlier one, in paths that begin later. Throws TypeError
    for another class, ValueError for a name of the program's and for other parameters under the same name.
    """
    return registered(core().register_load, name, Load)
