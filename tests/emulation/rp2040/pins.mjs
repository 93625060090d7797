/** Functions of GPIO pins, by their numbers in CTRL.FUNCSEL. */
export const PinFunction = { spi: 1, uart: 2, i2c: 3, sio: 5, pio0: 6, pio1: 7, null: 31 };

export const noPin = 255;

/** What a pin drives: true for high, false for low, undefined when it does not drive. */
export function driven(gpio) {
    return gpio.outputEnable && !gpio.outputDisable ? gpio.outputValue : undefined;
}

/** Whether a unit of the chip reaches the world through this pin. */
export function belongsTo(gpio, pinFunction) {
    return gpio.functionSelect === pinFunction && !gpio.outputDisable;
}

/**
 * What comes into the chip from outside: levels that somebody drives, and the pulls of the pads where nobody does.
 * rp2040js reads a pin low that only its own pull-up holds.
 */
export class Inputs {
    #driven = new Map();

    attach(board) {
        this.gpio = board.mcu.gpio;
        const pads = board.mcu.peripherals[0x4001c];
        const write = pads.writeUint32.bind(pads);
        pads.writeUint32 = (offset, value) => {
            write(offset, value);
            this.#settle((offset >>> 2) - 1);
        };
        this.gpio.forEach((_, pin) => this.#settle(pin));
    }

    /** @param {boolean | undefined} level undefined: nobody drives the pin */
    set(pin, level) {
        this.#driven.set(pin, level);
        this.#settle(pin);
    }

    #settle(pin) {
        const gpio = this.gpio[pin];
        const level = this.#driven.get(pin) ?? gpio?.pullupEnabled;
        if (gpio && gpio.rawInputValue !== level)
            gpio.setInputValue(level);
    }
}
