"""What a UF2 file for a Pico holds, and where a board looks for it."""

import struct

SETTINGS = 0x1003F000
SCENE = 0x10040000
FAMILY = 0xE48BFF56


def blocks(uf2):
    """(address, payload) of each block, whose fields are checked on the way."""
    assert len(uf2) % 512 == 0
    count = len(uf2) // 512
    for number in range(count):
        block = uf2[512 * number:512 * (number + 1)]
        first, second, flags, address, size, its_number, its_count, family = struct.unpack_from("<8I", block)
        assert (first, second, block[508:]) == (0x0A324655, 0x9E5D5157, struct.pack("<I", 0x0AB16F30))
        assert (flags, size, its_number, its_count, family) == (0x2000, 256, number, count, FAMILY)
        yield address, block[32:288]


def memory(uf2):
    """What lies where: address of each sector -> bytes."""
    sectors = {}
    for address, payload in blocks(uf2):
        sectors.setdefault(address // 4096 * 4096, bytearray()).extend(payload)
    return sectors
