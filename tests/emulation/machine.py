"""The boards that QEMU plays, each as its tests have to know it."""

import dataclasses
import pathlib
import re
from typing import Callable

from PIL import Image

from qemu import loaded


@dataclasses.dataclass(frozen=True)
class Machine:
    """A board, and the image that it runs."""
    image: pathlib.Path
    name: str  # QEMU's too
    cpu: str
    panel: str  # as the board introduces it
    options: tuple  # with which kfast draws for this panel
    size: tuple
    whole_picture: int  # bytes: all pixels, and a window for each band
    free_ram: int  # where 64 KiB may hold anything when the image starts
    scene: int  # where the board looks for one
    shown: Callable[[Image.Image], Image.Image]  # a screenshot of what kfast renders
    pixel: int  # the side of a pixel in a screenshot
    pace: int  # of Qemu

    def arguments(self, noise, scene=None):
        """For QEMU; the RAM holds `noise` before the image has done anything."""
        return (["-M", self.name, "-cpu", self.cpu, "-kernel", str(self.image)] + loaded(noise, self.free_ram)
                + ([] if scene is None else loaded(scene, self.scene)))


def machine_for(image):
    """By the name of the image: <board>-<what the board is built for>.elf."""
    image = pathlib.Path(image)
    for board, machine in BOARDS.items():
        if match := re.fullmatch(rf"{board}-(.+)\.elf", image.name):
            return machine(image, match[1])
    raise ValueError(f"{image.name} is an image of no board: {', '.join(BOARDS)}")


def lm3s6965evb(image, cpu):
    width, height, rows, window = 128, 64, 8, 6
    return Machine(
        image=image, name="lm3s6965evb", cpu=cpu,
        panel=f"ssd0323 {width}x{height} grey4", options=("--panel", "ssd0323"), size=(width, height),
        whole_picture=width * height // 2 + height // rows * window,
        free_ram=0x20000000, scene=0x24000, shown=in_blocks_of_four, pixel=4, pace=5)


def vexpress_a9(image, size):
    width, height = map(int, size.split("x"))
    return Machine(
        image=image, name="vexpress-a9", cpu="cortex-a9",
        panel=f"pl111 {size} rgb565", options=("--size", size), size=(width, height),
        whole_picture=width * height * 2,
        free_ram=0x60100000, scene=0x61000000, shown=without_low_bits, pixel=1, pace=2)


BOARDS = {"lm3s6965evb": lm3s6965evb, "vexpress-a9": vexpress_a9}


def in_blocks_of_four(picture):
    return picture.resize((picture.width * 4, picture.height * 4), Image.Resampling.NEAREST)


def without_low_bits(picture):
    """kfast widens 5 and 6 bits to all of 0 … 255; the emulated PL111 appends zeros to them."""
    def narrowed(bits):
        most = (1 << bits) - 1
        return [(value * most + 127) // 255 << 8 - bits for value in range(256)]
    return picture.point(narrowed(5) + narrowed(6) + narrowed(5))
