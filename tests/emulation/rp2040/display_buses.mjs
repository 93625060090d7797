import { fail, hex } from './emulation_error.mjs';
import { PinFunction, belongsTo, driven } from './pins.mjs';
import { timeI2c } from './timed_i2c.mjs';
import { timeSpi } from './timed_spi.mjs';

/** Connects a Display to the SPI unit that its settings' pins belong to. */
export class SpiBus {
    constructor(display) {
        this.display = display;
    }

    attach({ mcu }) {
        const { clock, data } = this.display.settings.pins;
        const gpio = [clock, data].map((pin) => mcu.gpio[pin]);
        const wired = (clock >>> 3) & 1;
        let bytes;
        const begin = (word, bits) => {
            if (!gpio.every((pin) => belongsTo(pin, PinFunction.spi)))
                fail('SPI sends, but its pins are not connected to it');
            bytes = bytesOf(word, bits);
            this.display.beginWord();
        };
        timeSpi(mcu, mcu.spi[wired], { begin, end: (nanos) => this.display.endWord(bytes, nanos) });
        mcu.spi[1 - wired].onTransmit = () => fail('the SPI unit is used that the display is not wired to');
    }
}

function bytesOf(word, bits) {
    if (bits === 8)
        return [word];
    return bits === 16 ? [word >>> 8, word & 0xff] : fail(`SPI sends words of ${bits} bits`);
}

const commandsFollow = 0x00;
const dataFollow = 0x40;

/** Connects a Display to the I2C unit that its settings' pins belong to. Control bytes tell what bytes are. */
export class I2cBus {
    /** Whether the display acknowledges its address. */
    answers = (address) => address === this.display.settings.address
        || fail(`I2C calls address ${hex(address)}, which nobody has`);
    /** Whether the display has let go of the wires. */
    isFree = () => true;

    constructor(display) {
        this.display = display;
    }

    attach(board) {
        const { display } = this;
        const { clock, data } = display.settings.pins;
        const gpio = [clock, data].map((pin) => board.mcu.gpio[pin]);
        let control;
        timeI2c(board.mcu, (clock >>> 1) & 1, {
            start: (address) => {
                if (!gpio.every((pin) => belongsTo(pin, PinFunction.i2c)))
                    fail('I2C sends, but its pins are not connected to it');
                if (!this.isFree())
                    fail('I2C sends, but the display is still in the middle of a byte');
                if (!this.answers(address))
                    return false;
                control = undefined;
                display.select(board.nanos, true);
                return true;
            },
            byte: (value, nanos) => {
                if (control === undefined)
                    control = checkedControl(value);
                else
                    display.take(control === dataFollow, board.nanos - nanos, board.nanos, [value]);
            },
            stop: () => display.select(board.nanos, false),
        });
    }
}

function checkedControl(value) {
    return value === commandsFollow || value === dataFollow ? value : fail(`I2C: control byte ${hex(value)}`);
}

/**
 * Connects a Display to eight data pins and WR: a byte is taken when WR rises while the display is selected.
 *
 * Its times, all in nanoseconds, are the shortest that were seen: write cycle (from one rise to the next), WR low, WR
 * high, data and D/C steady before the rise.
 */
export class ParallelBus {
    shortest = { cycle: Infinity, low: Infinity, high: Infinity, setup: Infinity };

    #rose = -Infinity;
    #fell = -Infinity;
    #changed = -Infinity;

    constructor(display) {
        this.display = display;
    }

    attach(board) {
        const { mcu } = board;
        const { clock, data, dc } = this.display.settings.pins;
        this.board = board;
        this.pins = Array.from({ length: 8 }, (_, bit) => mcu.gpio[data + bit]);
        for (const pin of [...this.pins, mcu.gpio[dc]])
            pin.addListener(() => (this.#changed = board.nanos));
        let high = true;
        mcu.gpio[clock].addListener(() => {
            const level = driven(mcu.gpio[clock]) ?? true;
            if (level !== high)
                (high = level) ? this.#rise() : this.#fall();
        });
    }

    #fall() {
        this.#fell = this.board.nanos;
        this.#least('high', this.#fell - this.#rose);
    }

    #rise() {
        const now = this.board.nanos;
        if (this.display.isSelected) {
            this.#least('cycle', now - this.#rose);
            this.#least('low', now - this.#fell);
            this.#least('setup', now - this.#changed);
            this.display.take(this.display.dataLevel(), now - this.#writeNanos(now - this.#rose), now, [this.#byte()]);
        }
        this.#rose = now;
    }

    /** How long the bus was busy with a byte that came so long after the one before: a pause does not count. */
    #writeNanos(since) {
        return since < 1.5 * this.shortest.cycle ? since : this.shortest.cycle;
    }

    #least(what, nanos) {
        this.shortest[what] = Math.min(this.shortest[what], nanos);
    }

    #byte() {
        return this.pins.reduce((byte, pin, bit) => byte | ((driven(pin) ?? fail(`D${bit} is not driven`)) << bit), 0);
    }
}

/** The bus that a Display is wired to. */
export function busFor(display) {
    return new { spi: SpiBus, i2c: I2cBus, parallel: ParallelBus }[display.settings.bus](display);
}
