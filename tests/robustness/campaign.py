"""What campaigns of random structures ask for on their command lines."""
import argparse
from pathlib import Path


def campaign_parser(description, count, seed):
    """A program, how many structures from which seed on, the control, and where decks and runs stay."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--seed", type=int, default=seed, help="of the first; each further one is one more")
    parser.add_argument("--control", default="staged")
    parser.add_argument("--folder", type=Path, help="where decks and runs stay")
    return parser
