"""Spread of the deck with instantaneous release over the kernels of OpenBLAS: results/spread.csv and its table in README.md.

    study.py --program DDA [--kernels NAME ...]
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))
from ddapath import coretype_spread  # noqa: E402

coretype_spread.main(HERE, "head", __doc__)
