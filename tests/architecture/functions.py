"""How long functions may be, and of how many parameters, as Universal Ctags counts them. Source: CONTRIBUTING.md."""

import json
import subprocess

import rules

LONGEST = 40
MOST_PARAMETERS = 4
MOST_OF_CONSTRUCTORS = 6  # they name what an object stands on
# Signatures that a library asks for: LOCA's step size, the vectors and operators of NOX and Anasazi.
GIVEN = {"computeStepSize", "update", "apply"}


def is_held_to_it(path):
    return rules.folder_of(path) is not None and path.endswith((".cpp", ".hpp"))


def tags(root, paths):
    """Every function with its first and last line and its parameters."""
    command = ["ctags", "--output-format=json", "--languages=C++", "--kinds-C++=f", "--fields=+neS", "-L", "-", "-f", "-"]
    found = subprocess.run(command, cwd=root, input="\n".join(paths), capture_output=True, text=True, check=True).stdout
    return [json.loads(line) for line in found.splitlines()]


def num_parameters(signature):
    """Of `(const A& a, std::map<B, C> b)`, say, 2."""
    depth, commas, inside = 0, 0, ""
    for letter in signature[signature.index("(") + 1 :]:
        if letter == ")" and depth == 0:
            break
        depth += (letter in "(<[{") - (letter in ")>]}")
        commas += letter == "," and depth == 0
        inside += letter
    return commas + 1 if inside.strip() else 0


def tag_findings(tag):
    lines = tag.get("end", tag["line"]) - tag["line"] + 1
    if lines > LONGEST:
        yield f"{tag['name']} has {lines} lines; a function has at most {LONGEST}"
    parameters = num_parameters(tag.get("signature", "()"))
    is_constructor = tag.get("scope", "").split("::")[-1] == tag["name"]
    most = MOST_OF_CONSTRUCTORS if is_constructor else MOST_PARAMETERS
    if parameters > most and tag["name"] not in GIVEN:
        yield f"{tag['name']} has {parameters} parameters; a {'constructor' if is_constructor else 'function'} has at most {most}"


def findings(root, paths):
    """Lines `path:line: message` about the functions of the house among these files."""
    held = sorted(filter(is_held_to_it, paths))
    return [f"{tag['path']}:{tag['line']}: {message}" for tag in tags(root, held) for message in tag_findings(tag)]
