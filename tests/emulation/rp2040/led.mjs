import { driven } from './pins.mjs';

const pin = 25;

/** The light on the board. */
export class Led {
    /** When it went on or off: [nanoseconds]. */
    turns = [];

    attach(board) {
        const gpio = board.mcu.gpio[pin];
        let lit = false;
        gpio.addListener(() => {
            const now = driven(gpio) ?? false;
            if (now !== lit)
                this.turns.push(board.nanos);
            lit = now;
        });
    }
}
