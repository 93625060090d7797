import { fail } from './emulation_error.mjs';
import { driven, noPin } from './pins.mjs';
import { Kind } from './trace.mjs';

/**
 * A display as its wires see it: select, reset and D/C are sampled at the chip's pins, bytes come from a bus. All goes
 * into a trace and is timed.
 */
export class Display {
    /** Bytes that came with D/C low, some of which are parameters of OLEDs: [nanoseconds, byte]. */
    commands = [];
    /** Called with each of them. */
    onCommand = () => {};

    #selected = false;
    #receiving = false;
    #begin = 0;
    #level = false;

    /** @param settings from readSettings() */
    constructor(settings, trace, busTime) {
        this.settings = settings;
        this.trace = trace;
        this.busTime = busTime;
        if (settings.pins.select === noPin)
            this.select(0, true);
    }

    attach(board) {
        const { pins } = this.settings;
        this.board = board;
        this.#watch(pins.select, () => this.select(board.nanos, driven(this.#gpio(pins.select)) === false));
        this.#watch(pins.reset, (level) => this.trace.line(level ? Kind.resetHigh : Kind.resetLow, board.nanos));
        if (this.#selected && pins.select !== noPin)
            this.select(board.nanos, false); // the chip was restarted
    }

    get isSelected() {
        return this.#selected;
    }

    select(nanos, selected) {
        if (selected === this.#selected)
            return;
        if (this.#receiving)
            fail('the display is selected or released within a byte');
        this.#selected = selected;
        this.trace.line(selected ? Kind.selected : Kind.released, nanos);
    }

    /** The first bit of a word appears on the wire. */
    beginWord() {
        this.#begin = this.board.nanos;
        this.#level = this.dataLevel();
        this.#receiving = true;
    }

    /** Its last bit is through, `nanos` after its first. */
    endWord(bytes, nanos) {
        this.#receiving = false;
        if (this.dataLevel() !== this.#level)
            fail('D/C changes within a byte');
        this.take(this.#level, this.#begin, this.#begin + nanos, bytes);
    }

    /** Bytes have arrived; `isData` is D/C. */
    take(isData, begin, end, bytes) {
        if (!this.#selected)
            fail('bytes are sent while the display is not selected');
        this.trace.bytes(isData ? Kind.data : Kind.command, begin, end, bytes);
        this.busTime.bytes(isData, begin, end, bytes.length);
        if (!isData)
            bytes.forEach((byte) => this.#tellCommand(begin, byte));
    }

    #tellCommand(nanos, byte) {
        this.commands.push([nanos, byte]);
        this.onCommand(byte);
    }

    /** D/C as it is driven now. */
    dataLevel() {
        return driven(this.#gpio(this.settings.pins.dc)) ?? fail('bytes are sent, but D/C is not driven');
    }

    #gpio(pin) {
        return this.board.mcu.gpio[pin];
    }

    /** Calls `changed` with what the pin drives, whenever that changes; pulled up where it drives nothing. */
    #watch(pin, changed) {
        if (pin === noPin)
            return;
        let level = true;
        const gpio = this.#gpio(pin);
        gpio.addListener(() => {
            const now = driven(gpio) ?? true;
            if (now !== level)
                changed((level = now));
        });
    }
}
