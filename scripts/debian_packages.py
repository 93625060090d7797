"""Debian's packages as files: apt downloads them, nothing is installed, and no rights are needed."""

import pathlib
import re
import subprocess


class Failure(Exception):
    pass


def call(*command, folder=None, **options):
    """What a command prints, as bytes. Throws Failure with its complaint."""
    done = subprocess.run([str(word) for word in command], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          check=False, **options)
    if done.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))}: {done.stderr.decode(errors='replace').strip()}")
    return done.stdout


class DebianPackages:
    """Those for the processor of this computer, as far as apt knows them; or those for `architecture`, from where this
    computer has its own: what apt knows of them is kept in `folder` and is asked for anew with every object."""

    def __init__(self, architecture=None, folder=None):
        self._options = []
        if architecture is not None:
            self._options = other_architecture(architecture, pathlib.Path(folder).resolve())
            self._apt("apt-get", "update")

    def kernel(self, flavour):
        """The package of the newest kernel. Its name changes with its versions, so another package tells it."""
        told = self._apt("apt-cache", "depends", f"linux-image-{flavour}").decode()
        kernel = re.search(r"Depends: (linux-image-\S+)", told)
        if not kernel:
            raise Failure(f"linux-image-{flavour} names no kernel")
        return kernel[1]

    def with_dependencies(self, *packages):
        """As NAME=VERSION, with all that they need."""
        told = self._apt("apt-get", "install", "--simulate", "--no-install-recommends", *packages).decode()
        return [f"{name}={version}" for name, version in re.findall(r"^Inst (\S+) \((\S+) ", told, re.MULTILINE)]

    def download(self, folder, *packages):
        """Their files, in no order; `packages` may name versions."""
        folder.mkdir(parents=True)
        self._apt("apt-get", "download", *packages, folder=folder)
        return list(folder.iterdir())

    def _apt(self, program, *arguments, folder=None):
        try:
            return call(program, "--quiet", *self._options, *arguments, folder=folder)
        except Failure as failure:
            raise Failure(f"{failure}\napt has to know Debian 12's packages: scripts/install asks for them, and so does"
                          " apt-get update") from failure


def other_architecture(name, folder):
    for part in ("lists/partial", "cache/archives/partial"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    settings = {"APT::Architecture": name, "APT::Architectures": name, "Dir::State::Lists": folder / "lists",
                "Dir::Cache": folder / "cache", "Dir::State::status": "/dev/null", "Debug::NoLocking": "true"}
    return [word for key, value in settings.items() for word in ("-o", f"{key}={value}")]


def unpack(package, folder, *patterns):
    """The files of a package, or only those that fit any of `patterns`."""
    folder.mkdir(parents=True, exist_ok=True)
    if not patterns:
        call("dpkg-deb", "-x", package, folder)
        return
    archive = call("dpkg-deb", "--fsys-tarfile", package)
    call("tar", "-x", "-C", folder, "--wildcards", *(f"./{pattern}" for pattern in patterns), input=archive)
