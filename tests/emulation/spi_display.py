"""Takes the changes of GPIO lines for those at the pins of a display on SPI."""

import dataclasses

from gpio_machine import MOSI, SCK, SELECT
from panel_trace import SIGNATURE, Kind, record
from pico import expect

DC, RESET, BACKLIGHT, MARK = 0, 1, 2, 7  # as guest/spi_display.dts has it
LOOK = b"F"  # notes for which kfast-panel tells the picture begin so


@dataclasses.dataclass
class Section:
    """What happened between two marks, with times in nanoseconds since the first of them. The trace has a look at the
    display whenever it is deselected, and at the end."""
    trace: bytearray
    looks: list  # their times
    backlight: list  # of pairs: time and level
    resets: int = 0
    last_data: int = 0


def sections(edges):
    """`edges` between one time that MARK goes high and the next."""
    found, pins, latest = [], Pins(), 0
    for edge in edges:
        latest = edge.nanoseconds
        if edge.line == MARK and edge.level:
            pins.finish(latest)
            found.append(pins.begin(latest))
        pins.see(edge)
    pins.finish(latest)
    return found


class Pins:
    """The display's end of the wires. It samples as displays do: bits when SCK rises, most significant first, D/C with
    each of them. Bytes that are broken off, and D/C that changes within one, are an AssertionError."""

    def __init__(self):
        self._levels = [False] * 8
        self._levels[SELECT] = True
        self._section = None
        self._bits = 0
        self._value = 0
        self._bytes = bytearray()  # of one level of D/C, from self._first on
        self._first = 0

    def begin(self, moment):
        self._section = Section(bytearray(SIGNATURE), [], [])
        self._began = moment
        return self._section

    def finish(self, moment):
        if self._section is not None:
            self._look(moment - self._began)

    def see(self, edge):
        self._levels[edge.line] = edge.level
        if self._section is None:
            return
        moment = edge.nanoseconds - self._began
        if edge.line == SCK:
            if edge.level and not self._levels[SELECT]:
                self._take_bit(moment)
        elif edge.line != MOSI:
            self._take_change(edge.line, edge.level, moment)

    def _take_bit(self, moment):
        if self._bits == 0 and not self._bytes:
            self._first = moment
        self._value = self._value << 1 & 0xFF | self._levels[MOSI]
        self._bits += 1
        if self._bits == 8:
            self._bytes.append(self._value)
            self._bits = 0

    def _take_change(self, line, level, moment):
        expect(self._bits == 0, f"line {line} changes within a byte")
        if line == DC:
            self._close(not level)
        elif line == SELECT:
            self._close(self._levels[DC])
            self._add(Kind.RELEASED if level else Kind.SELECTED, moment)
            if level:
                self._look(moment)
        elif line == RESET:
            self._section.resets += not level
            self._add(Kind.RESET_HIGH if level else Kind.RESET_LOW, moment)
        elif line == BACKLIGHT:
            self._section.backlight.append((moment, level))

    def _close(self, dc):
        """Bytes came while D/C was at that level."""
        if self._bytes:
            self._add(Kind.DATA if dc else Kind.COMMAND, self._first, self._bytes)
            self._bytes = bytearray()
            if dc:
                self._section.last_data = self._first

    def _look(self, moment):
        self._section.looks.append(moment)
        self._add(Kind.NOTE, moment, LOOK + b" %d" % len(self._section.looks))

    def _add(self, kind, moment, content=b""):
        self._section.trace += record(kind, moment, content)
