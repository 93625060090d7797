import { request } from './usb_host.mjs';

const magic = 0x431fd10b;
const packetBytes = 64;
const patienceFrames = 5000;

export const configure = request(0x00, 9, 1);
export const interfaceReset = request(0x41, 0x41, 0, 1);
export const getCommandStatus = request(0xc1, 0x42, 0, 1, 16);
export const clearHalt = (address) => request(0x02, 1, 0, address);
export const [out, into] = [3, 4];

/**
 * A computer for tests that says what it is told to a BootLoader, and keeps to no rules of its own. Answers are those of
 * the endpoint that had the last word.
 */
export class BootLoaderComputer {
    #token = 0;

    constructor(device) {
        this.device = device;
        while (!device.attached)
            device.nextFrame();
        device.reset();
        device.control(configure);
    }

    /** The bytes of a command, with any of its fields changed. */
    packet(id, words = [], changes = {}) {
        const { length = 4 * words.length, transfer = 0, reserved = 0, token = ++this.#token } = changes;
        const bytes = new Uint8Array(32);
        const view = new DataView(bytes.buffer);
        [changes.magic ?? magic, token].forEach((word, i) => view.setUint32(4 * i, word, true));
        bytes.set([id, length], 8);
        view.setUint16(10, reserved, true);
        [transfer, ...words].forEach((word, i) => view.setUint32(12 + 4 * i, word, true));
        return bytes;
    }

    /** A command without data: '', or 'stall'. */
    command(...how) {
        return this.send(this.packet(...how)) === 'stall' ? 'stall' : this.receive(0);
    }

    exclusive(how = 1) {
        return this.command(0x01, [how], { length: 1 });
    }

    /** What comes before flash is changed. */
    begin() {
        this.exclusive();
        this.command(0x06);
    }

    erase(address, count) {
        return this.command(0x03, [address, count]);
    }

    write(address, bytes, changes = { transfer: bytes.length }) {
        this.send(this.packet(0x05, [address, bytes.length], changes));
        const answer = this.sendAll(bytes);
        return answer === 'ack' ? this.receive(0) : answer;
    }

    read(address, count) {
        this.send(this.packet(0x84, [address, count], { transfer: count }));
        const bytes = this.receive(count);
        if (typeof bytes !== 'string')
            this.send(new Uint8Array(0));
        return bytes;
    }

    reboot(start = 0, milliseconds = 100) {
        return this.command(0x02, [start, 0x20042000, milliseconds]);
    }

    /** The status code and the token of the last command. */
    status() {
        const bytes = this.device.control(getCommandStatus);
        const view = new DataView(bytes.buffer, bytes.byteOffset);
        return { token: view.getUint32(0, true), code: view.getUint32(4, true), id: bytes[8], inProgress: bytes[9] };
    }

    sendAll(bytes) {
        for (let at = 0; at < bytes.length; at += packetBytes) {
            const answer = this.send(bytes.subarray(at, at + packetBytes));
            if (answer !== 'ack')
                return answer;
        }
        return 'ack';
    }

    send(bytes) {
        return this.#insist(() => this.device.sendOnce(out, bytes));
    }

    /** Bytes, until there are so many or a packet is short; or 'stall' or 'nak'. */
    receive(count) {
        const parts = [];
        for (;;) {
            const packet = this.#insist(() => this.device.askOnce(into));
            if (typeof packet === 'string')
                return packet;
            parts.push(...packet);
            if (parts.length >= count || packet.length < packetBytes)
                return Uint8Array.from(parts);
        }
    }

    #insist(once) {
        for (let frame = 0; frame < patienceFrames; ++frame) {
            const answer = once();
            if (answer !== 'nak')
                return answer;
            this.device.nextFrame();
        }
        return 'nak';
    }
}
