"""How deep the stack of a board's image gets: RAM is painted before the image starts."""

import pathlib
import sys
import tempfile

from images import symbol

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "emulation"))
from qemu import Qemu, loaded  # pylint: disable=wrong-import-position

SCENE_ADDRESS = 0x24000
RAM_ADDRESS = 0x20000000
RAM_BYTES = 64 * 1024
PAINT = b"\x01\x0c\x11\xc0"
TIMEOUT = 120


def stack_used(image, cpu, scene, frames):
    """By the lm3s6965evb's image while it shows so many frames; None if it refuses the scene."""
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        paint = pathlib.Path(folder, "paint")
        paint.write_bytes(PAINT * (RAM_BYTES // len(PAINT)))
        machine = ["-M", "lm3s6965evb", "-cpu", cpu, "-kernel", str(image)]
        with Qemu(machine + loaded(paint, RAM_ADDRESS) + loaded(scene, SCENE_ADDRESS), TIMEOUT) as qemu:
            if not shows(qemu, frames):
                return None
            return depth(qemu.memory(RAM_ADDRESS, RAM_BYTES), symbol(image, "bss_end"), symbol(image, "stack_top"))


def shows(qemu, frames):
    while frames > 0:
        line = qemu.line()
        if line.startswith("ERROR"):
            return False
        frames -= line.startswith("F ")
    return True


def depth(memory, lowest, top):
    stack = memory[lowest - RAM_ADDRESS:top - RAM_ADDRESS]
    untouched = 0
    while stack[untouched:untouched + len(PAINT)] == PAINT:
        untouched += len(PAINT)
    return len(stack) - untouched
