import net from 'node:net';

import { Inbox, Status, WrongMessage, ended, imported, listed, refused, taken } from './messages.mjs';

export const busId = '1-1';

/**
 * Shares a device over USB/IP with programs on this computer, and with guests that run on it. Several may have it at
 * once, as programs share what a kernel has.
 *
 * A device has an `identity` while it is plugged in, and takes transfers: submit(transfer), cancel(transfer). A transfer
 * is {user, endpoint, setup, length, data, finish(status, count, data)}.
 */
export class UsbIpServer {
    #connections = new Set();

    constructor(device) {
        this.device = device;
        this.listener = net.createServer((socket) => this.#accept(socket));
    }

    /** @returns {Promise<number>} the port: `port`, or any free one for 0 */
    listen(port) {
        return new Promise((resolve, reject) => {
            this.listener.once('error', reject);
            this.listener.listen(port, '127.0.0.1', () => resolve(this.listener.address().port));
        });
    }

    /** The device is gone: who has it sees its connection end. */
    unplug() {
        for (const connection of this.#connections)
            if (connection.hasDevice)
                connection.end();
    }

    close() {
        this.listener.close();
        this.#connections.forEach((connection) => connection.end());
    }

    #accept(socket) {
        const connection = new Connection(socket, this.device);
        this.#connections.add(connection);
        socket.on('close', () => this.#connections.delete(connection));
    }
}

class Connection {
    #inbox = new Inbox();
    #transfers = new Map();

    constructor(socket, device) {
        this.socket = socket.setNoDelay(true);
        this.device = device;
        socket.on('data', (piece) => this.#take(piece));
        socket.on('close', () => this.#cancelAll());
        socket.on('error', () => {}); // "close" follows
    }

    get hasDevice() {
        return this.#inbox.hasDevice;
    }

    end() {
        this.#cancelAll();
        this.socket.destroy();
    }

    #take(piece) {
        try {
            for (const message of this.#inbox.messages(piece))
                this.#obey(message);
        } catch (problem) {
            if (!(problem instanceof WrongMessage))
                throw problem;
            this.end();
        }
    }

    #obey(message) {
        switch (message.kind) {
        case 'list':
            return this.socket.write(listed(busId, this.device.identity));
        case 'import':
            return this.#import(message.busId);
        case 'submit':
            return this.#submit(message);
        default:
            return this.socket.write(taken(message.sequence, this.#cancel(message.target)));
        }
    }

    #import(wanted) {
        const { identity } = this.device;
        if (wanted !== busId || !identity)
            return this.socket.end(refused());
        this.#inbox.hasDevice = true;
        return this.socket.write(imported(busId, identity));
    }

    #submit({ sequence, endpoint, setup, length, data }) {
        const finish = (status, count, answer = new Uint8Array(0)) => {
            this.#transfers.delete(sequence);
            this.socket.write(ended(sequence, status, count, status === Status.done ? answer : new Uint8Array(0)));
        };
        const transfer = { user: this, endpoint, setup, length, data, finish };
        this.#transfers.set(sequence, transfer);
        this.device.submit(transfer);
    }

    #cancel(sequence) {
        const transfer = this.#transfers.get(sequence);
        if (transfer) {
            this.#transfers.delete(sequence);
            this.device.cancel(transfer);
        }
        return transfer !== undefined;
    }

    #cancelAll() {
        [...this.#transfers.keys()].forEach((sequence) => this.#cancel(sequence));
    }
}
