const firstAnalogPin = 26;

/**
 * What somebody does to buttons (switches to ground) and knobs, at times.
 *
 * @typedef {{pin: number, nanos: number, level: boolean | undefined}} Switching undefined: nobody holds the pin
 * @typedef {{pin: number, nanos: number, value: number}} Turning value: what the converter reads, 0 … 4095
 */
export class Controls {
    /** @param {(Switching | Turning)[]} actions */
    constructor(inputs, actions) {
        this.inputs = inputs;
        this.actions = [...actions].sort((a, b) => a.nanos - b.nanos);
    }

    attach(board) {
        const next = () => {
            while (this.actions.length && this.actions[0].nanos <= board.nanos)
                this.#act(board, this.actions.shift());
            if (this.actions.length)
                board.clock.createAlarm(next).schedule(this.actions[0].nanos - board.nanos);
        };
        next();
    }

    #act(board, action) {
        if ('value' in action)
            board.mcu.adc.channelValues[action.pin - firstAnalogPin] = action.value;
        else
            this.inputs.set(action.pin, action.level);
    }
}
