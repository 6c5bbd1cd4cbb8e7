"""Exit 1 with the names of the data sets in which the fields of two runs differ, by shape, type or a single bit; dates may differ.

    same_fields.py RUN RUN
"""

import sys
from pathlib import Path

import h5py


def datasets(folder):
    """Content by name, such as 000034/displacement, of what is stored in a run folder."""
    found = {}
    for file in Path(folder, "fields").glob("*.h5"):
        with h5py.File(file) as stream:
            def keep(name, item, stem=file.stem):
                if isinstance(item, h5py.Dataset) and name != "provenance/date":
                    content = item[()].tobytes() if item.dtype.kind != "O" else item[()].tolist()
                    found[f"{stem}/{name}"] = (item.shape, str(item.dtype), content)
            stream.visititems(keep)
    return found


def main(arguments):
    one, other = (datasets(folder) for folder in arguments)
    different = sorted(name for name in one.keys() | other.keys() if one.get(name) != other.get(name))
    print("\n".join(different))
    return 1 if different or not one else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
