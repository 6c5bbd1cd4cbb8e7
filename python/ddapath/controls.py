"""Controls as classes of Python, for trying.

    @ddapath.register_control("both_openings")
    class BothOpenings(ddapath.Control):
        "The sum of the openings of both notches."

        def prescribed(self, at):
            return {"left": 1, "right": 1}

A deck of `ddapath.follow` in the same process then says `control: both_openings`.
"""

from .compiled import core
from .declared import Declaring, registered


class Control(Declaring):
    """What a step prescribes: a combination c of gauges, chosen anew before each step; N = c − c_start − s.

    The path goes on by it in the direction of its tangent, whichever way c changes there, with steps sized as for other
    controls. A subclass gives `prescribed`; its Numbers are keys of the deck.
    """

    def prescribed(self, at):
        """{name: weight}: c = Σ weight · gauge; `load_factor` is one of the gauges.

        at.values[name] is a gauge here, at.rates[name] its rate along the tangent by which the path leaves. ValueError for
        an unknown name, and where c does not move along the tangent. The first crack is found by the event control.
        """
        raise NotImplementedError(f"{type(self).__name__}.prescribed(at) is to give names and weights of gauges")


def register_control(name):
    """Decorator of a Control: decks of this process may say `control: name` or `{type: name, ...}` from then on.

    Under the same name a class with the same parameters replaces the earlier one, in paths that begin later. Throws TypeError
    for another class, ValueError for a name of the program's and for other parameters under the same name.
    """
    return registered(core().register_control, name, Control)
