"""What can go wrong while a scene is made of a picture or a drawing."""

from ..errors import DdapathError


class SceneError(DdapathError):
    """No scene can be made of it; the message has the file, the place, and what to do."""
