"""What the boot ROM of the RP2040 does with what is written to its drive, as in virtual_disk.c of
raspberrypi/pico-bootrom-rp2040, tag b2. Where the blocks lie in the drive's file does not matter to it."""

import struct

from pico import expect

FLASH_ADDRESS, FLASH_BYTES = 0x10000000, 2 * 1024 * 1024
BLOCK, SECTOR, PAGE = 512, 4096, 256
BEGIN, END = (0x0A324655, 0x9E5D5157), 0x0AB16F30
FAMILY, HAS_FAMILY, NOT_FLASH = 0xE48BFF56, 0x2000, 1


class Uf2Drive:
    """Begins with flash that holds something."""

    def __init__(self):
        self.flash = bytearray(b"\x55" * FLASH_BYTES)
        self.has_restarted = False
        self._forget()

    def take(self, file):
        expect(len(file) % BLOCK == 0, f"{len(file)} bytes are no whole blocks")
        for at in range(0, len(file), BLOCK):
            expect(not self.has_restarted, f"the board restarts before block {at // BLOCK} of the file")
            self._take(file[at:at + BLOCK])

    def _forget(self, count=0):
        self._count, self._blocks, self._erased = count, set(), set()

    def _take(self, block):
        first, second, flags, address, size, number, count, family = struct.unpack_from("<8I", block)
        is_block = (first, second) == BEGIN and struct.unpack_from("<I", block, BLOCK - 4)[0] == END
        if not is_block or not flags & HAS_FAMILY or family != FAMILY or flags & NOT_FLASH or size != PAGE:
            return
        offset = address - FLASH_ADDRESS
        if count == 0 or not 0 <= offset <= FLASH_BYTES - PAGE or offset % PAGE:
            self._forget()
            return
        if count != self._count:
            self._forget(count)
        if number < count:
            self._write(number, offset, block[32:32 + PAGE])
        else:
            self._forget()

    def _write(self, number, offset, page):
        """It erases by the numbers of blocks, not by their addresses."""
        if number in self._blocks:
            return
        group = number * PAGE // SECTOR
        if group not in self._erased:
            self._erased.add(group)
            begin = offset // SECTOR * SECTOR
            self.flash[begin:begin + SECTOR] = b"\xff" * SECTOR
        for i, byte in enumerate(page):
            self.flash[offset + i] &= byte
        self._blocks.add(number)
        self.has_restarted = len(self._blocks) == self._count
