"""What classes of Python declare that decks may name: their numbers, with dimensions, bounds and defaults."""

from dataclasses import dataclass

# Powers of force and length that a number may have.
DIMENSIONS = {"none": (0, 0), "length": (0, 1), "area": (0, 2), "curvature": (0, -1), "force": (1, 0), "stress": (1, -2),
              "stiffness": (1, -1), "body_force": (1, -3), "interface_stiffness": (1, -3), "energy_per_area": (1, -1)}


@dataclass(frozen=True)
class Number:
    """A parameter of a law, a load or a control, a number in the deck: what it measures, its bounds, its default.

    dimension: a name of DIMENSIONS. above, at_least, below, at_most: bounds; None, there is none. fallback: None, the deck
    must give it. text: one sentence, which `dda explain` would print. name: taken from the attribute it is assigned to.
    """

    dimension: str = "none"
    fallback: float | None = None
    above: float | None = None
    at_least: float | None = None
    below: float | None = None
    at_most: float | None = None
    text: str = ""
    name: str = ""

    def __post_init__(self):
        if self.dimension not in DIMENSIONS:
            raise ValueError(f"there is no dimension '{self.dimension}'; there are {', '.join(DIMENSIONS)}")

    def __set_name__(self, owner, name):
        object.__setattr__(self, "name", name)

    @property
    def force(self):
        return DIMENSIONS[self.dimension][0]

    @property
    def length(self):
        return DIMENSIONS[self.dimension][1]


class Declaring:
    """What laws, loads and controls have: an object has the values of the deck in place of the Numbers of its class."""

    is_curve = False
    memory = ()

    def __init__(self, **numbers):
        for name, value in numbers.items():
            setattr(self, name, value)

    @classmethod
    def declared_numbers(cls):
        """The Numbers of the class and its bases, in the order of their declaration."""
        found = {}
        for base in reversed(cls.__mro__):
            found |= {name: value for name, value in vars(base).items() if isinstance(value, Number)}
        return list(found.values())


def registered(register, name, *bases):
    """Decorator that registers a class derived from one of the bases under a name; TypeError for another one."""
    def decorate(given):
        if not (isinstance(given, type) and issubclass(given, bases)):
            known = " or ".join(f"ddapath.{base.__name__}" for base in bases)
            raise TypeError(f"{given!r} is no such class: derive it from {known}")
        given.text = (given.__doc__ or given.__name__).strip().splitlines()[0]
        register(name, given)
        return given

    return decorate
