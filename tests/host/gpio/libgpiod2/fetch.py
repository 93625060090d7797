"""Unpacks libgpiod 2 of Debian 13 into <folder>/root: fetch.py <folder>

Nothing is done when it is there. No rights are needed, nothing is installed: apt downloads the packages from a mirror
that this computer has its own packages from."""

import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[4] / "scripts"))

from debian_packages import DebianPackages, Failure, sites, unpack  # noqa: E402 (lies there)

SUITE = "trixie"
PACKAGES = ("libgpiod-dev", "libgpiod3")
ELSE = "Or leave the test out: cmake -DKFAST_TEST_LIBGPIOD_2=OFF"


def unpack_from(site, work):
    shutil.rmtree(work, ignore_errors=True)
    debian = DebianPackages(work / "apt", source=f"deb {site} {SUITE} main")
    for package in debian.download(work / "packages", *PACKAGES):
        unpack(package, work / "root")


def fetch(folder):
    root, work = folder / "root", folder / "work"
    failures = []
    for site in () if root.exists() else sites():
        try:
            unpack_from(site, work)
            (work / "root").rename(root)
            shutil.rmtree(work)
            return
        except Failure as failure:
            failures.append(f"{site}: {failure}")
    if failures:
        raise Failure("\n".join(failures))


if __name__ == "__main__":
    try:
        fetch(pathlib.Path(sys.argv[1]).resolve())
    except Failure as failure:
        sys.exit(f"libgpiod 2 cannot be had from Debian's suite {SUITE}:\n{failure}\n{ELSE}")
