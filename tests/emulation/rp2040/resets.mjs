import { BasePeripheral } from 'rp2040js';

import { fail } from './emulation_error.mjs';

const RESET = 0;
const WDSEL = 4;
const RESET_DONE = 8;
const all = 0x1ffffff;

/** Which bit of RESETS holds the unit at a base address in reset. */
const units = new Map([
    [0x4004c000, 0], [0x40030000, 1], [0x50000000, 2], [0x40044000, 3], [0x40048000, 4], [0x40014000, 5],
    [0x40018000, 6], [0x4001c000, 8], [0x40020000, 9], [0x50200000, 10], [0x50300000, 11], [0x40028000, 12],
    [0x4002c000, 13], [0x40050000, 14], [0x4005c000, 15], [0x4003c000, 16], [0x40040000, 17], [0x40004000, 18],
    [0x40000000, 19], [0x4006c000, 20], [0x40054000, 21], [0x40034000, 22], [0x40038000, 23], [0x50110000, 24],
]);
/** What the boot ROM needs and has released: both banks of the flash's pins, and SYSINFO. */
const released = (1 << 6) | (1 << 9) | (1 << 19);

/**
 * The unit that holds others in reset. rp2040js lets all of them run; here one that is touched while it is held
 * ends the run. A unit that is reset again later keeps its registers, unlike the real ones.
 */
export class Resets extends BasePeripheral {
    #held = all & ~released;
    #watchdog = 0;

    /** Takes the place of the emulator's in `mcu` and watches its units. */
    constructor(mcu) {
        super(mcu, 'RESETS');
        mcu.peripherals[0x4000c] = this;
        for (const [base, bit] of units)
            this.#watch(mcu.peripherals[(base >>> 14) << 2], 1 << bit);
    }

    readUint32(offset) {
        switch (offset) {
            case RESET: return this.#held;
            case WDSEL: return this.#watchdog;
            case RESET_DONE: return all & ~this.#held;
            default: return super.readUint32(offset);
        }
    }

    writeUint32(offset, value) {
        switch (offset) {
            case RESET: this.#held = value & all; break;
            case WDSEL: this.#watchdog = value & all; break;
            default: super.writeUint32(offset, value);
        }
    }

    #watch(unit, mask) {
        const readUint32 = unit.readUint32.bind(unit);
        const writeUint32 = unit.writeUint32.bind(unit);
        unit.readUint32 = (offset) => (this.#held & mask ? this.#refuse(unit) : readUint32(offset));
        unit.writeUint32 = (offset, value) => (this.#held & mask ? this.#refuse(unit) : writeUint32(offset, value));
    }

    #refuse(unit) {
        fail(`${unit.name} is touched while it is held in reset`);
    }
}
