import { fail } from './emulation_error.mjs';

const bitNanos = 1e9 / 12e6;
/** Of a transaction: the token with its sync and the gap before it, and the rest that is no data. */
const tokenBytes = 4;
const otherBytes = 9;
const setupBytes = 8;
const longestPacket = 64;
const frameNanos = 1e6;

// What USB 2.0 allows a device, chapter 9.2.6
const resetNanos = 10e6;
const recoveryNanos = 10e6;
const addressNanos = 2e6;
const strict = { dataNanos: 500e6, statusNanos: 50e6 };

/** For how long a device may make a computer wait that is as patient as Linux. */
export const asLinux = { dataNanos: 5000e6, statusNanos: 5000e6 };

const control = (isIn) => ({ number: 0, isIn });

/** A request as its eight bytes. */
export function request(type, number, value = 0, index = 0, length = 0) {
    const word = (bits) => [bits & 0xff, bits >>> 8];
    return Uint8Array.of(type, number, ...word(value), ...word(index), ...word(length));
}

/** A text, out of a string descriptor. */
export function textOf(descriptor) {
    return Buffer.from(descriptor.subarray(2)).toString('utf16le');
}

/**
 * A computer with one plug, and a board in it. It knows which of DATA0 and DATA1 has to come, and keeps to the times
 * of full speed and of what a device is allowed: every call lets the board run for as long as it would take.
 */
export class UsbHost {
    /** How often a device that had nothing, or no room, was asked in vain. */
    naks = 0;
    /** Interrupt endpoints have one. */
    turnsPerFrame = 1;

    #address = 0;
    #toggles = new Map();

    /** @param limits for how long the device may make it wait: as USB says, unless told */
    constructor(board, limits = strict) {
        this.board = board;
        this.limits = limits;
    }

    get unit() {
        return this.board.mcu.usbCtrl;
    }

    get attached() {
        return this.unit.attached;
    }

    get nanos() {
        return this.board.nanos;
    }

    run(nanos) {
        this.board.run(this.board.nanos + nanos);
        if (this.board.ending !== undefined)
            fail(`the board's run ended: ${this.board.ending}`);
    }

    /** Waits until something is plugged in. */
    awaitDevice(nanos) {
        const end = this.board.nanos + nanos;
        while (this.board.nanos < end && !this.unit.attached)
            this.run(frameNanos);
        if (!this.unit.attached)
            fail('no USB device is plugged in');
    }

    reset() {
        this.#address = 0;
        this.#toggles.clear();
        this.unit.reset();
        this.run(resetNanos + recoveryNanos);
    }

    suspend() {
        this.unit.suspend();
    }

    resume() {
        this.unit.resume();
        this.run(recoveryNanos);
    }

    /** Gives the device its address. */
    setAddress(address) {
        const answer = this.control(request(0x00, 5, address));
        this.run(addressNanos);
        this.#address = address;
        return answer;
    }

    /**
     * A whole control transfer.
     * @param {Uint8Array} setup tells by itself which way data go, and how many
     * @param {Uint8Array} data to the device
     * @returns {Uint8Array | 'stall'} what came from the device, nothing if data went the other way
     */
    control(setup, data = new Uint8Array(0)) {
        const length = setup[6] | (setup[7] << 8);
        const comesIn = !!(setup[0] & 0x80) && length > 0;
        if (!comesIn && data.length !== length)
            fail(`USB: a request for ${length} bytes has ${data.length}`);
        this.setup(setup);
        const answer = comesIn ? this.#controlIn(length) : this.#controlOut(data);
        if (answer !== 'stall')
            this.#beginAnew(setup);
        return answer;
    }

    /** The beginning of a control transfer alone. */
    setup(packet) {
        if (!this.unit.hears(this.#address))
            fail(`USB: no device has the address ${this.#address}`);
        this.run(this.#nanosOf(tokenBytes + otherBytes + setupBytes));
        this.unit.setup(packet);
        for (const isIn of [false, true])
            this.#setToggle(control(isIn), 1);
    }

    /** A packet from the device, once: bytes, 'nak', 'stall' or 'timeout'. */
    askOnce(number) {
        const endpoint = { number, isIn: true };
        const answer = this.#token(endpoint);
        this.run(this.#nanosOf(otherBytes));
        if (answer !== 'ready')
            return answer;
        this.run(this.#nanosOf(this.unit.lengthOf(endpoint)));
        const { pid, bytes } = this.unit.finishIn(endpoint);
        if (pid !== this.#toggle(endpoint))
            fail(`USB: endpoint ${number} sends DATA${pid}, and the host waits for the other one`);
        this.#setToggle(endpoint, 1 - pid);
        return bytes;
    }

    /** A packet to the device, once: 'ack', 'nak', 'stall' or 'timeout'. */
    sendOnce(number, bytes) {
        const endpoint = { number, isIn: false };
        const answer = this.#token(endpoint);
        this.run(this.#nanosOf(otherBytes + bytes.length));
        if (answer !== 'ready')
            return answer;
        this.unit.finishOut(endpoint, this.#toggle(endpoint), bytes);
        this.#setToggle(endpoint, 1 - this.#toggle(endpoint));
        return 'ack';
    }

    /** Asks until there is an answer, but not for longer than `nanos`. */
    ask(number, nanos = this.limits.dataNanos) {
        return this.#insist(() => this.askOnce(number), nanos);
    }

    send(number, bytes, nanos = this.limits.dataNanos) {
        return this.#insist(() => this.sendOnce(number, bytes), nanos);
    }

    /** Waits for the beginning of the next frame, which is when interrupt endpoints have their turn. */
    nextFrame() {
        this.run(frameNanos - (this.board.nanos % frameNanos));
    }

    #controlIn(length) {
        const parts = [];
        for (let left = length; ;) {
            const packet = this.ask(0);
            if (packet === 'stall')
                return packet;
            if (packet.length > left)
                fail(`USB: the device sends ${packet.length - left} bytes more than it was asked for`);
            parts.push(...packet);
            left -= packet.length;
            if (left === 0 || packet.length < longestPacket)
                break;
        }
        return this.send(0, new Uint8Array(0), this.limits.statusNanos) === 'ack' ? Uint8Array.from(parts) : 'stall';
    }

    #controlOut(data) {
        for (let at = 0; at < data.length; at += longestPacket)
            if (this.send(0, data.subarray(at, at + longestPacket)) === 'stall')
                return 'stall';
        this.#setToggle(control(true), 1);
        const status = this.ask(0, data.length > 0 ? this.limits.dataNanos : this.limits.statusNanos);
        if (status === 'stall')
            return status;
        if (status.length > 0)
            fail('USB: the device ends a transfer with a packet that is not empty');
        return status;
    }

    /** Which endpoints begin with DATA0 again after a request that was obeyed. */
    #beginAnew([type, number, value, , index]) {
        const endpoint = { number: index & 15, isIn: !!(index & 0x80) };
        if ((type === 0x00 && number === 9) || (type === 0x01 && number === 11))
            this.#toggles.clear();
        else if (type === 0x02 && number === 1 && value === 0)
            this.#setToggle(endpoint, 0);
    }

    #token(endpoint) {
        this.run(this.#nanosOf(tokenBytes));
        const answer = this.unit.hears(this.#address) ? this.unit.token(endpoint) : 'timeout';
        if (answer === 'nak')
            ++this.naks;
        return answer;
    }

    #insist(once, nanos) {
        const end = this.board.nanos + nanos;
        while (this.board.nanos < end) {
            const answer = once();
            if (answer === 'timeout')
                fail('USB: the device does not answer');
            if (answer !== 'nak')
                return answer;
        }
        return fail(`USB: the device says NAK for ${nanos / 1e6} ms`);
    }

    #toggle({ number, isIn }) {
        return this.#toggles.get(2 * number + isIn) ?? 0;
    }

    #setToggle({ number, isIn }, pid) {
        this.#toggles.set(2 * number + isIn, pid);
    }

    #nanosOf(bytes) {
        return bytes * 8 * bitNanos;
    }
}
