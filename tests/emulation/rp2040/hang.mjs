import { flashAddress } from './board.mjs';

const place = 0x3ff00; // in flash, behind the board record
const sleepForEver = [0xbf30, 0xe7fd]; // wfi; b to it
const soonNanos = 10e3;

/**
 * A firmware that hangs when its log tells certain lines, as it would in a picture that takes for ever: interrupts are
 * served, and nothing else goes on. Emulated time passes quickly meanwhile.
 */
export class Hang {
    /** How often it happened. */
    count = 0;

    /** @param isReason of a line of the log */
    constructor({ board, log }, isReason) {
        this.board = board;
        const heed = log.onLine;
        log.onLine = (line, nanos) => {
            heed(line, nanos);
            if (isReason(line))
                this.#await(board.mcu);
        };
        const memory = new DataView(board.memory.buffer);
        sleepForEver.forEach((code, i) => memory.setUint16(place + 2 * i, code, true));
    }

    /** Until no interrupt is served or masked. */
    #await(mcu) {
        if (mcu !== this.board.mcu)
            return;
        const { core } = mcu;
        if (core.IPSR !== 0 || core.PM)
            this.board.clock.createAlarm(() => this.#await(mcu)).schedule(soonNanos);
        else
            this.#hang(core);
    }

    #hang(core) {
        core.PC = flashAddress + place;
        core.waiting = false;
        ++this.count;
    }
}
