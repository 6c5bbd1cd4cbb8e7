"""Following a path point by point: `for point in ddapath.follow(deck)`."""

import json
from pathlib import Path as File

from . import deck as decks
from .compiled import core
from .errors import NotFound
from .meshes import outlines_to_meshio, outlines_to_pyvista
from .program import setting
from .run_folder import read_run


def follow(deck, settings=None, folder=None, *, overwrite=False, plugins=(), threads=None):
    """The path of a deck, a file or a dictionary, whose accepted points a loop takes one by one: a Path.

        path = ddapath.follow("beam.yaml")
        for point in path:
            if point.gauges["deflection"] > 0.3:
                path.stop()

    settings: values of the deck by dotted key, as of `run`. folder: where the results go, those of `dda run`; without one
    nothing is written. overwrite: replaces those of an earlier run. plugins: files of libraries with laws, loads ... of one's
    own. threads: that share the work; results are the same bits for any number of them.
    Throws InputError for what is wrong with the deck, with every place in its `findings`.
    """
    module = core()
    for plugin in plugins:
        module.load_plugin(str(plugin))
    if threads is not None:
        module.set_num_threads(threads)
    text, name = written(deck)
    words = [setting(key, value) for key, value in (settings or {}).items()]
    follower = module.Follower(text, name, words, isinstance(deck, dict))
    follower.begin(None if folder is None else str(folder), overwrite)
    return Path(follower)


def written(deck):
    """Text and name of a deck."""
    if isinstance(deck, dict):
        return decks.dump(decks.with_absolute_files(deck, File.cwd())), "deck"
    file = File(deck)
    if not file.is_file():
        raise NotFound(f"{file}: there is no such deck")
    return file.read_text(encoding="utf-8"), str(file)


class Point:
    """An accepted equilibrium of a path; it stays what it is when the path goes on. Numbers are in the deck's units.

    step, control        its number from 1 on, and by what the step was taken: a value of curve.csv's column `control`
    stage                number in the deck of the stage whose loads λ multiplies
    load_factor, load    λ and the load gauge
    gauges, reactions    dictionaries by name
    dissipated_energy, stored_energy, external_work
    iterations           Newton's, on all unknowns; relative_residual is what they left of the force level
    negative_eigenvalues, negative_under_control   of the stiffness: 0 where the equilibrium is stable under dead load, and
                         with the control held; None where that is not known
    landed               why fields are kept here: "deflection=0.1", "peak?"

    Arrays look at the program's own numbers: nothing is copied, and nothing can be written.

    displacements        n × 6, a row per block: u, v of the centroid [L], rotation, strains xx, yy, 2xy
    unknowns             all of them, 6 per node: those of the blocks, jumps across cuts, multipliers
    openings             m × 2, a row per point that can crack, (normal, tangential): how far it is open, w = q − P⁻¹ t [L]
    jumps, tractions     m × 2 likewise: [u] [L], t [F/L²]
    damage               m: 0 intact, 1 nothing left
    outlines             a dictionary: vertices k × 2 and their displacements k × 2 [L], offsets (outline i has the vertices
                         offsets[i] to offsets[i + 1]), region; a block that is cut has an outline per part
    """

    __slots__ = ("_core",)

    def __init__(self, core_point):
        self._core = core_point

    def __repr__(self):
        return f"<point {self.step}: load factor {self.load_factor:.6g}, load {self.load:.6g}, by {self.control}>"

    def to_pyvista(self):
        """The deformed outlines as pyvista.PolyData, a cell per outline, with `displacement` and `region`."""
        return outlines_to_pyvista(self.outlines)

    def to_meshio(self):
        """The undeformed outlines as meshio.Mesh, with `displacement` at the points and `region` of the cells."""
        return outlines_to_meshio(self.outlines)


def _delegated(name):
    return property(lambda self: getattr(self._core, name))


for _name in ("step", "control", "landed", "stage", "load_factor", "load", "gauges", "reactions", "dissipated_energy", "stored_energy",
              "external_work", "iterations", "relative_residual", "negative_eigenvalues", "negative_under_control",
              "displacements", "unknowns", "openings", "jumps", "tractions", "damage", "outlines"):
    setattr(Point, _name, _delegated(_name))


class Path:
    """A path that is followed: an iterator over its points, which goes on only when the next one is asked for.

    It may be steered between points: `stop()`, `next_step`, `control`. It ends at the deck's goal, when it is told to stop, or
    where no equilibrium follows; then `status` and `reason` say how and why, as of `dda run`. With a folder that has its
    results as soon as the path has ended or been closed; `run` reads them. A loop that is left by `break` has `interrupted` it
    when the path is closed, by `close()`, at the end of a `with` block, or with its last reference; `resume` goes on with such a
    run.

    Ctrl-C raises KeyboardInterrupt during a step, between two attempts of it: the path is then interrupted at its last point.
    What a law in Python raises comes out of the loop, too; the folder is left as of a run that was killed. Points that the
    path has given stay as they are.
    """

    def __init__(self, follower):
        self._follower, self._folder, self._is_broken = follower, None, False

    def __iter__(self):
        return self

    def __next__(self):
        try:
            point = self._follower.next()
        except KeyboardInterrupt:
            self.close()
            raise
        except BaseException:
            self._is_broken = True
            raise
        if point is None:
            self.close()
            raise StopIteration
        return Point(point)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        if getattr(self, "_follower", None) is not None:
            self.close()

    def __repr__(self):
        return f"<path at {self.here!r}: {self.status if self.has_ended else 'going on'}>"

    def close(self):
        """Ends the path, if it has not ended, as interrupted; writes what its run folder has at the end."""
        if self._is_broken:
            return
        self._follower.leave()
        self._folder = self._follower.conclude() or self._folder

    def stop(self, reason="stopped by the loop that followed it"):
        """Ends the path at the point where it stands, as a goal that it has reached."""
        self._follower.stop(reason)

    def load(self, *loads, name="loading"):
        """Holds all that acts as it is, and goes on with other loads, dictionaries as in `stages` of a deck, whose load factor
        begins at 0. What a displacement drives, an earlier stage has to have driven along the same direction. In a run folder
        they are a stage of `effective_deck.yaml` behind those of the deck, and the run is that of a deck that has it. InputError for
        loads that cannot serve, while stages of the deck are yet to come, and in a folder before the first step; the path
        then goes on as it did."""
        self._follower.go_on_with(json.dumps({"name": name, "loads": decks.plain(list(loads))}))

    @property
    def here(self):
        """The Point at which the path stands; before the first one its start, with the dead loads."""
        return Point(self._follower.here)

    @property
    def has_ended(self):
        return self._follower.has_ended

    @property
    def status(self):
        """goal_reached, stopped_early or interrupted; "running" until then."""
        return self._follower.status if self.has_ended else "running"

    @property
    def reason(self):
        return self._follower.reason

    @property
    def run(self):
        """The Run in its folder, once it has ended."""
        if self._folder is None:
            raise ValueError("this path has no run folder (yet): give `follow` a folder, and let the path end")
        return read_run(self._folder)

    @property
    def units(self):
        """Those of the deck: (length, force)."""
        return self._follower.units

    @property
    def notices(self):
        return self._follower.notices

    @property
    def next_step(self):
        """Size of the next step, which may be set: where cracks grow the energy that it spends along the tangent [F L], whatever
        the control, else the quantity that the control prescribes. 0 before the first step under a control. The path still
        shortens a step that finds no next point."""
        return self._follower.next_step

    @next_step.setter
    def next_step(self, size):
        self._follower.next_step = float(size)

    @property
    def control(self):
        """Name of the control; set it to another one, a name or a dictionary as in `path.control` of a deck. InputError for
        one that is unknown or cannot serve; the path keeps what it has."""
        return self._follower.control

    @control.setter
    def control(self, control):
        self._follower.control = json.dumps(decks.plain(control))

    @property
    def points(self):
        """Where the points that can crack stand: a dictionary with x and normal, m × 2, weight W [L²], m, and the name of the
        interface of each."""
        return self._follower.points()

    def stiffness(self):
        """K at the point where the path stands, with its damage and every point that has loaded loading: the symmetric part,
        n × n, a scipy.sparse matrix of 6 × 6 blocks. Unknowns are those of `Point.unknowns`."""
        from scipy.sparse import bsr_matrix  # of this function alone

        data, columns, starts = self._follower.stiffness()
        size = 6 * (len(starts) - 1)
        return bsr_matrix((data, columns, starts), shape=(size, size))

    def residual(self):
        """R at the point where the path stands, n [F, and F·L for rotations and strains]: what the solution leaves."""
        return self._follower.residual()

    def load_vector(self):
        """f = f_dead + λ f_reference there, n."""
        return self._follower.load_vector()

    def reference_load(self):
        """f_reference, n: what the load factor multiplies."""
        return self._follower.reference_load()

    def modes(self, count=6, mass="unit"):
        """Lowest eigenpairs of the stiffness there, K φ = μ M φ: μ ascending, and the φ as rows, φᵀ M φ = 1.

        mass: `unit`, of density 1; `density`, of the materials, each of which then needs one; `none`, identities. As
        `record.eigenvalues` of a deck has them: nothing is left of released points.
        """
        values, shapes, _ = self._follower.modes(count, mass)
        return values, shapes
