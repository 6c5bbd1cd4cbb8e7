"""Starts `dda` and turns what it says into results or errors."""

import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from . import deck as decks
from .errors import InputError, Interrupted, NotFound, OutputError, ProgramFailed, ProgramNotFound, StoppedEarly
from .run_folder import read_run
from .sweep_folder import read_sweep

PACKAGE = Path(__file__).resolve().parent
CHECKOUT = PACKAGE.parents[1]
INSTALLED = ("share", "ddapath", "python", "ddapath")  # below the prefix of an installation
ERRORS = {2: InputError, 3: StoppedEarly, 4: OutputError, 130: Interrupted}


def own_programs():
    """Where the program of this very package may be: in its wheel, its installation, or its checkout when built."""
    yield PACKAGE / "installation" / "bin" / "dda"
    if PACKAGE.parts[-4:] == INSTALLED:
        yield PACKAGE.parents[3] / "bin" / "dda"
    yield CHECKOUT / "build" / "release" / "bin" / "dda"


def find_program():
    """The program: $DDA, else the one that came with this package, else dda on the PATH."""
    named = os.environ.get("DDA")
    if named:
        found = shutil.which(named)
        if not found:
            raise ProgramNotFound(f"the environment variable DDA is '{named}', which is no program")
        return found
    for found in map(shutil.which, (*map(str, own_programs()), "dda")):
        if found:
            return found
    builds = f"build it with {CHECKOUT}/bootstrap build" if (CHECKOUT / "bootstrap").exists() else "install it"
    raise ProgramNotFound(f"there is no program dda: {builds}, put it on the PATH, or set DDA to its path")


def run(deck, settings=None, folder=None, *, overwrite=False, check=True, plugins=()):
    """Follows the path of a deck, a file or a dictionary, and returns the Run.

    settings: values of the deck by dotted key, {"interfaces.ligament.law.fracture_energy": 0.1}, in the deck's units.
    folder: where the results go, by default runs/<name of the deck>; `overwrite` replaces those of an earlier run.
    plugins: files of libraries with laws, loads ... of one's own.
    Throws InputError, OutputError or Interrupted with the program's message; for a path that ended before its goal
    StoppedEarly, which has the Run as `results`. With check=False such a run is returned like any other: see its status.
    """
    arguments = setting_options(settings) + plugin_options(plugins)
    return started("run", (deck, folder, overwrite, check), arguments, read_run)


def sweep(deck, axes=None, folder=None, *, jobs=None, overwrite=False, check=True, plugins=()):
    """Runs every case of a sweep and returns its table, as read_sweep does.

    deck: a sweep's file or dictionary, with its section `sweep`; or, with `axes`, the base deck.
    axes: the section `sweep`: {"scene.parameters.depth": [50, 100], "seed": "1..20", "zip": {...}}.
    jobs: how many cases run at a time; by default the program decides. See `run` for the rest; here StoppedEarly means that
    some case stopped early or failed, and its `results` are the table.
    """
    arguments = [] if jobs is None else ["--jobs", str(jobs)]
    return started("sweep", (with_axes(deck, axes), folder, overwrite, check), arguments + plugin_options(plugins), read_sweep)


def resume(folder, settings=None, into=None, *, check=True, plugins=()):
    """Goes on with a run or a sweep that was interrupted, has stopped early, or is to go further; gives the Run or the table.

    settings: values of the deck that have changed, {"path.stop.load_below": 0.05}. into: another folder, for a copy that goes
    on while this one stays. See `run` for the rest.
    """
    path, options = Path(folder), setting_options(settings) + plugin_options(plugins)
    if not path.is_dir():
        raise NotFound(f"{path}: there is no such folder")
    read = read_sweep if (path / "sweep.json").exists() else read_run
    target = [] if into is None else ["--folder", str(into)]
    code, said = called("resume", str(path), "--quiet", *target, *options)
    return concluded(code, said, (path if into is None else Path(into), read), check)


def check(deck, settings=None, *, plugins=()):
    """What `dda check` tells of a deck, a file or a dictionary, as a text: blocks, interfaces, unknowns, memory, gauges, and
    warnings of results that are none. It is meshed, nothing is computed or written. Throws InputError for a wrong one."""
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch:
        code, said = called("check", str(as_file(deck, Path(scratch))), *setting_options(settings), *plugin_options(plugins))
    if code != 0:
        raise failure(code, said, None)
    return said


def report(folder, page=None, cases=False):
    """Writes the report of a run or a sweep, one page of HTML that needs nothing else, and gives its path.

    folder: or a Run. page: where it goes, by default report.html in the folder. cases: those of a sweep's cases, too.
    """
    path = Path(getattr(folder, "folder", folder))
    code, said = called("report", str(path), *([] if page is None else ["--out", str(page)]), *(["--cases"] if cases else []))
    if code != 0:
        raise failure(code, said, None)
    return path / "report.html" if page is None else Path(page)


def with_axes(deck, axes):
    """The file or dictionary of a sweep."""
    if axes is None:
        return deck
    if isinstance(deck, dict):
        return {**deck, "sweep": axes}
    return {"sweep": {"deck": str(Path(deck).resolve()), **axes}}


def setting(key, value):
    """`key=value` for the command line; JSON is YAML."""
    return f"{key}={json.dumps(decks.plain(value), allow_nan=False, ensure_ascii=False)}"


def setting_options(settings):
    """Values by dotted key as options of the command line."""
    return [part for key, value in (settings or {}).items() for part in ("--set", setting(key, value))]


def plugin_options(plugins):
    """Files of plugins as options of the command line."""
    return [f"--plugin={Path(plugin)}" for plugin in plugins]


def started(command, what, arguments, read):
    """Runs `dda COMMAND`; `what` is (deck, folder, overwrite, check), `read` makes the results of the folder."""
    deck, folder, overwrite, check = what
    folder = Path(folder) if folder is not None else default_folder(deck)
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch:
        file = as_file(deck, Path(scratch))
        options = ["--folder", folder, "--quiet", *(["--overwrite"] if overwrite else []), *arguments]
        code, said = called(command, file, *options)
    return concluded(code, said, (folder, read), check)


def called(*words):
    """Exit code of `dda WORDS`, and what it said."""
    done = subprocess.run([find_program(), *words], capture_output=True, text=True, check=False)
    return done.returncode, "\n".join(part.strip() for part in (done.stdout, done.stderr) if part.strip())


def concluded(code, said, results, check):
    """What `results`, (folder, its reader), are, or the error of the exit code."""
    folder, read = results
    if code == 0 or (code == 3 and not check):
        return read(folder)
    raise failure(code, said, results)


def failure(code, said, results):
    """The error of an exit code; `results` is (folder, its reader)."""
    message = said or f"the program said nothing; exit code {code}"
    error = ERRORS.get(code, ProgramFailed)(message, code, said)
    if code == 3:
        folder, read = results
        error.results = read(folder)
    return error


def default_folder(deck):
    """runs/<name>, as the program names it: after the file, or after its folder where the file is called deck."""
    if isinstance(deck, dict):
        raise ValueError("a deck that is no file has no name to put its results under: give a folder")
    file = Path(deck).resolve()
    return Path("runs") / (file.parent.name if file.stem == "deck" else file.stem)


def as_file(deck, scratch):
    """The file of a deck: its own, or one in `scratch`, whose relative file names are those of the current folder."""
    if isinstance(deck, dict):
        return decks.write_deck(decks.with_absolute_files(deck, Path.cwd()), scratch / "deck.yaml")
    file = Path(deck)
    if not file.is_file():
        raise NotFound(f"{file}: there is no such deck")
    return file
