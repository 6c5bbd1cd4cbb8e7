"""What can go wrong while a scene is made of a picture or a drawing."""

import importlib

from ..errors import DdapathError


class SceneError(DdapathError):
    """No scene can be made of it; the message has the file, the place, and what to do."""


class ModuleMissing(DdapathError):
    """A module of Python that only this needs is not installed; the message has the name of its package."""


def needed(module, package):
    """The module, imported when it is asked for. Throws ModuleMissing with the name of Debian's package."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ModuleMissing(f"this needs the Python module {module}, in Debian's package {package}: "
                            f"apt-get install {package}") from error
