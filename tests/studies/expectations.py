"""The subset of YAML that an expect.yaml uses: maps and lists by indentation, one scalar per line.

A scalar is a number where it reads as one, else text; comments stand on lines of their own or after two spaces.
"""


def parse(text):
    """The tree of a file."""
    rows = []
    for line in text.splitlines():
        content = line.split("  #")[0].rstrip()
        if content.strip() and not content.lstrip().startswith("#"):
            rows.append((len(content) - len(content.lstrip()), content.strip()))
    tree, rest = _block(rows)
    if rest:
        raise ValueError(f"unexpected indentation: {rest[0][1]}")
    return tree


def _block(rows):
    """What the first row's indentation holds together, and the rows after it."""
    if rows[0][1].startswith("- "):
        return _list(rows)
    return _map(rows)


def _list(rows):
    indentation, items = rows[0][0], []
    while rows and rows[0][0] == indentation and rows[0][1].startswith("- "):
        content = rows[0][1][2:].strip()
        if _is_entry(content):
            item, rows = _map([(indentation + 2, content), *rows[1:]])
        else:
            item, rows = scalar(content), rows[1:]
        items.append(item)
    return items, rows


def _map(rows):
    indentation, entries = rows[0][0], {}
    while rows and rows[0][0] == indentation and _is_entry(rows[0][1]):
        name, _, value = rows[0][1].partition(":")
        if name in entries:
            raise ValueError(f"'{name}' appears twice")
        rows = rows[1:]
        if value:
            entries[name] = scalar(value.strip())
        else:
            entries[name], rows = _block(rows)
    return entries, rows


def _is_entry(content):
    """`name:` or `name: value`, the name a plain word."""
    name, colon, value = content.partition(":")
    return bool(colon) and name.replace("_", "").isalnum() and (not value or value.startswith(" "))


def scalar(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
