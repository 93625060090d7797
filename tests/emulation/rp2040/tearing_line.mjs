const tearingOff = 0x34;
const tearingOn = 0x35;
const sleepIn = 0x10;

/**
 * The TE line of a controller that follows MIPI DCS: once it is switched on it is high for a while after each
 * picture that the glass has shown.
 */
export class TearingLine {
    /** When it rose: [nanoseconds]. */
    rises = [];
    #on = false;

    /** @param {number} period of the glass, nanoseconds */
    constructor(inputs, pin, period, high = 500e3) {
        Object.assign(this, { inputs, pin, period, high });
    }

    attach(board) {
        this.inputs.set(this.pin, false);
        let level = false;
        const alarm = board.clock.createAlarm(() => {
            level = !level;
            this.#set(level, board.nanos);
            alarm.schedule(level ? this.high : this.period - this.high);
        });
        alarm.schedule(this.period - (board.nanos % this.period));
    }

    /** The display has received a command. */
    command(byte) {
        if (byte === tearingOn)
            this.#on = true;
        if (byte === tearingOff || byte === sleepIn)
            this.#on = false;
    }

    #set(level, nanos) {
        this.inputs.set(this.pin, level && this.#on);
        if (level && this.#on)
            this.rises.push(nanos);
    }
}
