"""Bytes that the commands take for a firmware of the Pico."""

import struct

MARK = 0x1A8


def mpeg2_crc(data):
    state = 0xFFFFFFFF
    for byte in data:
        state ^= byte << 24
        for _ in range(8):
            state = (state << 1 ^ (0x04C11DB7 if state >> 31 else 0)) & 0xFFFFFFFF
    return state


def firmware(size, mark=b"KFPI\0\0\0\0", length=None):
    """Bytes that a Pico would start; they say that they are for SPI, and how many they are."""
    code = bytes(index % 251 for index in range(252))
    image = code + struct.pack("<I", mpeg2_crc(code)) + bytes(range(256)) * (size // 256)
    image = image[:MARK] + mark + image[MARK + len(mark):]
    return (image[:MARK + 8] + struct.pack("<I", size if length is None else length) + image[MARK + 12:])[:size]
