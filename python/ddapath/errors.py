"""What can go wrong. Every error is a DdapathError; those of the program carry its message and exit code."""


class DdapathError(Exception):
    """Any error of this package."""


class NotFound(DdapathError):
    """There is no such deck, run or sweep."""


class IsSweep(NotFound):
    """The folder is a sweep's. `in_words` is the message for who has typed a command."""

    def __init__(self, path):
        super().__init__(f"{path}: this is a sweep; use read_sweep, or read_run on one of {path}/cases/*")
        self.in_words = f"{path}: this is a sweep; give one of its runs, {path}/cases/*"


class NothingStored(DdapathError):
    """The run is one, but does not (yet) hold what was asked for."""


class ProgramNotFound(DdapathError):
    """There is no program `dda` to start."""


class ToolMissing(DdapathError):
    """Something that only this needs is not installed; the message says how to get it."""


class ModuleMissing(ToolMissing, ImportError):
    """A module of Python is."""


class ProgramFailed(DdapathError):
    """The program ended with an exit code that is none of those below: killed, or broken.

    `exit_code` is negative after a signal; `said` is all that it printed.
    """

    def __init__(self, message, exit_code=None, said=""):
        super().__init__(message)
        self.exit_code, self.said = exit_code, said


class InputError(ProgramFailed):
    """Exit code 2: the deck or a setting is wrong; nothing was written. The message has every place and what to do.

    `findings` are, of `follow`, all of them as pairs (place, what); the place in a dictionary is named by its keys,
    "deck: interfaces.joints.law".
    """

    findings = ()


class OutputError(ProgramFailed):
    """Exit code 4: the results could not be written, or an internal error."""


class Interrupted(ProgramFailed):
    """Exit code 130; `dda resume` continues."""


class StoppedEarly(ProgramFailed):
    """Exit code 3: the path ended before its goal. `results` holds what was reached, which is valid."""

    results = None
