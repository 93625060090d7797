"""QEMU's machine virt for arm64: a computer with eight GPIO lines, three of them an SPI bus, watched from outside."""

import collections
import pathlib
import re
import socket
import subprocess
import tempfile
import threading

from linux_guest import Machine
from pico import expect
from qemu_control import QemuControl

DEVICE_TREE = pathlib.Path(__file__).resolve().parent / "guest/spi_display.dts"
VIRT = ("qemu-system-aarch64", "-M", "virt", "-cpu", "cortex-a53")
PATIENCE = 60  # seconds
CHIP_LABEL = "9030000.pl061"

SCK, MOSI, SELECT = 4, 5, 6  # as guest/spi_display.dts has it

EDGE = re.compile(rb"^\[S \+(\d+)\.(\d{6})\] IRQ (raise|lower) (\d)$", re.MULTILINE)

Edge = collections.namedtuple("Edge", "nanoseconds line level")


class GpioMachine:
    """`with GpioMachine(root) as board:` is a machine for a LinuxGuest, which has the folder `root` for /computer. It
    stands still until watch(); when the guest has ended, edges() are what its GPIO lines have done."""

    def __init__(self, root):
        self._root = root

    def __enter__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="kfast")
        self._log = self._path("edges")
        self._control, self._qtest = self._listen("control"), self._listen("qtest")
        return self

    def __exit__(self, *_):
        self._control.close()
        self._qtest.close()
        self._folder.cleanup()

    def machine(self):
        return Machine((*VIRT, "-S", "-dtb", self._device_tree(), "-qtest-log", self._log,
                        "-chardev", f"socket,id=qtest,path={self._path('qtest')}", "-qtest", "chardev:qtest",
                        "-chardev", f"socket,id=control,path={self._path('control')}",
                        "-mon", "chardev=control,mode=control"),
                       "ttyAMA0", self._root)

    def watch(self):
        """Has the lines' changes told from now on, and the guest begin."""
        control, qtest = QemuControl(accepted(self._control)), accepted(self._qtest)
        parts = control.command("qom-list", path="/machine/unattached")
        (chip,) = (part["name"] for part in parts if part["type"] == "child<pl061>")
        qtest.sendall(f"irq_intercept_out /machine/unattached/{chip}\n".encode())
        expect(qtest.recv(64) == b"OK\n", "QEMU does not tell what happens at the GPIO chip")
        threading.Thread(target=drain, args=(qtest,), daemon=True).start()
        control.command("cont")

    def edges(self):
        """All changes, in order. Their times are those of the clock that the guest's clock runs by."""
        with open(self._log, "rb") as log:
            for line in log:
                found = EDGE.match(line)
                if found:
                    seconds, micros, verb, number = found.groups()
                    yield Edge((int(seconds) * 1_000_000 + int(micros)) * 1000, int(number), verb == b"raise")

    def _device_tree(self):
        machine = self._path("machine.dtb")
        subprocess.run([*VIRT, "-M", f"dumpdtb={machine}", "-display", "none"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=PATIENCE)
        source = converted(machine, "dtb", "dts").decode().removeprefix("/dts-v1/;\n")
        pathlib.Path(self._path("machine.dts")).write_text(source, encoding="utf-8")
        pathlib.Path(self._path("board.dtb")).write_bytes(
            converted(DEVICE_TREE, "dts", "dtb", "-i", self._folder.name))
        return self._path("board.dtb")

    def _path(self, name):
        return str(pathlib.Path(self._folder.name, name))

    def _listen(self, name):
        listener = socket.socket(socket.AF_UNIX)
        listener.bind(self._path(name))
        listener.listen(1)
        listener.settimeout(PATIENCE)
        return listener


def converted(path, kind, other_kind, *options):
    return subprocess.run(["dtc", "-q", "-I", kind, "-O", other_kind, *options, str(path)], stdout=subprocess.PIPE,
                          check=True, timeout=PATIENCE).stdout


def accepted(listener):
    connection = listener.accept()[0]
    connection.settimeout(PATIENCE)
    return connection


def drain(connection):
    """QEMU tells everything twice, and the log has the times; but it waits until this is read as well."""
    connection.settimeout(None)
    while connection.recv(1 << 16):
        pass
