import { BasePeripheral } from 'rp2040js';

import { fail } from './emulation_error.mjs';

const SSIENR = 0x08;
const SR = 0x28;
const DR0 = 0x60;
const SS_CTRL = 0x0c; // of IO_QSPI
const names = new Map([[0x00, 'CTRLR0'], [0x04, 'CTRLR1'], [SSIENR, 'SSIENR'], [0x10, 'SER'], [0x14, 'BAUDR'],
    [0xf0, 'RX_SAMPLE_DLY'], [0xf4, 'SPI_CTRLR0']]);
const statusIdle = 0x6; // the FIFO to the flash is empty and not full
const SR_RFNE = 1 << 3;
const fifoBytes = 16;

const CTRLR0_DFS_32_8_BITS = 7 << 16;
const CTRLR0_DFS_32_32_BITS = 31 << 16;
const CTRLR0_TMOD_EEPROM_READ = 3 << 8;
/** Words of memory: sent is what to read, and then received. */
const wholeReads = CTRLR0_DFS_32_32_BITS | CTRLR0_TMOD_EEPROM_READ;
const SPI_CTRLR0_INST_L_8_BITS = 2 << 8;
const SPI_CTRLR0_ADDR_L_24_BITS = 6 << 2;
/** What SPI_CTRLR0 must say so that the flash understands what is sent: read (03h), and fast read (0Bh). */
const readsAs = (command, waitCycles) => (command << 24) | (waitCycles << 11) | SPI_CTRLR0_INST_L_8_BITS
    | SPI_CTRLR0_ADDR_L_24_BITS;
const reads = [readsAs(0x03, 0), readsAs(0x0b, 8)];

/** The pins to the flash (IO_QSPI), of which firmware may only force the one that selects it. */
class FlashPins extends BasePeripheral {
    /** 0: as the interface says, 2: low, 3: high. */
    forced = 0;

    constructor(mcu, changed) {
        super(mcu, 'IO_QSPI');
        this.changed = changed;
    }

    get isSelected() {
        return this.forced === 2;
    }

    force(how) {
        this.forced = how;
        this.changed();
    }

    /** As flushing the cache does. */
    release() {
        if (this.isSelected)
            fail('flash: a command has not ended when the chip is to be read again');
        this.force(0);
    }

    readUint32(offset) {
        return offset === SS_CTRL ? this.forced << 8 : super.readUint32(offset);
    }

    writeUint32(offset, value) {
        if (offset !== SS_CTRL || value & ~0x300)
            return super.writeUint32(offset, value);
        this.force(value >>> 8);
    }
}

/**
 * The unit that turns reads of the flash window into commands for the flash chip (SSI). rp2040js has only its
 * status; this records what is written and tells whether code could be fetched the way it stands. Bytes sent by hand
 * go to the chip at once, and only in the way that the boot ROM sets up. Modes with two or four data lines are not
 * modelled.
 */
export class FlashInterface extends BasePeripheral {
    /** All that was written, in order: [register, value]. */
    writes = [];
    /** Called when isReadable() may have changed. */
    onChange = () => {};

    #values = { CTRLR0: 0, CTRLR1: 0, SSIENR: 0, SER: 1, BAUDR: 0, RX_SAMPLE_DLY: 0, SPI_CTRLR0: 0 };

    /** What the chip has said and nobody has read. */
    #received = [];

    constructor(mcu, chip) {
        super(mcu, 'SSI');
        this.chip = chip;
        this.pins = new FlashPins(mcu, () => this.#pinsChanged());
    }

    /** Fetching code as the boot ROM sets it up: slowly. */
    readSlowly() {
        Object.assign(this.#values, { CTRLR0: wholeReads, CTRLR1: 0, BAUDR: 6, SPI_CTRLR0: reads[0], SSIENR: 1 });
        this.onChange();
    }

    /** The flash listens to commands, and nothing can be fetched. The ROM leaves the chip's select forced high. */
    stopReading() {
        Object.assign(this.#values, { CTRLR0: CTRLR0_DFS_32_8_BITS, CTRLR1: 0, BAUDR: 6, SSIENR: 1 });
        this.#received = [];
        this.pins.force(3);
    }

    isReadable() {
        const { CTRLR0, CTRLR1, SSIENR: enabled, SER, BAUDR, SPI_CTRLR0 } = this.#values;
        return this.pins.forced === 0 && enabled === 1 && CTRLR0 === wholeReads && CTRLR1 === 0 && SER === 1
            && BAUDR >= 2 && BAUDR % 2 === 0 && reads.includes(SPI_CTRLR0);
    }

    readUint32(offset) {
        if (offset === SR)
            return statusIdle | (this.#received.length > 0 ? SR_RFNE : 0);
        if (offset === DR0)
            return this.#received.shift() ?? fail('SSI: a byte is read that is not there');
        return this.#values[names.get(offset)] ?? super.readUint32(offset);
    }

    writeUint32(offset, value) {
        if (offset === DR0)
            return this.#send(value & 0xff);
        const name = names.get(offset);
        if (name === undefined)
            return super.writeUint32(offset, value);
        if (this.#values.SSIENR && offset !== SSIENR)
            fail(`SSI: ${name} is written while the unit is enabled, which it ignores`);
        this.writes.push([name, value >>> 0]);
        this.#values[name] = value;
        this.onChange();
    }

    #send(byte) {
        const { CTRLR0, SSIENR: enabled } = this.#values;
        if (!enabled || CTRLR0 !== CTRLR0_DFS_32_8_BITS || !this.pins.isSelected)
            fail('SSI: a byte is sent, but the unit is not set up for that, or the chip not selected');
        if (this.#received.length === fifoBytes)
            fail('SSI: more is sent than is read');
        this.#received.push(this.chip.exchange(byte));
    }

    #pinsChanged() {
        if (this.pins.isSelected)
            this.chip.select();
        this.onChange();
    }
}
