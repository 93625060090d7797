"""Has kfast send scenes to the emulated Pico and steer it, without a kernel in between:

    pico_kfast_test.py <folder of programs> <folder of images> <folder of hidapi's stand-in> <scene> <another scene> <scene with inputs>

The one scene lies in flash from the beginning, the other one is sent. What the display shows is that of the preview."""

import json
import sys
import tempfile
import time

from computer import Computer, ended
from pico import Desk, expect, expect_scene
from two_scenes import FRAMES, TwoScenes

CHIPS = ("00112233aabbccdd", "fedcba9876543210")
NO_DEVICE, UNPLUGGED, TIMED_OUT = 3, 5, 9  # of host/program/failure.hpp
LONGEST_STAY = 60  # seconds


def told(computer, *command):
    return json.loads(computer.run("kfast", *command, "--json"))


def check_devices(scenes, programs, stand_in):
    with scenes.board("--chip-number", CHIPS[0]) as first, scenes.board("--chip-number", CHIPS[1]) as second:
        computer = Computer(programs, stand_in, first, second)
        serials = [chip.upper() for chip in CHIPS]
        expect([device["device"] for device in told(computer, "devices")] == serials, "the boards are not listed")
        computer.run("kfast", "play", scenes.sent, "--device", "all")
        homes = [device["playing"]["home"] for device in told(computer, "devices")]
        expect(homes == ["RAM", "RAM"], f"what all are to play from RAM they play from {homes}")
        scenes.expect_playing(first, scenes.sent, "together with another one")


def check_playing(scenes, computer, board):
    scenes.expect_playing(board, scenes.at_first, "at first")
    computer.run("kfast", "play", scenes.sent)
    scenes.expect_playing(board, scenes.sent, "after play")
    restart(board)
    scenes.expect_playing(board, scenes.at_first, "after a restart without an upload")


def check_upload(scenes, computer, board):
    computer.run("kfast", "upload", scenes.sent, "--slot", 2, "--choose", "--play")
    scenes.expect_playing(board, scenes.sent, "after upload")
    restart(board)
    scenes.expect_playing(board, scenes.sent, "after a restart with an upload")
    (slots,) = told(computer, "slots")
    expect([slot["slot"] for slot in slots["slots"]] == [2], f"the slots are {slots}")


def restart(board):
    board.command("unplug")
    board.command("plug")


def check_breaks(scenes, computer, board):
    """A transfer that breaks off leaves all as it was, and says why."""
    board.command("unplug after 10")
    complaint = computer.run("kfast", "upload", scenes.sent, "--slot", 3, "--play", status=UNPLUGGED)
    expect("plug it in" in complaint, f"unplugged it says {complaint}")
    board.command("plug")
    scenes.expect_playing(board, scenes.sent, "after an upload that broke off")
    board.command("freeze after 10")
    upload = computer.start("kfast", "upload", scenes.sent, "--slot", 3, "--timeout", 3)
    ended(upload, TIMED_OUT)
    board.command("thaw")
    computer.run("kfast", "upload", scenes.sent, "--slot", 3)


def check_live(scenes, computer, board, source):
    """Values from a program are there, and stay when it ends."""
    lines = [f"speed {speed} mood {mood}" for speed, mood in ((10, 0), (30, 1), (80, 1))]
    live = computer.start("kfast", "live", source)
    ended(live, told="\n".join(lines))
    desk, settings = scenes.desk, scenes.settings
    hashes = desk.hashes(desk.compile(source), settings, "--input", "speed=80", "--input", "mood=1")
    expect_scene(desk.watch(board, settings, FRAMES), hashes, "after live values the board")


def check_boot_loader(computer, board):
    computer.run("kfast", "boot")
    until = time.monotonic() + LONGEST_STAY
    while computer.start("kfast", "devices").wait(timeout=60) != NO_DEVICE:
        expect(time.monotonic() < until, "the board does not enter its boot loader")
    board.command("plug")
    expect(len(told(computer, "devices")) == 1, "the board does not come back")


def main(programs, images, stand_in, at_first, sent, with_inputs):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        scenes = TwoScenes(Desk(programs, images, folder), at_first, sent)
        check_devices(scenes, programs, stand_in)
        with scenes.board() as board:
            computer = Computer(programs, stand_in, board)
            check_playing(scenes, computer, board)
            check_upload(scenes, computer, board)
            check_breaks(scenes, computer, board)
            check_live(scenes, computer, board, with_inputs)
            check_boot_loader(computer, board)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"kfast: {failure}")
