import { fail, hex } from './emulation_error.mjs';

export const sectorBytes = 4096;
export const pageBytes = 256;

/** Of a chip that is given no other number; no two chips have the same. */
export const uniqueId = Uint8Array.of(0xe4, 0x61, 0x38, 0x52, 0xc7, 0x1b, 0x9d, 0x0f);

const readUniqueId = 0x4b;
const silentBytes = 4;

/**
 * The flash chip: NOR flash, which is erased by sectors and programmed by pages. Of commands that are sent by hand it
 * knows one, for its number.
 */
export class FlashChip {
    #sent = [];
    /** Bits that have worn out and read as 0: offsets and masks. */
    #stuck = new Map();

    /**
     * @param {Uint8Array} memory its contents, which change when it is written
     * @param {Uint8Array} number of eight bytes
     */
    constructor(memory, number = uniqueId) {
        this.memory = memory;
        this.number = number;
    }

    /** From now on the bits of `mask` in the byte at `offset` are 0, whatever is done. */
    stick(offset, mask) {
        this.#stuck.set(offset, mask);
        this.#wearOut();
    }

    /** A command begins. */
    select() {
        this.#sent = [];
    }

    /** Takes a byte of a command, and says one meanwhile. */
    exchange(byte) {
        this.#sent.push(byte);
        if (this.#sent[0] !== readUniqueId)
            fail(`flash: the command ${hex(this.#sent[0])} is not modelled`);
        const place = this.#sent.length - 2 - silentBytes;
        return this.number[place] ?? 0xff;
    }

    erase(offset, count) {
        if (offset % sectorBytes || count % sectorBytes || offset + count > this.memory.length)
            fail(`flash: ${hex(count)} bytes at ${hex(offset)} cannot be erased: they are not whole sectors of it`);
        this.memory.fill(0xff, offset, offset + count);
        this.#wearOut();
    }

    /** Bits can be cleared, not set. */
    program(offset, bytes) {
        if (offset % pageBytes || bytes.length % pageBytes || offset + bytes.length > this.memory.length)
            fail(`flash: ${hex(bytes.length)} bytes at ${hex(offset)} cannot be programmed: they are not whole pages`);
        bytes.forEach((byte, i) => (this.memory[offset + i] &= byte));
    }

    /** Something broke off that changed these bytes: nobody can tell what they are. */
    spoil(offset, count) {
        for (let i = offset, seed = offset; i < offset + count; ++i) {
            seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
            this.memory[i] = seed >>> 24;
        }
        this.#wearOut();
    }

    #wearOut() {
        this.#stuck.forEach((mask, offset) => (this.memory[offset] &= ~mask));
    }
}
