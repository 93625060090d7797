import { fail } from './emulation_error.mjs';
import { PinFunction, driven } from './pins.mjs';

/** What the data sheet asks for, nanoseconds (Microchip DS22250A, page 7). */
const least = {
    clockPeriod: 50, clockHigh: 15, clockLow: 15, selectToClock: 40, setup: 15, hold: 10, clockToRelease: 15,
    released: 15, idleBeforeSelect: 40, latchLow: 100, releaseToLatch: 40,
};
const wordBits = 16;
const configuration = 0b111; // buffered, gain 1, not shut down
const bytesOfPoint = 16;

/**
 * A beam's two converters, an MCP4922, and its blank line, as the wires are. Whatever the data sheet does not allow ends
 * the run. Settling of the outputs is not modelled.
 *
 * Nobody drives the wires while the chip starts: a resistor at the blank line keeps the beam dark then.
 */
export class Mcp4922 {
    /** The shortest times that were seen, as `least` has them. */
    shortest = Object.fromEntries(Object.keys(least).map((name) => [name, Infinity]));
    /** Whenever the beam becomes dark (false) or shines: [nanoseconds, shines]. */
    lights = [];
    /** Points that were shown although none had been told: [nanoseconds]. */
    stale = [];
    /** Of a display, which this is not. */
    commands = [];

    #points = []; // [nanoseconds, x, y]
    #word = 0;
    #bits = 0;
    #inputs = [0, 0];
    #told = [false, false];
    #at = { rise: -Infinity, fall: -Infinity, data: -Infinity, selected: -Infinity, released: -Infinity, latch: 0 };
    #level = {};

    constructor({ pins }) {
        this.pins = pins;
    }

    attach(board) {
        this.board = board;
        this.#bits = 0;
        this.#told = [false, false];
        this.#level = { clock: undefined, data: undefined, select: true, ldac: true };
        for (const [role, follow] of Object.entries(this.#followers())) {
            const gpio = board.mcu.gpio[this.pins[role]];
            gpio.addListener(() => this.#follow(role, gpio, follow));
        }
        const blank = board.mcu.gpio[this.pins.blank];
        blank.addListener(() => this.#shine((driven(blank) ?? true) === false));
        this.#shine(false);
    }

    #followers() {
        return {
            data: () => this.#change(),
            clock: (level) => (level ? this.#rise() : this.#fall()),
            select: (level) => (level ? this.#release() : this.#select()),
            ldac: (level) => (level ? this.#endLatch() : this.#latch()),
        };
    }

    #follow(role, gpio, follow) {
        const level = driven(gpio) ?? (role === 'select' || role === 'ldac' ? true : undefined);
        if (level === this.#level[role])
            return;
        const before = this.#level[role];
        this.#level[role] = level;
        if (before !== undefined && level !== undefined)
            follow(level);
    }

    #lasted(name, since) {
        const nanos = this.board.nanos - since;
        if (nanos < least[name])
            fail(`MCP4922: ${name} is ${nanos} ns, at least ${least[name]} are needed`);
        this.shortest[name] = Math.min(this.shortest[name], nanos);
    }

    #change() {
        if (!this.#level.select && this.#bits > 0)
            this.#lasted('hold', this.#at.rise);
        this.#at.data = this.board.nanos;
    }

    #rise() {
        this.#lasted('clockLow', this.#at.fall);
        this.#lasted('clockPeriod', this.#at.rise);
        this.#at.rise = this.board.nanos;
        if (this.#level.select)
            return;
        this.#lasted('selectToClock', this.#at.selected);
        this.#lasted('setup', this.#at.data);
        this.#word = (this.#word << 1) | (this.#level.data ? 1 : 0);
        this.#bits += 1;
    }

    #fall() {
        this.#lasted('clockHigh', this.#at.rise);
        this.#at.fall = this.board.nanos;
    }

    #select() {
        this.#lasted('released', this.#at.released);
        this.#lasted('idleBeforeSelect', Math.max(this.#at.rise, this.#at.fall));
        if (this.board.mcu.gpio[this.pins.select].functionSelect !== PinFunction.pio0)
            fail('MCP4922: selected by something else than the state machine');
        this.#at.selected = this.board.nanos;
        this.#word = 0;
        this.#bits = 0;
    }

    #release() {
        this.#lasted('clockToRelease', this.#at.rise);
        this.#at.released = this.board.nanos;
        if (!this.#level.ldac)
            fail('MCP4922: a word is complete while LDAC is low: it would be taken over by itself');
        if (this.#bits !== wordBits)
            fail(`MCP4922: a word of ${this.#bits} bits`);
        if (((this.#word >>> 12) & 7) !== configuration)
            fail(`MCP4922: ${this.#word.toString(16)} is no word for a converter that is buffered, on, and of gain 1`);
        const converter = this.#word >>> 15;
        if (this.#told[converter])
            fail('MCP4922: a converter is told twice before LDAC');
        this.#told[converter] = true;
        this.#inputs[converter] = this.#word & 0xfff;
    }

    #latch() {
        const now = this.board.nanos;
        if (!this.#level.select)
            fail('MCP4922: LDAC falls within a word');
        this.#lasted('releaseToLatch', this.#at.released);
        if (!this.#told.every(Boolean))
            this.stale.push(now);
        this.#told = [false, false];
        this.#at.latch = now;
        this.#points.push([now, ...this.#inputs]);
    }

    #endLatch() {
        this.#lasted('latchLow', this.#at.latch);
    }

    #shine(shines) {
        const last = this.lights.at(-1);
        if (last?.[1] === shines || (!last && !shines))
            return;
        if (last && last[0] === this.board.nanos)
            fail('the beam shines and is dark at the same moment');
        this.lights.push([this.board.nanos, shines]);
    }

    /** All points: nanoseconds (f64), x, y (u16), whether the beam shines (u8), all little-endian, 16 bytes each. */
    points() {
        const bytes = Buffer.alloc(this.#points.length * bytesOfPoint);
        let next = 0;
        let shines = false;
        this.#points.forEach(([nanos, x, y], i) => {
            while (next < this.lights.length && this.lights[next][0] <= nanos)
                shines = this.lights[next++][1];
            bytes.writeDoubleLE(nanos, i * bytesOfPoint);
            bytes.writeUInt16LE(x, i * bytesOfPoint + 8);
            bytes.writeUInt16LE(y, i * bytesOfPoint + 10);
            bytes.writeUInt8(shines ? 1 : 0, i * bytesOfPoint + 12);
        });
        return bytes;
    }
}

/** A pin whose level its own chip reads: two cycles later, as the synchronisers of the inputs have it. */
export class ReadBack {
    constructor(inputs, pin) {
        this.inputs = inputs;
        this.pin = pin;
    }

    attach(board) {
        const gpio = board.mcu.gpio[this.pin];
        const alarm = board.mcu.clock.createAlarm(() => this.inputs.set(this.pin, driven(gpio)));
        gpio.addListener(() => alarm.schedule(2e9 / board.mcu.clkSys));
    }
}
