"""Debian's packages as files: apt downloads them, nothing is installed, and no rights are needed."""

import pathlib
import re
import subprocess


class Failure(Exception):
    pass


class CommandFailed(Failure):
    def __init__(self, command, complaint):
        super().__init__(f"{' '.join(map(str, command))}: {complaint}")
        self.complaint = complaint


def call(*command, folder=None, **options):
    """What a command prints, as bytes. Throws Failure with its complaint."""
    done = subprocess.run([str(word) for word in command], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          check=False, **options)
    if done.returncode != 0:
        raise CommandFailed(command, done.stderr.decode(errors="replace").strip())
    return done.stdout


def sites():
    """Where this computer has its packages from. Debian's main archive is most often the first: other ones follow."""
    told = call("apt-get", "indextargets", "--format", "$(SITE)", "Created-By: Packages").decode()
    if not told:
        raise Failure("apt has no source of packages: see /etc/apt/sources.list.d")
    return sorted(dict.fromkeys(told.split()), key=lambda site: not site.rstrip("/").endswith("/debian"))


class DebianPackages:
    """Those for the processor of this computer, as far as apt knows them. With `folder`, those for `architecture`, from
    where this computer has its own, or from `source`, a line as in sources.list: what apt knows of them is kept there and
    is asked for anew with every object."""

    def __init__(self, folder=None, architecture=None, source=None):
        self._options = []
        self._remedy = "apt has to know Debian 12's packages: scripts/install asks for them, and so does apt-get update"
        if folder is not None:
            self._options = own_settings(pathlib.Path(folder).resolve(), architecture, source)
            self._remedy = "the sources of this computer have to be Debian 12's, and for all processors"
            self._update()

    def _update(self):
        """A source that fails need not be one that matters: it is told of only when something is missing."""
        try:
            call("apt-get", "--quiet", *self._options, "-o", "APT::Update::Error-Mode=any", "update")
        except CommandFailed as failure:
            self._remedy = f"apt-get update: {failure.complaint}\nis the network there?"

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
        except CommandFailed as failure:
            raise Failure(f"{program} {arguments[0]}: {failure.complaint}\n{self._remedy}") from failure


def own_settings(folder, architecture, source):
    """Options for an apt that knows nothing of what is installed here."""
    for part in ("lists/partial", "cache/archives/partial"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    settings = {"Dir::State::Lists": folder / "lists", "Dir::Cache": folder / "cache", "Dir::State::status": "/dev/null",
                "Debug::NoLocking": "true", "Acquire::Languages": "none", "APT::Sandbox::User": "root"}
    if architecture is not None:
        settings |= {"APT::Architecture": architecture, "APT::Architectures": architecture}
    if source is not None:
        (folder / "sources.list").write_text(f"{source}\n", encoding="utf-8")
        settings |= {"Dir::Etc::sourcelist": folder / "sources.list", "Dir::Etc::sourceparts": "/dev/null"}
    return [word for key, value in settings.items() for word in ("-o", f"{key}={value}")]


def unpack(package, folder, *patterns):
    """The files of a package, or only those that fit any of `patterns`."""
    folder.mkdir(parents=True, exist_ok=True)
    if not patterns:
        call("dpkg-deb", "-x", package, folder)
        return
    archive = call("dpkg-deb", "--fsys-tarfile", package)
    call("tar", "-x", "-C", folder, "--wildcards", *(f"./{pattern}" for pattern in patterns), input=archive)
