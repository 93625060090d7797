"""A Pico in the emulator that programs reach over USB/IP."""

import pathlib
import subprocess

from pico import expect

SERVER = pathlib.Path(__file__).resolve().parent / "usbip" / "serve.mjs"


class ServedPico:
    """Boots `image` and plugs it in; if that is None its flash is empty and it is in its boot loader. usbip/serve.mjs has
    the options. What would not work on hardware is an AssertionError at the end of `with`, at the latest."""

    def __init__(self, image, *options):
        expect(image is None or pathlib.Path(image).is_file(), f"{image} is missing: build the preset pico first")
        self._server = subprocess.Popen(["node", SERVER, *map(str, (image or "--blank", *options))],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.port = self._line().removeprefix("port ")

    @property
    def address(self):
        return f"127.0.0.1:{self.port}"

    def command(self, word):
        """Has the server do something, and waits until it is done."""
        self._server.stdin.write(f"{word}\n")
        self._server.stdin.flush()
        self._line()

    def end(self):
        _, complaints = self._server.communicate(timeout=60)
        expect(self._server.returncode == 0, f"the board: {complaints.strip()}")

    def _line(self):
        line = self._server.stdout.readline()
        if not line:
            self.end()
            raise AssertionError("the server ends")
        return line.strip()

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        if kind is None:
            self.end()
        else:
            self._server.kill()
            self._server.communicate()
