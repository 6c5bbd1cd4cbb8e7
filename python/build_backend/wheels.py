"""Wheels of the package (PEP 517, PEP 427) by Python's own library alone, so that building one downloads nothing.

    installation=PREFIX     of `pip --config-settings`: a prefix of `cmake --install`, whose program the wheel carries;
                            it is then for this platform alone, and needs its libraries
"""
import base64
import hashlib
import io
import sysconfig
import tarfile
import tomllib
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parents[1]
CARRIED = ("bin/dda", "lib/ddapath", "share/ddapath/python")
EPOCH = (1980, 1, 1, 0, 0, 0)  # wheels of the same files are the same bytes
SOURCES = ("pyproject.toml", "README.md", "build_backend/*.py", "ddapath/**/*.py")


def project():
    return tomllib.loads((HERE / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def package():
    """{name in the wheel: file} of the package."""
    return {file.relative_to(HERE).as_posix(): file for file in sorted(HERE.glob("ddapath/**/*.py"))}


def carried(installation):
    """The same of what a run needs of an installation."""
    prefix = Path(installation).expanduser().resolve()
    if not (prefix / "bin" / "dda").is_file():
        raise SystemExit(f"installation={installation}: there is no bin/dda; it is the prefix of `cmake --install`")
    files = [file for name in CARRIED for file in sorted([prefix / name, *(prefix / name).rglob("*")])
             if file.is_file() and "__pycache__" not in file.parts]
    return {f"ddapath/installation/{file.relative_to(prefix).as_posix()}": file for file in files}


def metadata():
    about = project()
    lines = ["Metadata-Version: 2.1", f"Name: {about['name']}", f"Version: {about['version']}", f"Summary: {about['description']}",
             "License: BSD-3-Clause", f"Requires-Python: {about['requires-python']}",
             *(f"Requires-Dist: {name}" for name in about["dependencies"]), "Description-Content-Type: text/markdown"]
    return "\n".join(lines) + "\n\n" + (HERE / about["readme"]).read_text(encoding="utf-8")


def tag_of(installation):
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_") if installation else "any"
    return f"py3-none-{platform}"


class Wheel:
    """Writes files and the record of them."""

    def __init__(self, folder, tag):
        about = project()
        self.stem = f"{about['name']}-{about['version']}"
        self.tag, self.records = tag, []
        self.file = Path(folder) / f"{self.stem}-{tag}.whl"
        self.archive = zipfile.ZipFile(self.file, "w", zipfile.ZIP_DEFLATED)

    def add(self, name, content, mode=0o644):
        entry = zipfile.ZipInfo(name, EPOCH)
        entry.external_attr, entry.compress_type = (0o100000 | mode) << 16, zipfile.ZIP_DEFLATED
        self.archive.writestr(entry, content)
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        self.records.append(f"{name},sha256={digest},{len(content)}")

    def finish(self, is_pure):
        info = f"{self.stem}.dist-info"
        self.add(f"{info}/METADATA", metadata().encode())
        pure = "true" if is_pure else "false"
        self.add(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: ddapath\nRoot-Is-Purelib: {pure}\nTag: {self.tag}\n".encode())
        self.records.append(f"{info}/RECORD,,")
        self.archive.writestr(zipfile.ZipInfo(f"{info}/RECORD", EPOCH), "\n".join(self.records) + "\n")
        self.archive.close()
        return self.file.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    installation = (config_settings or {}).get("installation")
    wheel = Wheel(wheel_directory, tag_of(installation))
    for name, file in (package() | (carried(installation) if installation else {})).items():
        wheel.add(name, file.read_bytes(), file.stat().st_mode & 0o777)
    return wheel.finish(is_pure=not installation)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    wheel = Wheel(wheel_directory, tag_of(None))
    wheel.add("ddapath.pth", f"{HERE}\n".encode())
    return wheel.finish(is_pure=True)


def build_sdist(sdist_directory, config_settings=None):
    about = project()
    stem, about_file = f"{about['name']}-{about['version']}", metadata().encode()
    with tarfile.open(Path(sdist_directory) / f"{stem}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for file in sorted({file for pattern in SOURCES for file in HERE.glob(pattern)}):
            archive.add(file, f"{stem}/{file.relative_to(HERE).as_posix()}")
        entry = tarfile.TarInfo(f"{stem}/PKG-INFO")
        entry.size = len(about_file)
        archive.addfile(entry, io.BytesIO(about_file))
    return f"{stem}.tar.gz"
