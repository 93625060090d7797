"""Runs a firmware image in QEMU and compares it with the preview:

    board_test.py <lm3s6965evb-cortex-….elf or vexpress-a9-….elf> <scene.kfb> <kfast> [--linked] [--keep <folder>]

The scene is put into the board's memory; with --linked it is part of the image already (KFAST_SCENE). With --keep, all
frames are compared, and the folder holds what the display showed at each of them: 0000.png, 0001.png …, of the panel's own
pixels, for `kfast preview --beside`.
Every frame must have the hash that `kfast hash` gives, the events must be those that `kfast preview --headless` tells,
each with the frame that it was passed before, and screenshots of the emulated display must equal the
pictures of `kfast render` in every pixel. What is no scene must be refused, with the error's number on the display."""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import zlib

from PIL import Image, ImageChops

from machine import machine_for
from qemu import Qemu

SCREENSHOTS = 12
FREE_FRAMES = 20

# The errors that boards show, by their numbers.
NUMBERS = {"bad_magic": """
    ###.###
    #.....#
    ###.###
    #...#..
    ###.###""", "bad_checksum": """
    ###.#.#
    #...#.#
    ###.###
    #.....#
    ###...#"""}


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def kfast(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.PIPE, text=True,
                          timeout=120).stdout


def expected_hashes(program, scene, machine):
    lines = [line.split() for line in kfast(program, "hash", scene, *machine.options).splitlines()]
    expect(lines and [int(index) for index, _ in lines] == list(range(len(lines))), f"hash printed {lines[:3]}")
    return [value for _, value in lines]


def expected_events(program, scene):
    """When which events are passed, in frames."""
    told = kfast(program, "preview", scene, "--headless").splitlines()
    lines = [line.split(" ", 2) for line in told if line.startswith("event ")]
    return [(float(moment), name) for _, moment, name in lines]


def board(machine, folder, scene=None):
    noise = folder / "noise"
    noise.write_bytes(bytes(range(1, 256)) * 256)  # what RAM may hold when the power comes on
    return Qemu(machine.arguments(noise, scene), pace=machine.pace)


def wait_for(qemu, start):
    while not (line := qemu.line()).startswith(start):
        expect(not line.startswith(("ERROR", "FAULT")), line)
    return line


def frame(qemu):
    """Time, hash and bytes of the next frame, and the events before it."""
    events = []
    while (line := qemu.line()).startswith("EVENT "):
        events.append(line.removeprefix("EVENT "))
    match = re.fullmatch(r"F (\d+) ([0-9a-f]{8}) (\d+)", line)
    expect(match, f"a frame was to come, not {line!r}")
    return int(match[1]), match[2], int(match[3]), events


def expect_events(told, events, after, until):
    """`told` must be those later than `after` ticks and not later than `until`."""
    due = [name for moment, name in events if after < moment * 1024 <= until]
    expect(told == due, f"until time {until}/1024 the board tells {told}, the preview {due}")


def expect_quiet(qemu):
    expect("error:" not in qemu.errors(), f"the emulated display objects: {qemu.errors()}")


def compare_picture(machine, shown, expected, index):
    screenshot, preview = Image.open(shown).convert("RGB"), machine.shown(Image.open(expected).convert("RGB"))
    expect(screenshot.size == preview.size, f"frame {index}: {screenshot.size}, preview {preview.size}")
    difference = ImageChops.difference(screenshot, preview).getbbox()
    expect(difference is None, f"frame {index}: screenshot and preview differ within {difference}")


def keep_picture(machine, shown, target):
    """Whole or not at all, for whoever looks into the folder meanwhile."""
    picture = Image.open(shown).convert("RGB").resize(machine.size, Image.Resampling.NEAREST)
    picture.save(target.with_suffix(".part"), format="png")
    target.with_suffix(".part").replace(target)


def begin_keeping(keep):
    keep.mkdir(parents=True, exist_ok=True)
    for old in keep.glob("*.png"):
        old.unlink()


def check_frames(machine, qemu, hashes, events, pictures, folder, keep):
    """Steps through the scene, of which the last frame is asked for whole; returns the number of screenshots."""
    last = len(hashes) - 1
    moments = range(len(hashes)) if keep else {round(i * last / (SCREENSHOTS - 1)) for i in range(SCREENSHOTS)}
    before = -1
    for index, expected in enumerate(hashes):
        ticks, shown, sent, told = frame(qemu)
        expect_events(told, events, before, ticks)
        before = ticks
        expect(-(-ticks // 1024) == index, f"frame {index} was shown for time {ticks}/1024")
        expect(shown == expected, f"frame {index}: hash {shown} on the board, {expected} in the preview")
        expect(sent == machine.whole_picture or index not in (0, last),
               f"frame {index}: {sent} bytes were sent, {machine.whole_picture} are all of it")
        if index in moments:
            qemu.screenshot(folder / "shown.png")
            compare_picture(machine, folder / "shown.png", pictures / f"{index:04d}.png", index)
            if keep:
                keep_picture(machine, folder / "shown.png", keep / f"{index:04d}.png")
        qemu.send(b"q" if index == last else b"r" if index == last - 1 else b"n")
    expect(qemu.line() == "END", "the board was to end")
    expect_quiet(qemu)
    return len(moments)


def check_stepped(machine, qemu_board, scene, hashes, events, pictures, folder, keep):
    with qemu_board as qemu:
        banner = qemu.line()
        expect(re.fullmatch(rf"KFAST \S+ {machine.name} {machine.panel}", banner), f"banner: {banner!r}")
        qemu.send(b"s")
        wait_for(qemu, "STEP")
        data = pathlib.Path(scene).read_bytes()
        announced = qemu.line()
        expect(announced == f"SCENE {len(data)} {zlib.crc32(data):08x}", f"the board plays another scene: {announced}")
        return check_frames(machine, qemu, hashes, events, pictures, folder, keep)


def rising(times):
    """The beginning of `times`, until the scene starts over or holds its end."""
    falls = (i + 1 for i in range(len(times) - 1) if times[i + 1] <= times[i])
    return times[:next(falls, len(times))]


def check_free_running(qemu_board, hashes, events):
    with qemu_board as qemu:
        wait_for(qemu, "SCENE")
        frames = [frame(qemu) for _ in range(FREE_FRAMES)]
        expect_quiet(qemu)
    times = [ticks for ticks, *_ in frames]
    expect(times[0] == 0 and len(rising(times)) >= 3, f"times do not ascend: {times}")
    for before, (ticks, _, _, told) in zip([-1] + times, frames[:len(rising(times))]):
        expect_events(told, events, before, ticks)  # also those of frames that were left out
    for ticks, shown, *_ in frames:
        if ticks % 1024 == 0 and ticks // 1024 < len(hashes):
            expect(shown == hashes[ticks // 1024], f"free-running, time {ticks}/1024: hash {shown}")


def number_on(screenshot):
    """The blocks that a fault's number is shown in, row by row; the words that follow below a dark row must be there."""
    shown = Image.open(screenshot).convert("L").point(lambda level: 255 if level > 128 else 0)
    width, height = shown.size
    lit = [shown.crop((0, y, width, y + 1)).getbbox() is not None for y in range(height)]
    top = lit.index(True)
    bottom = lit.index(False, top)
    expect(True in lit[bottom:], "the display does not say in words what is wrong")
    left, _, right, _ = shown.crop((0, top, width, bottom)).getbbox()
    middles = lambda first, end, blocks: [first + (end - first) * (2 * i + 1) // (2 * blocks) for i in range(blocks)]
    return "".join("\n    " + "".join("#" if shown.getpixel((x, y)) else "." for x in middles(left, right, 7))
                   for y in middles(top, bottom, 5))


def check_error(machine, scene, expected, folder):
    with board(machine, folder, scene) as qemu:
        qemu.line()
        line = qemu.line()
        expect(line.startswith(f"ERROR {expected}: "), f"{line!r} instead of ERROR {expected}")
        qemu.screenshot(folder / "refused.png")
        expect_quiet(qemu)
    number = number_on(folder / "refused.png")
    expect(number == NUMBERS[expected], f"the display shows{number}")


def check_damaged(machine, scene, folder):
    damaged = bytearray(pathlib.Path(scene).read_bytes())
    damaged[len(damaged) // 2] ^= 0x10
    (folder / "damaged.kfb").write_bytes(damaged)
    check_error(machine, folder / "damaged.kfb", "bad_checksum", folder)


def arguments():
    parser = argparse.ArgumentParser(usage=__doc__.splitlines()[2].strip())
    for name in ("image", "scene", "program"):
        parser.add_argument(name)
    parser.add_argument("--linked", action="store_true", dest="is_linked")
    parser.add_argument("--keep", type=pathlib.Path)
    return parser.parse_args()


def main(image, scene, program, is_linked, keep):
    if keep:
        begin_keeping(keep)
    expect(pathlib.Path(image).is_file(), f"{image} is missing: build the board first")
    machine = machine_for(image)
    with tempfile.TemporaryDirectory(prefix="kfast") as name:
        folder = pathlib.Path(name)
        pictures = folder / "preview"
        hashes = expected_hashes(program, scene, machine)
        events = expected_events(program, scene)
        kfast(program, "render", scene, *machine.options, "--all", "-o", pictures)
        in_memory = None if is_linked else scene
        screenshots = check_stepped(machine, board(machine, folder, in_memory), scene, hashes, events, pictures, folder,
                                    keep)
        check_free_running(board(machine, folder, in_memory), hashes, events)
        check_damaged(machine, scene, folder)
        if not is_linked:
            check_error(machine, None, "bad_magic", folder)
    print(f"board and preview agree: {len(hashes)} frames, {screenshots} screenshots, {pathlib.Path(image).stem}")


if __name__ == "__main__":
    try:
        main(**vars(arguments()))
    except AssertionError as failure:
        sys.exit(f"board and preview differ: {failure}")
    except KeyboardInterrupt:
        sys.exit(130)
