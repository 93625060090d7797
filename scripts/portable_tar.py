"""The tar with a kfast that runs on any Linux without being installed: a folder as cmake --install makes it, in which
bin/kfast is the launcher of packages/portable, and lib/kfast has the command with all libraries that it needs, their
dynamic loader too."""

import gzip
import pathlib
import re
import shutil
import tarfile

from debian_packages import Failure, call
from shared_libraries import Libraries

COMMON_LICENCES = pathlib.Path("/usr/share/common-licenses")
LOADER = re.compile(r"ld-linux-.*\.so\.\d+")

READ_ME = """\
kfast: vector animations for small displays.

    ./kfast --help
    ./kfast new eyes.kfast && ./kfast preview eyes.kfast

It runs from wherever this folder is; a link to ./kfast in a folder of PATH is enough to call it as kfast. To flash boards
and talk to them without being root: sudo ./kfast install-udev. Texts and examples are in share/doc/kfast.

The libraries in lib/kfast are those of Debian 12, unchanged. Their licences are in share/doc/kfast/libraries, where
packages.txt names the packages and their sources, with versions: the archive of Debian's snapshots has them.
"""


def copy_libraries(root, program, folder):
    """Those that the program needs, to `folder`, the loader as ld.so; their licences to share/doc."""
    libraries = Libraries(root)
    needed = libraries.needed(program)
    for name, file in needed.items():
        shutil.copy(file, folder / "lib/kfast" / ("ld.so" if LOADER.fullmatch(name) else name))
    if not (folder / "lib/kfast/ld.so").is_file():
        raise Failure(f"{program} needs no dynamic loader: which libraries it needs is not known")
    copy_licences(libraries, needed.values(), folder / "share/doc/kfast/libraries")


def copy_licences(libraries, files, folder):
    packages = sorted({libraries.package_of(file) for file in files})
    folder.mkdir(parents=True)
    wanted = set()
    for package in packages:
        text = libraries.copyright_of(package).read_text(encoding="utf-8")
        (folder / f"{package}.txt").write_text(text, encoding="utf-8")
        wanted |= set(re.findall(rf"{COMMON_LICENCES}/([\w.+-]*\w)", text))
    for name in sorted(wanted):
        if (COMMON_LICENCES / name).is_file():
            shutil.copy(COMMON_LICENCES / name, folder)
    versions = libraries.versions_of(packages)
    lines = [f"{package} from {versions[package]}\n" for package in packages]
    (folder / "packages.txt").write_text("".join(lines), encoding="utf-8")


def fill(folder, build, root, strip):
    """What is installed of the command that is built in `build`, to `folder`."""
    call("cmake", "--install", build, "--prefix", folder, "--component", "kfast")
    command = folder / "lib/kfast/kfast"
    command.parent.mkdir(parents=True, exist_ok=True)
    (folder / "bin/kfast").rename(command)
    copy_libraries(root, command, folder)
    call(strip, command)
    shutil.copy(build / "bin/kfast_launcher", folder / "bin/kfast")
    call(strip, folder / "bin/kfast")
    (folder / "kfast").symlink_to("bin/kfast")


def pack(folder, target, seconds):
    """The folder as a .tar.gz. The same files make the same tar: it has `seconds` as all times, and no names of users."""
    def plain(entry):
        entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname = seconds, 0, 0, "", ""
        entry.mode = 0o755 if entry.mode & 0o100 else 0o644
        return entry

    with (target.open("wb") as file, gzip.GzipFile(filename="", fileobj=file, mode="wb", compresslevel=6, mtime=seconds) as packed,
          tarfile.open(fileobj=packed, mode="w", format=tarfile.GNU_FORMAT) as tar):
        for path in sorted(folder.rglob("*")):
            tar.add(path, path.relative_to(folder.parent), recursive=False, filter=plain)


def name(version, machine):
    return f"kfast-{version}-linux-{machine}.tar.gz"


def make(build, root, strip, target, seconds):
    """Makes `target`, of what is built in `build` and the libraries of `root`."""
    unpacked = target.with_name(target.name.removesuffix(".tar.gz"))
    try:
        fill(unpacked, build, root, strip)
        (unpacked / "README.txt").write_text(READ_ME, encoding="utf-8")
        pack(unpacked, target, seconds)
    finally:
        shutil.rmtree(unpacked, ignore_errors=True)
