"""Has a user of a Linux, who may do no more than others, flash emulated Picos with the kfast that is installed:

    pico_linux_flash_test.py <folder of the build> <folder of images> <folder of the guest> <scene> <another scene>

The boot loader is tests/emulation/rp2040/picoboot.mjs. What was flashed boots, and what the display shows is that of the
preview."""

import base64
import gzip
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from linux_guest import LinuxGuest, quoted
from pico import Desk, expect, expect_scene
from served_pico import ServedPico
from uf2_drive import Uf2Drive

DONE, WRONG_USAGE, NO_DEVICE, NO_PERMISSION, UNPLUGGED, NOT_VERIFIED, WRONG_CHIP = 0, 2, 3, 4, 5, 10, 11
CONFIGURATION = "pico-st7789"
FRAMES = 8
SECTOR = 4096
SETTINGS_AT, SCENE_AT = 0x3F000, 0x40000
FLASH_ADDRESS = 0x10000000
COMPARE_PACKETS, CHANGE_PACKETS = 2, 1 + 1 + SECTOR // 64 + 2  # to the board, for a sector: commands, data and ends
STUCK_AT = 0x8000  # or after it
MAIN, OTHER, STUCK = 0, 1, 2  # the kernel's sockets; Linux counts its ports from 1 on
INFO_UF2 = "UF2 Bootloader v3.0\\nModel: Raspberry Pi RP2\\nBoard-ID: RPI-RP2\\n"


def port(socket):
    return f"1-{socket + 1}"


def task(installed, attach, scenes, settings, boards):
    """What the guest does: each step's output ends with STATUS and a number."""
    first, second = (quoted(f"/run/{scene.name}") for scene in scenes)
    configured = f"--config /run/{settings.name}"
    return f"""
set -e
carry {quoted(attach, *scenes, settings)}
carry_folder {quoted(installed)}
kfast() {{ as_user {installed.name}/bin/kfast "$@"; }}
step() {{
    status=0
    "$@" >/tmp/told 2>&1 || status=$?
    cat /tmp/told
    echo "STATUS $status"
}}

step kfast flash {first} {configured}
keep_attached {boards["main"].port} {MAIN}
eventually has_boot_loader {MAIN}
step kfast flash {first} {configured}
step as_root {installed.name}/bin/kfast install-udev
step kfast flash {first} {configured} --json
step kfast devices --json
permission first

step kfast flash {first} {configured} --json
step kfast flash {second} --dry-run --json
step kfast flash --list --json
permission kept
step kfast flash {second} --json
permission second
step kfast flash {second} --verify-only
step kfast flash {first} --verify-only
eventually kfast devices

cut() {{
    permission $1
    step kfast flash $2
    replug $1 {MAIN}
    eventually has_boot_loader {MAIN}
    step kfast flash --list --json
    step kfast flash $2 --json
    permission "repaired $1"
}}
cut early {first}
cut late {second}

permission several
keep_attached {boards["stuck"].port} {STUCK}
eventually has_boot_loader {MAIN}
eventually has_boot_loader {STUCK}
step kfast flash {first} {configured}
step kfast flash {first} {configured} --port {port(STUCK)}
replug stuck {STUCK}
eventually has_boot_loader {STUCK}
step kfast flash {first} --port {port(MAIN)} --json
permission chosen

keep_attached {boards["other"].port} {OTHER}
eventually has_boot_loader {OTHER}
step kfast flash {first} {configured} --port {port(OTHER)}

mkdir /computer/run/RPI-RP2
truncate -s 64M /tmp/drive
mkdosfs -n RPI-RP2 /tmp/drive
mount -t vfat -o loop,uid=1000,umask=077 /tmp/drive /computer/run/RPI-RP2
printf '{INFO_UF2}' > /computer/run/RPI-RP2/INFO_UF2.TXT
step kfast flash --list --json
step kfast flash {first} {configured} --drive /run/RPI-RP2 --no-wait --json
gzip -c /computer/run/RPI-RP2/KFAST.UF2 > /tmp/copied
step base64 /tmp/copied
"""


def install(*builds, folder):
    for build in builds:
        subprocess.run(["cmake", "--install", build, "--prefix", folder, "--component", "kfast"], stdout=subprocess.DEVNULL,
                       check=True, timeout=120)
    return folder


class Step:
    """What a step of the task has printed."""

    def __init__(self, linux, status, what):
        begin = len(linux.console)
        told = linux.wait_for("STATUS")
        self.text = "\n".join(linux.console[begin:-1])
        expect(told == f"STATUS {status}", f"{what} ends with {told}, not {status}:\n{self.text}")

    @property
    def json(self):
        begin = min((at for at in map(self.text.find, "{[") if at >= 0), default=0)
        return json.loads(self.text[begin:])

    def expect(self, *words):
        for word in words:
            expect(word in self.text, f"“{word}” is missing in:\n{self.text}")


class Flashed:
    """The board that everything is tried with, and what its flash holds."""

    def __init__(self, desk, settings, image, scenes):
        self.desk, self.settings = desk, settings
        self.image, self.record = image.read_bytes(), settings.record.read_bytes()
        self.scenes = {scene: scene.read_bytes() for scene in scenes}
        self._hashes = {scene: desk.hashes(scene, settings) for scene in scenes}
        self._flash, self._commands = desk.folder / "flash.bin", desk.folder / "commands.json"

    def options(self):
        return [*self.desk.recorded(self.settings), "--keep-flash", self._flash, "--commands", self._commands]

    def commands(self, board):
        """Those of its boot loader since the latest call."""
        board.command("keep")
        return json.loads(self._commands.read_text(encoding="utf-8"))

    def expect_holds(self, board, scene):
        """All of it, as read from the chip."""
        board.command("keep")
        self.expect_in(self._flash.read_bytes(), scene)

    def expect_in(self, flash, scene):
        for offset, wanted in ((0, self.image), (SETTINGS_AT, self.record), (SCENE_AT, self.scenes[scene])):
            expect(flash[offset:offset + len(wanted)] == wanted, f"flash holds something else from {offset:#x} on")

    def expect_shows(self, board, scene, when):
        expect_scene(self.desk.watch(board, self.settings, FRAMES), self._hashes[scene], f"{when} the board")

    def scene_sectors(self, scene):
        return sectors_of(self.scenes[scene])

    def sectors(self, scene):
        return sectors_of(self.image) + sectors_of(self.record) + self.scene_sectors(scene)


def sectors_of(part):
    return -(-len(part) // SECTOR)


def expect_order(commands):
    """That the first sector is erased before others are, and written after all of them."""
    changes = [(name, address) for name, address, *_ in filter(lambda one: len(one) > 1, commands)
               if name in ("FLASH_ERASE", "WRITE")]
    expect(changes[0] == ("FLASH_ERASE", FLASH_ADDRESS), f"flashing begins with {changes[0]}")
    expect(changes[-1] == ("WRITE", FLASH_ADDRESS), f"flashing ends with {changes[-1]}")
    return changes


def check_permission(linux):
    Step(linux, NO_DEVICE, "flash without a board").expect("BOOTSEL")
    Step(linux, NO_PERMISSION, "flash without permission").expect("install-udev", 'ATTR{idProduct}=="0003"')
    Step(linux, DONE, "install-udev").expect("plugged in have it now")


def replug(linux, board, name):
    for command in ("unplug", "plug"):
        linux.wait_for_request(f"{command} {name}")
        board.command(command)
        linux.permit(f"{command} {name}")


def check_first(linux, flashed, board, scene):
    told = Step(linux, DONE, "the first flash").json
    count = flashed.sectors(scene)
    expect(told["port"] == port(MAIN) and told["sectors"] == told["written"] == count and told["verified"]
           and told["restarted"] and told["plays"], f"the first flash of {count} sectors tells {told}")
    expect(len(Step(linux, DONE, "devices").json) == 1, "the board is not listed")
    linux.wait_for_request("first")
    expect_order(flashed.commands(board))
    flashed.expect_holds(board, scene)
    flashed.expect_shows(board, scene, "after the first flash")
    linux.permit("first")


def check_second(linux, flashed, board, scene):
    told = Step(linux, DONE, "the same again").json
    expect(told["written"] == 0 and told["differing"] == [], f"the same again tells {told}")
    told = Step(linux, DONE, "a dry run").json
    expect(told["written"] == 0 and not told["restarted"], f"a dry run tells {told}")
    told = Step(linux, DONE, "a list").json
    expect(len(told["devices"]) == 1 and told["boot_loaders"] == [], f"the list is {told}")
    linux.wait_for_request("kept")
    names = [name for name, *_ in flashed.commands(board)]
    expect("READ" in names and not {"FLASH_ERASE", "WRITE"} & set(names), f"nothing was to be written: {names}")
    linux.permit("kept")
    told = Step(linux, DONE, "another scene").json
    expect(told["differing"] and min(told["differing"]) >= FLASH_ADDRESS + SCENE_AT, f"another scene: {told}")
    linux.wait_for_request("second")
    changed = {address // SECTOR * SECTOR for _, address in expect_order(flashed.commands(board))}
    expect(changed == {FLASH_ADDRESS, *told["differing"]}, f"for another scene {changed} were written")
    flashed.expect_holds(board, scene)
    flashed.expect_shows(board, scene, "with another scene")
    linux.permit("second")
    Step(linux, DONE, "a comparison")
    Step(linux, NOT_VERIFIED, "a comparison with another scene")
    linux.wait_for("the built-in scene")


def check_cut(linux, flashed, board, scene, name, packets):
    """The board is its boot loader after a flash that broke off, whatever had been written."""
    linux.wait_for_request(name)
    flashed.commands(board)
    board.command(f"unplug after {packets}")
    linux.permit(name)
    Step(linux, UNPLUGGED, "a flash without power").expect("again")
    expect(any(command[0] == "FLASH_ERASE" for command in flashed.commands(board)), "nothing was being written")
    replug(linux, board, name)
    told = Step(linux, DONE, "a list").json
    expect([one["port"] for one in told["boot_loaders"]] == [port(MAIN)] and told["devices"] == [],
           f"half flashed it is {told}")
    told = Step(linux, DONE, "the repair").json
    expect(told["verified"] and 0 < told["written"] < flashed.sectors(scene), f"the repair tells {told}")
    linux.wait_for_request(f"repaired {name}")
    flashed.expect_holds(board, scene)
    flashed.expect_shows(board, scene, "after the repair")
    linux.permit(f"repaired {name}")


def check_cuts(linux, flashed, board, first, second):
    """In the midst of the scene, and when it is there and the first sector follows, which makes the board start."""
    check_cut(linux, flashed, board, first, "early", COMPARE_PACKETS * flashed.sectors(first) + 20)
    check_cut(linux, flashed, board, second, "late", COMPARE_PACKETS * flashed.sectors(second)
              + CHANGE_PACKETS * flashed.scene_sectors(second) + 20)


def check_several(linux, flashed, boards, scene, stuck):
    linux.wait_for_request("several")
    boards["main"].command("bootsel")
    linux.permit("several")
    Step(linux, WRONG_USAGE, "flash with two boards").expect("--port", port(MAIN), port(STUCK))
    offset, expected, found = stuck
    complaint = Step(linux, NOT_VERIFIED, "flash that does not keep what is written").text
    numbers = [int(text, 16) for text in re.findall(r"0x([0-9A-Fa-f]+)", complaint)]
    expect(numbers[:3] == [FLASH_ADDRESS + offset, expected, found], f"of a stuck bit it says {complaint}")
    replug(linux, boards["stuck"], "stuck")
    told = Step(linux, DONE, "flash of a chosen board").json
    expect(told["port"] == port(MAIN), f"the chosen board: {told}")
    linux.wait_for_request("chosen")
    flashed.expect_holds(boards["main"], scene)
    linux.permit("chosen")


def check_others(linux, flashed, scene):
    Step(linux, WRONG_CHIP, "flash of another chip").expect("RP2350")
    told = Step(linux, DONE, "a list of all").json
    expect(told["drives"] == [{"folder": "/run/RPI-RP2", "board": "RPI-RP2"}], f"the list of all is {told}")
    told = Step(linux, DONE, "flash of a drive").json
    expect(told["drive"] and not told["verified"], f"flash of a drive tells {told}")
    drive = Uf2Drive()
    drive.take(gzip.decompress(base64.b64decode(Step(linux, DONE, "what was copied").text)))
    expect(drive.has_restarted, "what was copied to a drive does not restart the board")
    flashed.expect_in(drive.flash, scene)


def stuck_bit(image):
    """A bit of the image that is set: its offset, the byte with it and without."""
    offset = next(at for at in range(STUCK_AT, len(image)) if image[at] & 1)
    return offset, image[offset], image[offset] & ~1


def main(build, images, guest, at_first, sent):
    build, images = pathlib.Path(build).resolve(), pathlib.Path(images).resolve()
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        installed = install(build, images, folder=pathlib.Path(folder) / "installed")
        desk = Desk(build / "bin", images, folder)
        settings = desk.settings(CONFIGURATION)
        scenes = [desk.compile(scene) for scene in (at_first, sent)]
        flashed = Flashed(desk, settings, desk.image(settings), scenes)
        stuck = stuck_bit(flashed.image)
        with (ServedPico(None, *flashed.options()) as main_board,
              ServedPico(None, "--stuck", f"{stuck[0]}=1") as stuck_board,
              ServedPico(None, "--chip", "rp2350") as other):
            boards = {"main": main_board, "stuck": stuck_board, "other": other}
            source = pathlib.Path(folder) / f"{CONFIGURATION}.kdl"
            with LinuxGuest(guest, task(installed, build / "bin/vhci-attach", scenes, source, boards)) as linux:
                check_permission(linux)
                check_first(linux, flashed, main_board, scenes[0])
                check_second(linux, flashed, main_board, scenes[1])
                check_cuts(linux, flashed, main_board, *scenes)
                check_several(linux, flashed, boards, scenes[0], stuck)
                check_others(linux, flashed, scenes[0])


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"flash in Linux: {failure}")
