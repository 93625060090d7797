"""Has a user of a Linux, who may do no more than others, play on the emulated Pico with the kfast that is installed:

    pico_linux_kfast_test.py <folder of the build> <folder of images> <folder of the guest> <scene> <another scene>

The one scene lies in flash from the beginning, the other one is sent. What the display shows is that of the preview."""

import pathlib
import subprocess
import sys
import tempfile

from linux_guest import LinuxGuest, quoted
from pico import Desk, expect
from two_scenes import TwoScenes

NO_PERMISSION, UNPLUGGED = 4, 5  # of host/program/failure.hpp
RULE = "70-kfast.rules"


def task(installed, attach, scene, board):
    kept, sent = quoted(f"/computer{installed}/lib/udev/rules.d/{RULE}"), f"/run/{scene.name}"
    return f"""
set -e
carry {quoted(installed / "bin/kfast", attach, scene)}
kfast() {{ as_user kfast "$@"; }}
tell_status() {{
    status=0
    "$@" 2>&1 || status=$?
    echo "STATUS $status"
}}

attach {board.port} 0
tell_status kfast devices
kfast devices --udev-rule > /etc/udev/rules.d/{RULE}
cmp /etc/udev/rules.d/{RULE} {kept}
udevadm control --reload
permission rule
attach {board.port} 1
kfast devices

kfast play {sent}
permission play
kfast upload {sent} --slot 2 --choose
permission break
tell_status kfast upload {sent} --slot 3
attach {board.port} 2
kfast slots
permission restart
"""


def install(build, folder):
    subprocess.run(["cmake", "--install", build, "--prefix", folder, "--component", "kfast"], stdout=subprocess.DEVNULL,
                   check=True, timeout=60)
    return folder


def check(linux, scenes, board):
    linux.wait_for("install-udev")
    expect_status(linux, NO_PERMISSION)
    linux.wait_for_request("rule")
    board.command("unplug")
    board.command("plug")
    linux.permit("rule")
    linux.wait_for("the built-in scene")
    check_playing(linux, scenes, board, "play")
    linux.wait_for_request("break")
    board.command("unplug after 10")
    linux.permit("break")
    expect_status(linux, UNPLUGGED)
    board.command("plug")
    linux.wait_for("plays from the start on")
    check_playing(linux, scenes, board, "restart")


def expect_status(linux, status):
    told = linux.wait_for("STATUS")
    expect(told == f"STATUS {status}", f"kfast ends with {told}, not {status}")


def check_playing(linux, scenes, board, what):
    linux.wait_for_request(what)
    scenes.expect_playing(board, scenes.sent, f"after {what}")
    linux.permit(what)


def main(build, images, guest, at_first, sent):
    build = pathlib.Path(build).resolve()
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        installed = install(build, pathlib.Path(folder) / "installed")
        scenes = TwoScenes(Desk(build / "bin", images, folder), at_first, sent)
        with scenes.board() as board:
            with LinuxGuest(guest, task(installed, build / "bin/vhci-attach", scenes.sent, board)) as linux:
                check(linux, scenes, board)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"Linux: {failure}")
