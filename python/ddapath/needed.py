"""What only a part of the package needs, imported when that part is asked for."""

import importlib

from .errors import ModuleMissing


def needed(module, how):
    """The module. `how` is the command that installs it; throws ModuleMissing, which says so."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ModuleMissing(f"this needs the Python module {module}, which is not installed: {how}") from error


def from_debian(module, package):
    """The module, which Debian has in a package."""
    return needed(module, f"apt-get install {package}")
