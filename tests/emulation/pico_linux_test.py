"""Plugs the emulated Pico into a Linux: its kernel, udev with the project's rule, Debian's hidapi, and a user who may do
no more than others:

    pico_linux_test.py <folder of programs> <folder of images> <folder of the guest> <rule of udev>"""

import pathlib
import sys

from linux_guest import LinuxGuest, quoted
from pico import expect
from served_pico import ServedPico

SERIAL = "E4613852C71B9D0F"
RULE = "/etc/udev/rules.d/70-kfast.rules"


def task(programs, rule, board):
    return f"""
set -e
carry {quoted(programs / "vhci-attach", programs / "hid-trial")}
attach {board.port} 0
echo LISTED "$(as_user hid-trial list)"
echo FORBIDDEN "$(as_user hid-trial exchange 1 2>&1)" "$(stat -c %a:%G /dev/hidraw0)"

cp {quoted(f"/computer{rule}")} {RULE}
udevadm control --reload
udevadm trigger --subsystem-match=hidraw
udevadm settle
echo RULED "$(stat -c %a:%G /dev/hidraw0)"
as_user hid-trial exchange 200
as_user hid-trial silence 1000

as_user hid-trial unplugged
until [ ! -e /dev/hidraw0 ]; do sleep 0.1; done
echo GONE "$(as_user hid-trial list)"
attach {board.port} 1
as_user hid-trial exchange 20
as_user hid-trial stuck
"""


def main(programs, images, guest, rule):
    programs, rule = pathlib.Path(programs).resolve(), pathlib.Path(rule).resolve()
    with ServedPico(pathlib.Path(images) / "pico-usb-trial.bin") as board:
        with LinuxGuest(guest, task(programs, rule, board)) as linux:
            listed = linux.wait_for("LISTED")
            expect("1209:0001 page ff00" in listed and f"'KFAST Pico' '{SERIAL}'" in listed, f"hidapi lists {listed}")
            forbidden = linux.wait_for("FORBIDDEN")
            expect("cannot be opened" in forbidden and "600:root" in forbidden, f"without a rule: {forbidden}")
            ruled = linux.wait_for("RULED")
            expect("660:plugdev" in ruled, f"the rule makes it {ruled}")
            linux.wait_for("went there and back")
            linux.wait_for("goes")
            board.command("unplug")
            linux.wait_for("unplugged:")
            gone = linux.wait_for("GONE")
            expect(gone == "GONE", f"unplugged there still is {gone}")
            board.command("plug")
            linux.wait_for("went there and back")
            linux.wait_for("goes")
            board.command("freeze")
            expect("timed out" in linux.wait_for("stuck:"), "it does not say that it waited in vain")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"Linux: {failure}")
