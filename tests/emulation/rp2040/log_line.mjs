import { fail } from './emulation_error.mjs';
import { PinFunction, belongsTo, noPin } from './pins.mjs';
import { timeUart } from './timed_uart.mjs';

/** What the board tells on its log pin, line by line. A line counts for the moment of its first character. */
export class LogLine {
    /** Complete lines: [nanoseconds, text]. */
    lines = [];
    /** Called with each: (text, nanos). */
    onLine = () => {};

    #text = '';
    #began = 0;
    #complete = () => {};

    constructor(settings, trace) {
        this.pin = settings.pins.log;
        this.trace = trace;
    }

    attach(board) {
        const wired = this.pin === noPin ? undefined : ((this.pin + 4) >>> 3) & 1;
        board.mcu.uart.forEach((uart, index) => timeUart(board.mcu, uart, (byte) => {
            if (index !== wired || !belongsTo(board.mcu.gpio[this.pin], PinFunction.uart))
                fail(`${uart.name} sends, but not to the log's pin`);
            this.#take(String.fromCharCode(byte), board.nanos);
        }));
    }

    #take(character, nanos) {
        if (this.#text === '' && character !== '\n') {
            this.#began = nanos;
            this.#complete = this.trace.note(nanos);
        }
        if (character !== '\n') {
            this.#text += character;
            return;
        }
        const text = this.#text.replace(/\r$/, '');
        this.#text = '';
        this.#complete(text);
        this.lines.push([this.#began, text]);
        this.onLine(text, this.#began);
    }
}
