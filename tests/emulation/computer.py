"""A computer to which emulated boards are plugged in, without a kernel in between."""

import os
import pathlib
import subprocess

from pico import expect


class Computer:
    """Runs `programs`, as they are installed, with hidapi's stand-in (hidapi/hidapi_usbip.cpp), which lies in a folder of
    its own: they find the `boards`, each a ServedPico, and no others."""

    def __init__(self, programs, stand_in, *boards):
        self._programs = pathlib.Path(programs)
        self._environment = {**os.environ, "LD_LIBRARY_PATH": str(stand_in),
                             "KFAST_USBIP": ",".join(board.address for board in boards)}

    def start(self, program, *arguments):
        return subprocess.Popen([self._programs / program, *map(str, arguments)], stdin=subprocess.PIPE,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self._environment)

    def run(self, program, *arguments, status=0):
        """What it prints."""
        return ended(self.start(program, *arguments), status)

    def check_stand_in(self):
        """Or else this would test what is plugged into the real computer."""
        told = subprocess.run([self._programs / "hid-trial", "list"], env={**self._environment, "LD_DEBUG": "libs"},
                              stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True, check=True, timeout=60).stderr
        expect(f"calling init: {self._environment['LD_LIBRARY_PATH']}/" in told, "hidapi's stand-in is not used")


def ended(process, status=0, told=""):
    """What a program printed that was started, is `told` something, and has to exit with `status`."""
    printed, complaints = process.communicate(told, timeout=120)
    expect(process.returncode == status, f"exit status {process.returncode}: {printed}{complaints}")
    return printed + complaints
