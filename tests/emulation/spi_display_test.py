"""What a display is taken to see of GPIO lines: spi_display_test.py"""

import struct
import unittest

from gpio_machine import MOSI, SCK, SELECT, Edge
from panel_trace import SIGNATURE, Kind
from spi_display import BACKLIGHT, DC, MARK, RESET, sections

BIT = 1000  # nanoseconds


class Lines:
    """Changes of lines, one each BIT."""

    def __init__(self):
        self.edges = []

    def set(self, line, level):
        self.edges.append(Edge(BIT * (len(self.edges) + 1), line, level))
        return self

    def bits(self, text):
        for bit in text:
            self.set(MOSI, bit == "1").set(SCK, True).set(SCK, False)
        return self

    def mark(self):
        return self.set(MARK, True).set(MARK, False)


def records(section):
    """Kinds and contents, without the looks."""
    trace, found = bytes(section.trace.removeprefix(SIGNATURE)), []
    while trace:
        kind, _, count = struct.unpack_from("<BQI", trace)
        found.append((Kind(kind), trace[13:13 + count]))
        trace = trace[13 + count:]
    return [record for record in found if record[0] != Kind.NOTE]


class SpiDisplayTest(unittest.TestCase):
    def test_bits_are_taken_when_the_clock_rises_and_the_first_is_the_highest(self):
        lines = Lines().mark().set(SELECT, False).bits("00101010").set(DC, True).bits("10000001" "11111111")
        (section,) = sections(lines.set(SELECT, True).edges)
        self.assertEqual(records(section), [(Kind.SELECTED, b""), (Kind.COMMAND, b"\x2a"), (Kind.DATA, b"\x81\xff"),
                                            (Kind.RELEASED, b"")])
        self.assertEqual(len(section.looks), 2)

    def test_bits_for_others_are_not_taken(self):
        (section,) = sections(Lines().mark().bits("00101010").edges)
        self.assertEqual(records(section), [])

    def test_a_byte_must_not_be_broken_off(self):
        for line, level in ((DC, True), (SELECT, True), (RESET, True)):
            lines = Lines().mark().set(SELECT, False).bits("0010101").set(line, level)
            with self.assertRaisesRegex(AssertionError, "within a byte"):
                sections(lines.edges)

    def test_a_section_begins_with_a_mark_and_lines_stay_as_they_were(self):
        lines = Lines().set(DC, True).set(RESET, True).mark().set(RESET, False).set(RESET, True).set(BACKLIGHT, True)
        lines.mark().set(SELECT, False).bits("00000001").set(SELECT, True)
        first, second = sections(lines.edges)
        self.assertEqual(records(first), [(Kind.RESET_LOW, b""), (Kind.RESET_HIGH, b"")])
        self.assertEqual((first.resets, first.backlight), (1, [(4 * BIT, True)]))
        self.assertEqual(records(second)[1], (Kind.DATA, b"\x01"))
        self.assertEqual(second.last_data, 4 * BIT)


if __name__ == "__main__":
    unittest.main()
