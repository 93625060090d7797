"""QEMU without a window, its UART and its control port on sockets."""

import os
import pathlib
import socket
import subprocess
import tempfile
import time

from qemu_control import QemuControl


def loaded(path, address):
    """The arguments that put a file into the machine's memory."""
    return ["-device", f"loader,file={path},addr={address:#x},force-raw=on"]


class Qemu:
    """`with Qemu(arguments) as qemu:` runs a machine; it is killed at the end, whatever happens. An instruction
    lasts 2^pace ns."""

    def __init__(self, arguments, timeout=30, pace=5):
        self._arguments = arguments
        self._pace = pace
        self._timeout = timeout

    def __enter__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="qemu")
        self._deadline = time.monotonic() + self._timeout
        self._received = b""
        self._process = None
        try:
            self._start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        if self._process is not None:
            self._process.kill()
            self._process.wait()
        self._folder.cleanup()

    def _start(self):
        control, uart = self._listen("control"), self._listen("uart")
        command = ["qemu-system-arm", "-display", "none", "-monitor", "none", "-nodefaults", "-nic", "none",
                   "-icount", f"shift={self._pace},sleep=off",
                   "-chardev", f"socket,id=control,path={self._path('control')}",
                   "-mon", "chardev=control,mode=control",
                   "-chardev", f"socket,id=uart,path={self._path('uart')}", "-serial", "chardev:uart"]
        silent = os.environ | {"QEMU_AUDIO_DRV": "none"}  # or it looks for loudspeakers
        with open(self._path("stderr"), "wb") as errors:
            self._process = subprocess.Popen(command + self._arguments, stdin=subprocess.DEVNULL, stderr=errors,
                                             env=silent)
        self._control = QemuControl(self._accept(control), self.errors)
        self._uart = self._accept(uart)

    def _path(self, name):
        return str(pathlib.Path(self._folder.name, name))

    def _listen(self, name):
        listener = socket.socket(socket.AF_UNIX)
        listener.bind(self._path(name))
        listener.listen(1)
        return listener

    def _accept(self, listener):
        with listener:
            listener.settimeout(self._remaining())
            connection = listener.accept()[0]
        connection.settimeout(self._timeout)
        return connection

    def _remaining(self):
        remaining = self._deadline - time.monotonic()
        if remaining <= 0:
            raise TimeoutError(f"QEMU took longer than {self._timeout} s; unread: {self._received!r}; {self.errors()}")
        return remaining

    def errors(self):
        """What QEMU has written to stderr."""
        return pathlib.Path(self._path("stderr")).read_text(encoding="utf-8")

    def screenshot(self, path):
        """Writes what the display shows now as PNG."""
        self._control.command("screendump", filename=str(pathlib.Path(path).absolute()), format="png")

    def memory(self, address, size):
        """What lies in the machine's memory now."""
        self._control.command("pmemsave", val=address, size=size, filename=self._path("memory"))
        return pathlib.Path(self._path("memory")).read_bytes()

    def send(self, data):
        self._uart.sendall(data)

    def line(self):
        """The next line from the UART."""
        while b"\n" not in self._received:
            self._uart.settimeout(self._remaining())
            try:
                data = self._uart.recv(4096)
            except socket.timeout:
                self._remaining()
                raise
            if not data:
                raise EOFError(f"the UART was closed; unread: {self._received!r}; {self.errors()}")
            self._received += data
        line, self._received = self._received.split(b"\n", 1)
        return line.decode("ascii", "replace")
