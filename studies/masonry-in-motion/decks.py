"""Decks to run and to learn from, and the figures of where they end: name → deck, files relative to the study's folder."""

from arches import ABUTMENTS, FLAT, IMPOSTS, SPREADING, ground_below
from ddapath.deck import lines
from shapes import GRAVITY, between_abutments, box, deck, flat_arch, semicircular_arch
from walls import TIMES, earthquake, leaf, text_of_record, wall

FLOOR = box(-2.5, -0.7, 2.5, -0.5)
FRAMES = {"frame_every": 0.02}


def semicircular():
    """Friction of 0.32 where 0.351 is needed."""
    return deck("Semicircular arch with too little friction", semicircular_arch(20, 0.15) | {"floor": FLOOR},
                (*IMPOSTS, "floor"), 0.32, time=3, gauges={"crown": ((0, 0.925), (0, -1))}, **FRAMES)


def flat():
    """Friction of 0.18 where 0.198 is needed."""
    return deck("Flat arch with too little friction", between_abutments(flat_arch(9, **FLAT), **FLAT) | {"floor": FLOOR},
                (*ABUTMENTS, "floor"), 0.18, time=3, gauges={"crown": ((0, 0), (0, -1))}, **FRAMES)


def spreading(spread=0.1):
    """To just before collapse: three hinges are open."""
    moves = [{"regions": [name], "direction": [sign, 0],
              "displacement": {"type": "table", "times": [0, 5, 100], "values": [0, spread / 2, spread / 2]}}
             for name, sign in zip(IMPOSTS, (1, -1))]
    return deck("Semicircular arch whose supports spread", semicircular_arch(**SPREADING), [], 1.0, time=6, driven=moves,
                materials=ground_below(IMPOSTS), gauges={"crown": ((0, 1 - SPREADING["thickness"] / 2), (0, -1))},
                frame_every=0.1)


PULSE = "time,acceleration\n0,2\n0.45,2\n0.451,-2\n0.901,-2\n0.902,0\n10,0\n"  # a full cycle, about 2 g b/h


def out_of_plane():
    return leaf({"type": "record", "file": "pulse.csv"}, 5, frame_every=0.02, stop_at_rest=True)


def in_plane():
    """The record three times as strong as in the table, without a damp-proof course."""
    moves = {"type": "record", "file": "earthquake.csv", "factor": 3 * GRAVITY}
    return wall(moves, 6, course=0.7, frame_every=0.04, stop_at_rest=True)


DECKS = {"semicircular-arch": semicircular, "flat-arch": flat, "spreading-supports": spreading,
         "wall-out-of-plane": out_of_plane, "wall-in-plane": in_plane}


def write(folder):
    """The decks, their places to a tenth of a micrometre so that joints meet, and the records they need."""
    (folder / "earthquake.csv").write_text(text_of_record(earthquake, TIMES), encoding="utf-8")
    (folder / "pulse.csv").write_text(PULSE, encoding="utf-8")
    for name, make in DECKS.items():
        (folder / f"{name}.yaml").write_text(lines(make(), schema="../../deck.schema.json"), encoding="utf-8")
