#!/usr/bin/env python3
"""Makes the folder of another computer's libraries that kfast is compiled against, from Debian's packages:

    make_sysroot.py ARCHITECTURE FOLDER

ARCHITECTURE is one of Debian's, as arm64. Nothing is done when the folder is there; no rights are needed, and nothing
is installed. Programs of it run on such a computer with FOLDER as their root."""

import io
import os
import pathlib
import re
import shutil
import sys
import tarfile

from debian_packages import DebianPackages, Failure, call, unpack

LIBRARIES = ("libcli11-dev", "libpng-dev", "libgif-dev", "libsndfile1-dev", "nlohmann-json3-dev", "libhidapi-dev",
             "libfreetype-dev", "libusb-1.0-0-dev", "libgpiod-dev", "libpugixml-dev", "libzip-dev",
             "zlib1g-dev", "libstdc++6")
FOR_TESTS = ("coreutils", "util-linux", "gpiod")
MOUNT_POINTS = ("dev", "proc", "run", "sys", "tmp")


def make_links_relative(root):
    """Absolute ones would lead to this computer's own files."""
    for folder, folders, files in os.walk(root):
        for path in (pathlib.Path(folder, name) for name in (*folders, *files)):
            if path.is_symlink() and os.readlink(path).startswith("/"):
                target = root / os.readlink(path).lstrip("/")
                path.unlink()
                path.symlink_to(os.path.relpath(target, folder))


def note(package, root):
    """What dpkg would note of a package that is installed: scripts/shared_libraries.py asks for it."""
    noted = root / "var/lib/dpkg/info"
    noted.mkdir(parents=True, exist_ok=True)
    control = call("dpkg-deb", "--field", package).decode().strip()
    name = re.search(r"^Package: (.*)", control, re.MULTILINE)[1]
    with (noted.parent / "status").open("a", encoding="utf-8") as status:
        status.write(f"{control}\nStatus: install ok installed\n\n")
    with archive(package, "--fsys-tarfile") as files:
        (noted / f"{name}.list").write_text("".join(f"{path[1:]}\n" for path in files.getnames()), encoding="utf-8")
    with archive(package, "--ctrl-tarfile") as scripts:
        if "./shlibs" in scripts.getnames():
            (noted / f"{name}.shlibs").write_bytes(scripts.extractfile("./shlibs").read())


def archive(package, which):
    return tarfile.open(fileobj=io.BytesIO(call("dpkg-deb", which, package)))


def made_of():
    here = pathlib.Path(__file__).resolve().parent
    return "\n".join((here / name).read_text(encoding="utf-8") for name in ("make_sysroot.py", "debian_packages.py"))


def make(architecture, folder):
    work = folder.with_name(f"{folder.name}.part")
    shutil.rmtree(work, ignore_errors=True)
    debian = DebianPackages(work / "apt", architecture)
    for package in debian.download(work / "packages", *debian.with_dependencies(*LIBRARIES, *FOR_TESTS)):
        unpack(package, work / "root")
        note(package, work / "root")
    make_links_relative(work / "root")
    for name in MOUNT_POINTS:
        (work / "root" / name).mkdir(exist_ok=True)
    (work / "root/made_of").write_text(made_of(), encoding="utf-8")
    shutil.rmtree(folder, ignore_errors=True)
    (work / "root").rename(folder)
    shutil.rmtree(work)


def main(architecture, folder):
    folder = pathlib.Path(folder)
    stamp = folder / "made_of"
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == made_of():
        return
    make(architecture, folder)
    print(f"{folder} has the libraries for {architecture}")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except Failure as failure:
        sys.exit(f"the libraries cannot be had: {failure}")
