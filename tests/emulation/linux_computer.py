"""A Linux computer with GPIO chips and SPI devices that are not there: the library of linux/ stands in for the kernel in
front of a real program."""

import os
import pathlib
import struct
import subprocess

LOW, HIGH, RESET_LOW, RESET_HIGH, SELECTED, DESELECTED, NOTE = range(7)  # host/simulator/trace.hpp

CHIP = "label pinctrl-test\nlines 28\nnamed 25 GPIO25\nnamed 27 GPIO27\nnamed 24 GPIO24\nnamed 8 GPIO8\n"


class Wires:
    """What happened, in order: (nanoseconds, what, the rest)."""

    def __init__(self, text):
        self.events = []
        for line in text.splitlines():
            time, what, *rest = line.split(" ")
            self.events.append((int(time), what, rest))

    def levels(self, line):
        """All that the line was set to."""
        return [int(rest[2]) for _, what, rest in self.events if what == "line" and int(rest[1]) == line]

    def transfers(self):
        return [len(rest[1]) // 2 for _, what, rest in self.events if what == "spi"]

    def trace(self, lines):
        """For `kfast-panel`. `lines` maps roles to numbers; with the backlight on, every sleep is the end of a frame."""
        return b"KFTRACE1" + b"".join(Tracer(lines).records(self.events))


class Tracer:
    """What a display sees of the wires that its lines are."""

    def __init__(self, lines):
        self.role = {number: role for role, number in lines.items()}
        self.level = {}
        self.frame = 0
        self.parallel = bytearray()
        self.parallel_begin = 0
        self.parallel_dc = 0

    def records(self, events):
        for time, what, rest in events:
            if what == "line":
                yield from self.line(time, self.role.get(int(rest[1])), int(rest[2]))
            elif what == "spi":
                yield self.bytes(time, self.level["dc"], bytes.fromhex(rest[1]))
            elif what == "slept":
                yield from self.slept(time)

    def record(self, kind, time, content=b""):
        return struct.pack("<BQI", kind, time, len(content)) + content

    def bytes(self, time, dc, content):
        return self.record(HIGH if dc else LOW, time, content)

    def flush(self):
        if self.parallel:
            yield self.bytes(self.parallel_begin, self.parallel_dc, bytes(self.parallel))
            self.parallel.clear()

    def line(self, time, role, level):
        risen = level and not self.level.get(role, level)
        self.level[role] = level
        if role == "wr" and risen:
            yield from self.written(time)
        elif role in ("reset", "select"):
            yield from self.flush()
            kinds = (RESET_LOW, RESET_HIGH) if role == "reset" else (SELECTED, DESELECTED)
            yield self.record(kinds[level], time)

    def written(self, time):
        if self.parallel_dc != self.level["dc"]:
            yield from self.flush()
        if not self.parallel:
            self.parallel_begin, self.parallel_dc = time, self.level["dc"]
        self.parallel.append(sum(self.level[f"data{bit}"] << bit for bit in range(8)))

    def slept(self, time):
        yield from self.flush()
        if self.level.get("backlight"):
            yield self.record(NOTE, time, f"F {self.frame}".encode())
            self.frame += 1


class LinuxComputer:
    """One that `folder` describes; kfast runs on it."""

    def __init__(self, folder, programs, stand_in):
        self.folder = pathlib.Path(folder)
        self.programs = pathlib.Path(programs).resolve()
        self.stand_in = pathlib.Path(stand_in).resolve()
        self.describe("dev/gpiochip0", CHIP)
        self.describe("dev/spidev0.0", "")
        self.describe("sys/bus/gpio/devices/gpiochip0/dev", "254:0\n")
        self.describe("sys/module/spidev/parameters/bufsiz", "4096\n")

    def describe(self, file, text):
        """None: it is not there."""
        path = self.folder / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        if text is not None:
            path.write_text(text)

    def kfast(self, *arguments, stand_in=True):
        environment = dict(os.environ)
        if stand_in:
            (self.folder / "wires").unlink(missing_ok=True)
            environment |= {"LD_PRELOAD": str(self.stand_in), "KFAST_STAND_IN": str(self.folder)}
        return subprocess.run([self.programs / "kfast", *map(str, arguments)], capture_output=True, text=True,
                              timeout=300, env=environment, check=False)

    def wires(self):
        path = self.folder / "wires"
        return Wires(path.read_text() if path.exists() else "")

    def hashes(self, settings, lines):
        """Of every frame that a display with such settings (a text of docs/config.md) has shown, as kfast prints them."""
        (self.folder / "panel.kdl").write_text(settings)
        done = self.kfast("config", self.folder / "panel.kdl", "-o", self.folder / "record.bin", stand_in=False)
        assert done.returncode == 0, done.stderr
        (self.folder / "trace").write_bytes(self.wires().trace(lines))
        done = subprocess.run([self.programs / "kfast-panel", self.folder / "trace", self.folder / "record.bin"],
                              capture_output=True, text=True, timeout=300, check=False)
        assert done.returncode == 0, done.stderr
        return [line.split(" ")[2] for line in done.stdout.splitlines()]
