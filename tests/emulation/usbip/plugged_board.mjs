import { request } from '../rp2040/usb_host.mjs';
import { Status } from './messages.mjs';

const address = 1;
const longestPacket = 64;

const getDevice = request(0x80, 6, 0x0100, 0, 18);
const getConfiguration = request(0x80, 6, 0x0200, 0, 255);
const interfaceDescriptor = 4;

/**
 * A board at a port of a computer whose transfers come from elsewhere: a device of UsbIpServer. Time passes in frame()
 * alone, and a transfer waits until the device takes or gives it, however long that is.
 */
export class PluggedBoard {
    /** What the device is, while it can be found; it can leave by itself, and come back. */
    identity;
    /** Called when it has left. */
    onGone = () => {};
    /** How many packets it has taken that were not about control. */
    taken = 0;

    #transfers = [];

    /** @param host what is plugged in, and not started yet: a UsbHost, or a BootLoader */
    constructor(host) {
        this.host = host;
    }

    /** Goes on by a frame of the bus, or by what the control transfers need that wait. */
    frame() {
        const { host } = this;
        host.nextFrame();
        if (!host.attached)
            return this.#leave();
        if (!this.identity)
            return this.#setUp();
        this.#control();
        for (let turn = 0; turn < host.turnsPerFrame && host.attached; ++turn)
            this.#takeTurns();
        return undefined;
    }

    submit(transfer) {
        transfer.passed = new Uint8Array(0);
        this.#transfers.push(transfer);
    }

    cancel(transfer) {
        this.#transfers = this.#transfers.filter((one) => one !== transfer);
    }

    #leave() {
        const wasThere = this.identity !== undefined;
        this.identity = undefined;
        this.#transfers = [];
        if (wasThere)
            this.onGone();
    }

    /** The computer looks who is there before it tells anybody. */
    #setUp() {
        this.#resetPort();
        const device = this.host.control(getDevice);
        const configuration = this.host.control(getConfiguration);
        this.identity = {
            vendor: device[8] | (device[9] << 8),
            product: device[10] | (device[11] << 8),
            release: device[12] | (device[13] << 8),
            kind: device.subarray(4, 7),
            configurations: device[17],
            interfaces: [...descriptors(configuration)].filter((one) => one[1] === interfaceDescriptor)
                .map((one) => one.subarray(5, 8)),
        };
    }

    #resetPort() {
        this.host.reset();
        this.host.setAddress(address);
    }

    #control() {
        for (const transfer of this.#transfers.filter(({ endpoint }) => endpoint.number === 0)) {
            if (beginsAfterReset(transfer.setup))
                this.#resetPort();
            const answer = this.host.control(transfer.setup, transfer.data);
            if (answer === 'stall')
                this.#finish(transfer, Status.stalled, 0);
            else
                this.#finish(transfer, Status.done, transfer.endpoint.isIn ? answer.length : transfer.data.length, answer);
        }
    }

    #takeTurns() {
        for (const transfer of firstOfEach(this.#transfers, ({ endpoint }) => 2 * endpoint.number + endpoint.isIn))
            (transfer.endpoint.isIn ? this.#ask(transfer) : this.#send(transfer));
    }

    #send(transfer) {
        const { data, endpoint, passed } = transfer;
        const packet = data.subarray(passed.length, passed.length + longestPacket);
        const answer = this.host.sendOnce(endpoint.number, packet);
        if (answer === 'ack') {
            ++this.taken;
            transfer.passed = data.subarray(0, passed.length + packet.length);
        }
        if (failures[answer])
            this.#finish(transfer, failures[answer], 0);
        else if (answer === 'ack' && transfer.passed.length === data.length)
            this.#finish(transfer, Status.done, data.length);
    }

    /** What comes is for everybody who waits for it. */
    #ask({ endpoint }) {
        const answer = this.host.askOnce(endpoint.number);
        if (answer === 'nak')
            return;
        const waiting = this.#transfers.filter((one) => one.endpoint.isIn && one.endpoint.number === endpoint.number);
        for (const transfer of firstOfEach(waiting, ({ user }) => user))
            (failures[answer] ? this.#finish(transfer, failures[answer], 0) : this.#receive(transfer, answer));
    }

    #receive(transfer, packet) {
        transfer.passed = Buffer.concat([transfer.passed, packet]);
        const { passed, length } = transfer;
        if (passed.length > length)
            this.#finish(transfer, Status.tooLong, 0);
        else if (passed.length === length || packet.length < longestPacket)
            this.#finish(transfer, Status.done, passed.length, passed);
    }

    #finish(transfer, status, count, data) {
        this.cancel(transfer);
        transfer.finish(status, count, data);
    }
}

const failures = { stall: Status.stalled, timeout: Status.noAnswer };

/**
 * Clients keep resets of a port and addresses to themselves. But Linux asks for 64 bytes of the device's descriptor at
 * the end of a reset, and at no other time.
 */
function beginsAfterReset([type, number, , value, , , low, high]) {
    return type === 0x80 && number === 6 && value === 1 && (low | (high << 8)) === 64;
}

function firstOfEach(transfers, kindOf) {
    const found = new Map();
    for (const transfer of transfers)
        if (!found.has(kindOf(transfer)))
            found.set(kindOf(transfer), transfer);
    return found.values();
}

function* descriptors(configuration) {
    for (let at = 0; at < configuration.length; at += configuration[at])
        yield configuration.subarray(at, at + configuration[at]);
}
