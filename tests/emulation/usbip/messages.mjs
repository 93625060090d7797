// The messages of USB/IP 1.1.1: numbers are big-endian, but for the eight bytes of a setup.

const version = 0x0111;
const listRequest = 0x8005;
const importRequest = 0x8003;
const listReply = 0x0005;
const importReply = 0x0003;

const submit = 1;
const unlink = 2;
const submitted = 3;
const unlinked = 4;

const requestBytes = 8;
const busIdBytes = 32;
const transferBytes = 48;
const mostData = 1 << 20;

const deviceNumber = 2;
const fullSpeed = 2;

/** How a transfer has ended, as Linux numbers it. */
export const Status = { done: 0, stalled: -32, noAnswer: -71, tooLong: -75, cancelled: -104 };

/** Something came that is no message. */
export class WrongMessage extends Error {}

/** Takes apart what comes from a client, in whatever pieces it arrives. */
export class Inbox {
    /** Set when an import was granted: transfers follow. */
    hasDevice = false;

    #bytes = Buffer.alloc(0);

    /**
     * The messages that `piece` completes, one after another: {kind: 'list'}, {kind: 'import', busId},
     * {kind: 'submit', sequence, endpoint, setup, length, data}, {kind: 'unlink', sequence, target}.
     * @throws {WrongMessage}
     */
    * messages(piece) {
        this.#bytes = Buffer.concat([this.#bytes, piece]);
        for (let message; (message = this.hasDevice ? this.#transfer() : this.#request());)
            yield message;
    }

    #request() {
        if (this.#bytes.length < requestBytes)
            return undefined;
        const code = this.#bytes.readUInt16BE(2);
        if (code === listRequest)
            return this.#take(requestBytes) && { kind: 'list' };
        if (code !== importRequest)
            throw new WrongMessage(`no request has the code ${code}`);
        const message = this.#take(requestBytes + busIdBytes);
        return message && { kind: 'import', busId: message.toString('latin1', requestBytes).replace(/\0.*$/s, '') };
    }

    #transfer() {
        if (this.#bytes.length < transferBytes)
            return undefined;
        const kind = this.#bytes.readUInt32BE(0);
        if (kind === submit)
            return this.#submit();
        if (kind !== unlink)
            throw new WrongMessage(`no message about a transfer has the number ${kind}`);
        const message = this.#take(transferBytes);
        return { kind: 'unlink', sequence: message.readUInt32BE(4), target: message.readUInt32BE(20) };
    }

    #submit() {
        const isIn = this.#bytes.readUInt32BE(12) === 1;
        const length = this.#bytes.readUInt32BE(24);
        if (length > mostData)
            throw new WrongMessage(`a transfer of ${length} bytes`);
        const message = this.#take(transferBytes + (isIn ? 0 : length));
        return message && {
            kind: 'submit',
            sequence: message.readUInt32BE(4),
            endpoint: { number: message.readUInt32BE(16), isIn },
            setup: Uint8Array.from(message.subarray(40, transferBytes)),
            length,
            data: Uint8Array.from(message.subarray(transferBytes)),
        };
    }

    #take(count) {
        if (this.#bytes.length < count)
            return undefined;
        const taken = this.#bytes.subarray(0, count);
        this.#bytes = this.#bytes.subarray(count);
        return taken;
    }
}

/** What is plugged in: nothing, or one device; `identity` is PluggedBoard's. */
export function listed(busId, identity) {
    const count = Buffer.alloc(4);
    count.writeUInt32BE(identity ? 1 : 0);
    const kinds = identity ? identity.interfaces.map((kind) => Buffer.from([...kind, 0])) : [];
    return Buffer.concat([reply(listReply, 0), count, ...(identity ? [device(busId, identity)] : []), ...kinds]);
}

export function imported(busId, identity) {
    return Buffer.concat([reply(importReply, 0), device(busId, identity)]);
}

export function refused() {
    return reply(importReply, 1);
}

/**
 * The end of a transfer.
 * @param {Uint8Array} data that came from the device
 * @param {number} count how many bytes went either way
 */
export function ended(sequence, status, count, data) {
    const message = Buffer.alloc(transferBytes);
    message.writeUInt32BE(submitted, 0);
    message.writeUInt32BE(sequence, 4);
    message.writeInt32BE(status, 20);
    message.writeUInt32BE(count, 24);
    return Buffer.concat([message, data]);
}

/** The answer to unlink: whether the transfer was still waiting, and is not any more. */
export function taken(sequence, wasWaiting) {
    const message = Buffer.alloc(transferBytes);
    message.writeUInt32BE(unlinked, 0);
    message.writeUInt32BE(sequence, 4);
    message.writeInt32BE(wasWaiting ? Status.cancelled : 0, 20);
    return message;
}

function reply(code, status) {
    const message = Buffer.alloc(requestBytes);
    message.writeUInt16BE(version, 0);
    message.writeUInt16BE(code, 2);
    message.writeUInt32BE(status, 4);
    return message;
}

function device(busId, { vendor, product, release, kind, configurations, interfaces }) {
    const message = Buffer.alloc(312);
    message.write(`/emulated/${busId}`, 0, 255, 'latin1');
    message.write(busId, 256, busIdBytes - 1, 'latin1');
    [1, deviceNumber, fullSpeed].forEach((word, i) => message.writeUInt32BE(word, 288 + 4 * i));
    [vendor, product, release].forEach((word, i) => message.writeUInt16BE(word, 300 + 2 * i));
    message.set([...kind, 0, configurations, interfaces.length], 306);
    return message;
}
