import { fail, hex } from './emulation_error.mjs';

export const sectorBytes = 4096;
export const pageBytes = 256;

/** The memory of the flash chip: NOR flash, which is erased by sectors and programmed by pages. */
export class FlashChip {
    /** @param {Uint8Array} memory its contents, which change when it is written */
    constructor(memory) {
        this.memory = memory;
    }

    erase(offset, count) {
        if (offset % sectorBytes || count % sectorBytes || offset + count > this.memory.length)
            fail(`flash: ${hex(count)} bytes at ${hex(offset)} cannot be erased: they are not whole sectors of it`);
        this.memory.fill(0xff, offset, offset + count);
    }

    /** Bits can be cleared, not set. */
    program(offset, bytes) {
        if (offset % pageBytes || bytes.length % pageBytes || offset + bytes.length > this.memory.length)
            fail(`flash: ${hex(bytes.length)} bytes at ${hex(offset)} cannot be programmed: they are not whole pages`);
        bytes.forEach((byte, i) => (this.memory[offset + i] &= byte));
    }
}
