"""Commands that this Python does itself, with the exit codes of the program's."""

import argparse
import sys

from .errors import DdapathError, ToolMissing

DONE, WRONG_INPUT, FAILED, INTERRUPTED = 0, 2, 4, 130


class Parser(argparse.ArgumentParser):
    """Says in one line what is wrong, as the program does."""

    def error(self, message):
        self.exit(WRONG_INPUT, f"{self.prog}: {message.removeprefix('argument ')}; `{self.prog} --help` says what there is\n")


def number(text):
    """Of an option."""
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"expected a number, found '{text}'") from None


def exit_code(name, work):
    """Prints what `work()` says, or, behind the command's name, why it could not be done. 0 done, 2 what it was given cannot be
    used, 4 something is not installed, 130 Ctrl-C."""
    try:
        print(work())
        return DONE
    except KeyboardInterrupt:
        return INTERRUPTED
    except ToolMissing as error:
        return told(name, error, FAILED)
    except OSError as error:
        return told(name, f"{error.filename}: {error.strerror}", WRONG_INPUT)
    except (DdapathError, ValueError) as error:
        return told(name, getattr(error, "in_words", error), WRONG_INPUT)


def told(name, why, code):
    print(f"{name}: {why}", file=sys.stderr)
    return code
