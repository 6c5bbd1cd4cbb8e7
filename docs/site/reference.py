"""The deck reference as Markdown pages, from the JSON schema that `dda explain --json` prints.

    reference_pages(schema, parameters) -> {name of the page: text}, "deck" first, then a page per family

Every key stands in a table with its type, default, unit and bounds, and text; what is required says so.
"""

import json

HEAD = "| key | type | default | bounds | |\n|---|---|---|---|---|\n"
BOUNDS = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}


def bare(schema):
    """A schema without what only wraps it: a value that may be absent, a reference with a text beside it."""
    if "allOf" in schema:
        return schema["allOf"][0]
    if {"type": "null"} in schema.get("anyOf", []):
        return bare(schema["anyOf"][0])
    return schema


def innermost(schema):
    """What a list or a map is made of in the end."""
    one = bare(schema)
    inner = one.get("items") if not is_point(one) else None
    inner = inner or (one.get("additionalProperties") or None)
    if not inner and "anyOf" in one:
        inner = next((item for item in one["anyOf"] if item.get("type") == "array" and not is_point(item)), None)
    return innermost(inner) if inner else one


def is_point(schema):
    return schema.get("type") == "array" and schema.get("maxItems") == 2 and "items" in schema


def number(value):
    return f"{value:g}" if isinstance(value, (int, float)) and not isinstance(value, bool) else str(value)


def kind(schema, anchor):
    """The type of a value in words, with a link to the section or the family that it is."""
    one = bare(schema)
    if "$ref" in one:
        name = one["$ref"].rsplit("/", 1)[1]
        return f"[{name}]({name}.md)"
    if is_point(one):
        return "point [x, y]"
    if "properties" in one:
        return f"[section](#{anchor})"
    if "enum" in one:
        return ", ".join(f"`{word}`" for word in one["enum"])
    if "anyOf" in one:
        return " or ".join("a name" if item.get("type") == "string" else kind(item, anchor) for item in one["anyOf"])
    if one.get("type") == "array":
        return f"list of {kind(one['items'], anchor)}"
    if "additionalProperties" in one:
        return f"map of names to {kind(one['additionalProperties'], anchor)}"
    return {"integer": "integer", "number": "number", "boolean": "true or false"}.get(str(one.get("type")), "text")


def bounds(schema):
    one = innermost(schema)
    words = [f"{sign} {number(one[name])}" for name, sign in BOUNDS.items() if name in one]
    if "unit" in one:
        words.append(one["unit"])
    return ", ".join(words)


def default(name, schema, required):
    if name in required:
        return "**required**"
    value = schema.get("default", bare(schema).get("default"))
    if value is None or value in ({}, [], ""):
        return "–"
    if isinstance(value, float):
        return f"`{value:g}`"
    return f"`{value}`" if isinstance(value, str) else f"`{json.dumps(value, ensure_ascii=False)}`"


def cell(text):
    return text.replace("|", "&#124;").replace("\n", " ").replace("<", "&lt;")


def anchor_of(path):
    return path.replace(".", "")


def table(schema, path):
    """The table of a section's keys, and the tables of the sections in it, each under its path."""
    rows, below = "", ""
    required = schema.get("required", [])
    for name, value in schema["properties"].items():
        if name == "type" and "const" in value:
            continue
        inner = f"{path}.{name}" if path else name
        rows += f"| `{name}` | {kind(value, anchor_of(inner))} | {default(name, value, required)} | {bounds(value)} | " \
                f"{cell(value.get('description', ''))} |\n"
        section = innermost(value)
        if "properties" in section:
            below += f"\n## {inner}\n\n{section.get('description', '')}\n\n{table(section, inner)}"
    return (HEAD + rows if rows else "It has no parameters.\n") + below


def deck_page(schema):
    return f"# The deck\n\n{schema['description']} This is what `dda explain` knows; [the manual](../manual/deck.md) " \
           f"has an example.\n\n{table(schema, '')}"


def members(family):
    """Schemas of a family's members; where a name alone may stand they are behind `else`."""
    return [case["then"] for case in family.get("else", family)["allOf"]]


def family_page(name, family):
    out = f"# {name}\n\n{family['description']}\n"
    for member in members(family):
        word = member["properties"]["type"]["const"]
        lone = " The name alone is enough: all of it has defaults." * (member.get("required") == ["type"])
        keys = table(member, "").replace("\n## ", "\n### ")
        out += f"\n## {word}\n\n`type: {word}`. {member['description']}{lone}\n\n{keys}"
    return out


def reference_pages(schema, parameters):
    families = {name: family for name, family in schema["definitions"].items()
                if name not in ("deck", "sweep") and not name.startswith("partial-")}
    deck = schema["definitions"]["deck"]
    deck["properties"]["sweep"].pop("allOf")  # its page is that of sweeps in the manual
    pages = {"deck": deck_page(deck)}
    for name, family in sorted(families.items()):
        pages[name] = family_page(name, family)
    pages["parameter_lists"] = f"# Parameter lists\n\n```text\n{parameters}```\n"
    return pages
