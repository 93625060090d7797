import { BasePeripheral } from 'rp2040js';

/** Registers that keep what is written and do nothing else. Others stay unknown, and end the run. */
class RegisterFile extends BasePeripheral {
    #values;

    /** @param {[number, number][]} registers offset and value after reset */
    constructor(mcu, name, registers) {
        super(mcu, name);
        this.#values = new Map(registers);
    }

    readUint32(offset) {
        return this.#values.has(offset) ? this.#values.get(offset) : super.readUint32(offset);
    }

    writeUint32(offset, value) {
        if (this.#values.has(offset))
            this.#values.set(offset, value >>> 0);
        else
            super.writeUint32(offset, value);
    }
}

/** The window to the cache of the flash: always ready, as nothing here needs time to be flushed. */
class CacheControl extends RegisterFile {
    constructor(mcu, flushed) {
        super(mcu, 'XIP_CTRL', [[0x00, 3], [0x08, 3]]);
        this.flushed = flushed;
    }

    writeUint32(offset, value) {
        if (offset === 0x04)
            this.flushed();
        else
            super.writeUint32(offset, value);
    }

    readUint32(offset) {
        return offset === 0x04 ? 0 : super.readUint32(offset);
    }
}

/**
 * Gives `mcu` the registers that firmware needs and rp2040js lacks.
 * @param {() => void} flushed the cache of the flash was emptied
 */
export function addRegisters(mcu, flushed) {
    // Firmware may stop the ring oscillator once it runs from the crystal; nothing here depends on it.
    mcu.peripherals[0x40060] = new RegisterFile(mcu, 'ROSC', [[0x00, 0xfab << 12], [0x18, 0x80001000]]);
    // The reason of a reset, and the voltage, which the emulator need not know.
    mcu.peripherals[0x40064] = new RegisterFile(mcu, 'VREG_AND_CHIP_RESET', [[0x00, 0xb1], [0x04, 0], [0x08, 0x100]]);
    mcu.peripherals[0x14000] = new CacheControl(mcu, flushed);
}
