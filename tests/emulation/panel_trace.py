"""What happens at a display's pins, as `kfast-panel` reads it: see rp2040/trace.mjs."""

import enum
import struct

SIGNATURE = b"KFTRACE1"


class Kind(enum.IntEnum):
    COMMAND = 0  # bytes with D/C low
    DATA = 1  # bytes with D/C high
    RESET_LOW = 2
    RESET_HIGH = 3
    SELECTED = 4
    RELEASED = 5
    NOTE = 6  # a line of text


def record(kind, nanoseconds, content=b""):
    return struct.pack("<BQI", kind, nanoseconds, len(content)) + content
