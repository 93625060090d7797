import { BasePeripheral } from 'rp2040js';

import { fail } from './emulation_error.mjs';

const SSIENR = 0x08;
const SR = 0x28;
const names = new Map([[0x00, 'CTRLR0'], [0x04, 'CTRLR1'], [SSIENR, 'SSIENR'], [0x10, 'SER'], [0x14, 'BAUDR'],
    [0xf0, 'RX_SAMPLE_DLY'], [0xf4, 'SPI_CTRLR0']]);
const statusIdle = 0x6; // the FIFO to the flash is empty and not full

const words32Bits = 31 << 16;
const sendThenReceive = 3 << 8;
const commandOf8Bits = 2 << 8;
const addressOf24Bits = 6 << 2;
/** What SPI_CTRLR0 must say so that the flash understands what is sent: read (03h), and fast read (0Bh). */
const readsAs = (command, waitCycles) => (command << 24) | (waitCycles << 11) | commandOf8Bits | addressOf24Bits;
const reads = [readsAs(0x03, 0), readsAs(0x0b, 8)];

/**
 * The unit that turns reads of the flash window into commands for the flash chip (SSI). rp2040js has only its
 * status; this records what is written and tells whether code could be fetched the way it stands. Modes with two or
 * four data lines, and sending by hand, are not modelled.
 */
export class FlashInterface extends BasePeripheral {
    /** All that was written, in order: [register, value]. */
    writes = [];
    /** Called when isReadable() may have changed. */
    onChange = () => {};

    #values = { CTRLR0: 0, CTRLR1: 0, SSIENR: 0, SER: 1, BAUDR: 0, RX_SAMPLE_DLY: 0, SPI_CTRLR0: 0 };

    constructor(mcu) {
        super(mcu, 'SSI');
    }

    /** Fetching code as the boot ROM sets it up: slowly. */
    readSlowly() {
        Object.assign(this.#values, { CTRLR0: words32Bits | sendThenReceive, CTRLR1: 0, BAUDR: 6, SPI_CTRLR0: reads[0],
            SSIENR: 1 });
        this.onChange();
    }

    /** The flash listens to commands, and nothing can be fetched. */
    stopReading() {
        this.#values.SSIENR = 0;
        this.onChange();
    }

    isReadable() {
        const { CTRLR0, CTRLR1, SSIENR: enabled, SER, BAUDR, SPI_CTRLR0 } = this.#values;
        return enabled === 1 && CTRLR0 === (words32Bits | sendThenReceive) && CTRLR1 === 0 && SER === 1
            && BAUDR >= 2 && BAUDR % 2 === 0 && reads.includes(SPI_CTRLR0);
    }

    readUint32(offset) {
        if (offset === SR)
            return statusIdle;
        return this.#values[names.get(offset)] ?? super.readUint32(offset);
    }

    writeUint32(offset, value) {
        const name = names.get(offset);
        if (name === undefined)
            return super.writeUint32(offset, value);
        if (this.#values.SSIENR && offset !== SSIENR)
            fail(`SSI: ${name} is written while the unit is enabled, which it ignores`);
        this.writes.push([name, value >>> 0]);
        this.#values[name] = value;
        this.onChange();
    }
}
