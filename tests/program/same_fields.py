"""Exit 1 with the names of the data sets in which two run.h5 differ, by shape, type or a single bit; dates may differ.

    same_fields.py FILE FILE
"""

import sys

import h5py


def datasets(file):
    found = {}
    with h5py.File(file) as stream:
        def keep(name, item):
            if isinstance(item, h5py.Dataset) and name != "provenance/date":
                found[name] = (item.shape, str(item.dtype), item[()].tobytes() if item.dtype.kind != "O" else item[()].tolist())
        stream.visititems(keep)
    return found


def main(arguments):
    one, other = (datasets(file) for file in arguments)
    different = sorted(name for name in one.keys() | other.keys() if one.get(name) != other.get(name))
    print("\n".join(different))
    return 1 if different or not one else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
