"""Puts programs that use hidapi in front of the emulated Pico, without a kernel in between:

    pico_hidapi_test.py <folder of programs> <folder of images> <folder of hidapi's stand-in> <scene>

The programs are as they are installed, linked with Debian's library; hidapi/hidapi_usbip.cpp takes its place."""

import pathlib
import sys
import tempfile

from computer import Computer, ended
from pico import Desk, expect, expect_scene
from served_pico import ServedPico

CHIPS = ("00112233aabbccdd", "fedcba9876543210")
FRAMES = 10


def device_line(chip):
    return f"1209:0001 page ff00 usage 1 interface 0 'KFAST' 'KFAST Pico' '{chip.upper()}'"


def check_devices(programs, stand_in, image):
    nobody = Computer(programs, stand_in)
    expect(nobody.run("hid-trial", "list") == "", "devices are there that are not plugged in")
    expect("cannot be opened" in nobody.run("hid-trial", "exchange", 1, status=1), "nothing is opened")
    with ServedPico(image, "--chip-number", CHIPS[0]) as first, ServedPico(image, "--chip-number", CHIPS[1]) as second:
        lines = Computer(programs, stand_in, first, second).run("hid-trial", "list").splitlines()
    expect(lines == [device_line(chip) for chip in CHIPS], f"two boards are listed as {lines}")


def check_reports(computer):
    computer.run("hid-trial", "exchange", 1000)
    computer.run("hid-trial", "silence", 1200)


def check_unplugging(computer, board):
    trial = computer.start("hid-trial", "unplugged")
    expect(trial.stdout.readline() == "goes\n", "reports do not go")
    board.command("unplug")
    ended(trial)
    expect(computer.run("hid-trial", "list") == "", "it is still there")
    board.command("plug")
    computer.run("hid-trial", "exchange", 10)


def check_freezing(computer, board):
    trial = computer.start("hid-trial", "stuck")
    expect(trial.stdout.readline() == "goes\n", "reports do not go")
    board.command("freeze")
    expect("timed out" in ended(trial), "it does not say that it waited in vain")
    board.command("thaw")


def check_picture(desk, source):
    """A board that plays is looked at while it plays."""
    settings = desk.settings("pico-st7789")
    scene = desk.compile(source)
    hashes = desk.hashes(scene, settings)
    with ServedPico(desk.image(settings), *desk.recorded(settings), "--scene", scene) as board:
        expect_scene(desk.watch(board, settings, FRAMES), hashes, "a board that is shared")


def main(programs, images, stand_in, source):
    trial = pathlib.Path(images) / "pico-usb-trial.bin"
    check_devices(programs, stand_in, trial)
    with ServedPico(trial) as board:
        computer = Computer(programs, stand_in, board)
        computer.check_stand_in()
        check_reports(computer)
        check_unplugging(computer, board)
        check_freezing(computer, board)
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        check_picture(Desk(programs, images, folder), source)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"hidapi: {failure}")
