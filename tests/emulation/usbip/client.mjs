import net from 'node:net';
import { once } from 'node:events';

const version = 0x01118000;
const transferBytes = 48;

/** A client for tests: whatever it asks is a promise of the server's answer. */
export class Client {
    #bytes = Buffer.alloc(0);
    #wanted = [];
    #sequence = 0;

    static async connect(port) {
        const client = new Client(net.connect(port, '127.0.0.1'));
        await once(client.socket, 'connect');
        return client;
    }

    constructor(socket) {
        this.socket = socket;
        this.ended = new Promise((resolve) => socket.on('close', resolve));
        socket.on('data', (piece) => this.#take(piece)).on('error', () => {});
    }

    async list() {
        this.#request(5);
        const count = (await this.#receive(12)).readUInt32BE(8);
        return count === 0 ? undefined : this.#receive(312 + 4);
    }

    /** @returns {Promise<boolean>} whether it was granted */
    async import(busId) {
        this.#request(3, Buffer.from(busId.padEnd(32, '\0')));
        const granted = (await this.#receive(8)).readUInt32BE(4) === 0;
        if (granted)
            await this.#receive(312);
        return granted;
    }

    /** @returns the number by which answers and unlink() know the transfer */
    submit(endpoint, { isIn = false, length = 0, setup = new Uint8Array(8), data = new Uint8Array(0) }) {
        const message = this.#transfer([1, ++this.#sequence, 0x10002, Number(isIn), endpoint, 0, length || data.length]);
        message.set(setup, 40);
        this.socket.write(Buffer.concat([message, data]));
        return this.#sequence;
    }

    unlink(target) {
        this.socket.write(this.#transfer([2, ++this.#sequence, 0x10002, 0, 0, target]));
    }

    /** The next answer; data follow the end of a transfer from the device alone, which is when `isIn`. */
    async answer(isIn = false) {
        const [kind, sequence, , , , status, count] = words(await this.#receive(transferBytes));
        const data = isIn && kind === 3 && count > 0 ? await this.#receive(count) : Buffer.alloc(0);
        return { kind, sequence, status, count, data: Uint8Array.from(data) };
    }

    /** A whole control transfer. */
    control(setup, data = new Uint8Array(0)) {
        const isIn = (setup[0] & 0x80) !== 0;
        this.submit(0, { isIn, length: setup[6] | (setup[7] << 8), setup, data });
        return this.answer(isIn);
    }

    close() {
        this.socket.destroy();
    }

    #request(code, more = Buffer.alloc(0)) {
        const request = Buffer.alloc(8);
        request.writeUInt32BE(version + code);
        this.socket.write(Buffer.concat([request, more]));
    }

    #transfer(numbers) {
        const message = Buffer.alloc(transferBytes);
        numbers.forEach((number, i) => message.writeUInt32BE(number, 4 * i));
        return message;
    }

    #receive(count) {
        return new Promise((resolve) => {
            this.#wanted.push({ count, resolve });
            this.#take(Buffer.alloc(0));
        });
    }

    #take(piece) {
        this.#bytes = Buffer.concat([this.#bytes, piece]);
        while (this.#wanted.length > 0 && this.#bytes.length >= this.#wanted[0].count) {
            const { count, resolve } = this.#wanted.shift();
            resolve(this.#bytes.subarray(0, count));
            this.#bytes = this.#bytes.subarray(count);
        }
    }
}

function words(message) {
    return Array.from({ length: 7 }, (_, i) => message.readInt32BE(4 * i));
}
