#!/usr/bin/env python3
"""Makes the folder of another computer's libraries that kfast is compiled against, from Debian's packages:

    make_sysroot.py ARCHITECTURE FOLDER

ARCHITECTURE is one of Debian's, as arm64. Nothing is done when the folder is there; no rights are needed, and nothing
is installed. Programs of it run on such a computer with FOLDER as their root."""

import os
import pathlib
import shutil
import sys

from debian_packages import DebianPackages, Failure, unpack

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


def made_of():
    here = pathlib.Path(__file__).resolve().parent
    return "\n".join((here / name).read_text(encoding="utf-8") for name in ("make_sysroot.py", "debian_packages.py"))


def make(architecture, folder):
    work = folder.with_name(f"{folder.name}.part")
    shutil.rmtree(work, ignore_errors=True)
    debian = DebianPackages(work / "apt", architecture)
    for package in debian.download(work / "packages", *debian.with_dependencies(*LIBRARIES, *FOR_TESTS)):
        unpack(package, work / "root")
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
