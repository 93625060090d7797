import { fail } from './emulation_error.mjs';
import { driven } from './pins.mjs';

const shortestHalf = 4700; // nanoseconds, of I2C's standard mode

/**
 * A display on I2C that was interrupted: it holds SDA low until SCL has fallen `clocks` times, and is free when it has
 * seen a stop condition. It is interrupted anew whenever the chip starts.
 */
export class HeldData {
    isFree = false;

    /** @param pins of the settings */
    constructor(inputs, pins, clocks) {
        Object.assign(this, { inputs, pins, clocks });
    }

    attach(board) {
        this.board = board;
        this.isFree = false;
        this.left = this.clocks;
        this.changed = -Infinity;
        this.inputs.set(this.pins.data, false);
        this.scl = this.#watch(this.pins.clock, (high) => this.#clock(high));
        this.sda = this.#watch(this.pins.data, (high) => this.#data(high));
    }

    #clock(high) {
        const now = this.board.nanos;
        if (now - this.changed < shortestHalf)
            fail(`SCL changes after ${now - this.changed} ns`);
        this.changed = now;
        if (!high && --this.left === 0)
            this.inputs.set(this.pins.data, undefined);
    }

    #data(high) {
        this.isFree ||= high && this.left <= 0 && this.scl.high;
    }

    /** Calls `changed` with what the chip makes of the wire; returns that as `high`. */
    #watch(pin, changed) {
        const gpio = this.board.mcu.gpio[pin];
        const wire = { high: true };
        gpio.addListener(() => {
            if (driven(gpio))
                fail(`GP${pin} is driven high, but I2C is for open drains`);
            const high = driven(gpio) ?? true;
            if (high !== wire.high)
                changed((wire.high = high));
        });
        return wire;
    }
}
