"""The parts of a release: what each is, which files it has, and how they are made of what is built. scripts/release."""

import dataclasses
import os
import re
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

import portable_tar
from debian_packages import call
from project import ROOT, facts

BUILD = ROOT / "build"
SCENE = ROOT / "examples/robot-eyes.kfast"
CONFIGURATIONS = ROOT / "boards/pico/configurations"
IMAGE_FOR_BUS = {"dac": "xy"}  # others have the name of the bus
# A laser wants settings that somebody has thought about.
NOT_TO_BE_DRAGGED = ("pico-xy-galvo",)


@dataclasses.dataclass(frozen=True)
class Architecture:
    preset: str
    machine: str  # as uname calls it
    libraries: Path  # the root of them
    strip: str


# By Debian's names.
ARCHITECTURES = {
    "amd64": Architecture("host", "x86_64", Path("/"), "strip"),
    "arm64": Architecture("linux-arm64", "aarch64", BUILD / "linux-arm64/root", "aarch64-linux-gnu-strip"),
}


@dataclasses.dataclass(frozen=True)
class Part:
    """Of `files` and `make`, the first argument are names of architectures, the last one of `make` the folder."""

    what: str
    files: Callable
    make: Callable
    is_built: bool = True


def builds(parts, architectures):
    """The commands that build what these parts are made of."""
    if not any(PARTS[name].is_built for name in parts):
        return []
    wanted = [["scripts/build", "pico"], ["cmake", "--preset", "command"], ["cmake", "--build", "--preset", "packages"]]
    if "arm64" in architectures and set(parts) & {"debian", "portable"}:
        wanted.append(["scripts/build", "linux-arm64"])
    return wanted


def version():
    return facts()["version"]


def seconds():
    """The time that all files say: that of the commit, so that it makes the same files whenever it is built."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    return int(epoch or call("git", "log", "-1", "--format=%ct", folder=ROOT))


def debian_files(architectures):
    own = [f"{name}_{version()}_amd64.deb" for name in ("kfast", "libkfast-dev") if "amd64" in architectures]
    return [*own, *(f"kfast_{version()}_{name}.deb" for name in architectures if name != "amd64")]


def make_debian(architectures, folder):
    call(ROOT / "scripts/package", "--no-build", "--folder", folder, *architectures)


def portable_files(architectures):
    return [portable_tar.name(version(), ARCHITECTURES[each].machine) for each in architectures]


def make_portable(architectures, folder):
    for each in (ARCHITECTURES[name] for name in architectures):
        target = folder / portable_tar.name(version(), each.machine)
        portable_tar.make(BUILD / each.preset, each.libraries, each.strip, target, seconds())


def configurations():
    return sorted(file.stem for file in CONFIGURATIONS.glob("*.kdl") if file.stem not in NOT_TO_BE_DRAGGED)


def uf2_files(_):
    return [f"kfast-{version()}-{name}.uf2" for name in configurations()]


def make_uf2(_, folder):
    for name, file in zip(configurations(), uf2_files(_)):
        bus = re.search(r"^ *bus (\w+)", (CONFIGURATIONS / f"{name}.kdl").read_text(encoding="utf-8"), re.MULTILINE)[1]
        call(BUILD / "host/bin/kfast", "uf2", "pack", "--firmware", BUILD / f"pico/pico-{IMAGE_FOR_BUS.get(bus, bus)}.bin",
             "--config", name, "--scene", SCENE, "-o", folder / file)


def framework(name, what):
    """A library for another framework, as scripts/assemble makes it."""
    def files(_):
        return [f"KFAST-{version()}-{name}.zip"]

    def make(_, folder):
        with tempfile.TemporaryDirectory(prefix="kfast") as beside:
            call(ROOT / "scripts/assemble", name, beside, "--zip")
            (archive,) = Path(beside).glob("*.zip")
            shutil.move(archive, folder / files(_)[0])

    return Part(what, files, make, is_built=False)


PARTS = {
    "debian": Part("packages for Debian 12, amd64 and arm64", debian_files, make_debian),
    "portable": Part("tars with a kfast that runs on any Linux", portable_files, make_portable),
    "uf2": Part("robot-eyes for the drive of a Pico, by display", uf2_files, make_uf2),
    "arduino": framework("arduino", "the library for the Arduino IDE"),
    "platformio": framework("platformio", "the library for PlatformIO"),
    "esp-idf": framework("esp-idf", "the component for ESP-IDF"),
}
