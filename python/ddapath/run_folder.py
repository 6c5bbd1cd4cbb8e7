"""A run folder, finished or not, read piece by piece as it is asked for."""

import io
import json
import re
import zlib
from contextlib import contextmanager
from html import escape
from pathlib import Path

import h5py
import pandas as pd

from . import deck as decks
from .errors import IsSweep, NotFound, NothingStored
from .fields import read_fields, read_mesh

MESH = "fields/mesh.h5"  # beside it a file for each stored step, fields/000034.h5


def whole_lines(file):
    """The text up to its last line break: a running or killed program may be in the middle of a line."""
    text = file.read_text(encoding="utf-8")
    return text[:text.rfind("\n") + 1]


def read_numbers(text):
    """A table of numbers and words; numbers that are whole but longer than 64 bits, which pandas takes for words, are numbers too."""
    table = pd.read_csv(io.StringIO(text), float_precision="round_trip")
    for name in table.columns[table.dtypes == object]:
        try:
            table[name] = table[name].astype(float)
        except (TypeError, ValueError):
            pass  # words
    return table


def sealed(content):
    """The bytes of an HDF5 file with the line behind them that holds their checksum."""
    return content + b"ddapath checksum %08x\n" % zlib.crc32(content)


def check_seal(file):
    """Throws NothingStored for a damaged file, which must not even be opened: HDF5 may loop for ever in it."""
    stored = file.read_bytes()
    if stored != sealed(stored[:-len(sealed(b""))]):
        raise NothingStored(f"{file}: cannot be read: its checksum does not fit its content")


@contextmanager
def opened(file):
    """A file of the fields for reading; it is whole as soon as it is there."""
    try:
        check_seal(file)
        store = h5py.File(file, "r")
    except OSError as error:
        raise NothingStored(f"{file}: cannot be read: {error}") from error
    with store:
        yield store


class Run:
    """The results in a run folder; every piece is read when it is asked for, so that a running program can be watched.

    folder     the folder, a Path
    status     goal_reached, stopped_early, interrupted; "unfinished" as long as there is no summary
    summary    summary.json, a dictionary; empty for an unfinished run
    curve      curve.csv, a DataFrame with a row per accepted step; attrs["units"] has the unit of each column
    deck       the effective deck, a dictionary: every parameter with its value
    log        log.jsonl, a list of dictionaries
    steps      numbers of the steps whose fields are stored
    fields(step)   the fields of a stored step, see Fields; the last one if no step is given
    all_fields()   those of every stored step, one after the other
    cracks(step)   the pieces of cracks through blocks at a stored step, a DataFrame: Fields.cracks
    crack_path(crack, step)   corners of the line along which a crack has grown until then, n × 2
    motion     what has moved from the end of the path on, see Motion
    to_pyvista(step), to_meshio(step)   the fields of a stored step as a mesh of these libraries
    animate(file, fps, speed, path, magnification)   writes the motion as a GIF or MP4, see ddapath.animation
    """

    TABLE = FIGURE = "curve"

    def __init__(self, folder):
        self.folder = Path(folder)

    def __repr__(self):
        return f"<run {self.folder}: {self.status}>"

    @property
    def status(self):
        return self.summary.get("status", "unfinished")

    @property
    def summary(self):
        file = self.folder / "summary.json"
        return json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}

    @property
    def curve(self):
        text = whole_lines(self._file(f"{self.TABLE}.csv"))
        table = read_numbers(text) if text else pd.DataFrame()
        units = self.folder / f"{self.TABLE}.units.json"
        table.attrs["units"] = json.loads(units.read_text(encoding="utf-8")) if units.exists() else {}
        return table

    @property
    def deck(self):
        return decks.load(self._file("effective_deck.yaml").read_text(encoding="utf-8"))

    @property
    def log(self):
        return [json.loads(line) for line in whole_lines(self._file("log.jsonl")).splitlines() if line]

    @property
    def steps(self):
        return sorted(self._step_files())

    def fields(self, step=None):
        files = self._step_files()
        if not files:
            raise NothingStored(f"{self.folder}: no fields are stored (yet); `record.fields_every` says how often")
        step = max(files) if step is None else step
        if step not in files:
            stored = ", ".join(str(known) for known in sorted(files))
            raise NothingStored(f"{self.folder}: the fields of step {step} are not stored; those of {stored} are")
        with opened(self._file(MESH)) as mesh, opened(files[step]) as fields:
            return read_fields(read_mesh(mesh), fields)

    def all_fields(self):
        with opened(self._file(MESH)) as file:
            mesh = read_mesh(file)
        for _, file in sorted(self._step_files().items()):
            with opened(file) as fields:
                yield read_fields(mesh, fields)

    def cracks(self, step=None):
        return self.fields(step).cracks

    def crack_path(self, crack=0, step=None):
        return self.fields(step).crack_path(crack)

    @property
    def motion(self):
        folder = self.folder / "motion"
        if not folder.is_dir():
            raise NothingStored(f"{self.folder}: nothing has moved (yet); `motion` in the deck lets the structure go")
        return Motion(folder)

    def to_pyvista(self, step=None):
        """The fields of a stored step as pyvista.PolyData: deformed outlines of the blocks, with displacement, strain ..."""
        from .meshes import fields_to_pyvista  # pyvista is loaded by none who does not ask

        return fields_to_pyvista(self.fields(step))

    def to_meshio(self, step=None):
        """The fields of a stored step as meshio.Mesh: outlines of the blocks, undeformed, with displacement, strain ..."""
        from .meshes import fields_to_meshio

        return fields_to_meshio(self.fields(step))

    def _repr_svg_(self):
        """The curve, of a motion its end, for a notebook; None as long as there is no figure."""
        file = self.folder / f"{self.FIGURE}.svg"
        return file.read_text(encoding="utf-8") if file.exists() else None

    def _repr_html_(self):
        """Status, peak and the curve, for a notebook."""
        summary = self.summary
        lines = [f"<b>{escape(str(self.folder))}</b>: {escape(self.status)} {escape(summary.get('reason', ''))}"]
        if "peak" in summary:
            unit = summary.get("units", {}).get("force", "")
            lines.append(f"peak {summary['peak']['load']:.6g} {escape(unit)} at step {summary['peak']['step']}, "
                         f"{summary['steps']} steps")
        return f"<div>{'<br>'.join(lines)}{self._repr_svg_() or ''}</div>"

    def animate(self, file=None, **wishes):
        from .animation import Wishes, animate  # matplotlib is loaded by none who does not draw

        return animate(self, file, Wishes(**wishes))

    def _step_files(self):
        """Step → file."""
        beside = self._file(MESH).parent.glob("*.h5")
        return {int(file.stem): file for file in beside if re.fullmatch("[0-9]{6,}", file.stem)}

    def _file(self, name):
        file = self.folder / name
        if not file.exists():
            raise NothingStored(f"{self.folder}: this run has no {name} (yet)")
        return file


class Motion(Run):
    """What a run has stored of the motion behind its path.

    curve          motion.csv, a DataFrame with a row per time step: time, energies; attrs["units"]
    steps          numbers of the time steps whose fields are stored
    fields(step)   displacement, velocity and rotation of the blocks; the last ones if no step is given
    """

    TABLE, FIGURE = "motion", "end"


def read_run(folder):
    """The run in a folder, also an unfinished one. Throws NotFound, with a hint, for any other folder."""
    path = Path(folder)
    if not path.is_dir():
        what = "is a file; the folder that `dda run` wrote is wanted" if path.exists() else "there is no such folder"
        raise NotFound(f"{path}: {what}")
    if (path / "sweep.json").exists():
        raise IsSweep(path)
    if not (path / "effective_deck.yaml").exists():
        raise NotFound(f"{path}: this is no run folder, it has no effective_deck.yaml{nearby(path)}")
    return Run(path)


def nearby(path):
    """A hint at the run folders right below, if there are any."""
    found = sorted(below.parent.name for below in path.glob("*/effective_deck.yaml"))
    return f"; but these in it are: {', '.join(found[:5])}{', …' if len(found) > 5 else ''}" if found else ""
