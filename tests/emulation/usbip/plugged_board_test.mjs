import assert from 'node:assert/strict';
import test from 'node:test';

import { PluggedBoard } from './plugged_board.mjs';

const [done, stalled, noAnswer, tooLong] = [0, -32, -71, -75];
const packet = (length, seed = 0) => Uint8Array.from({ length }, (_, i) => seed + i);

const deviceDescriptor = Uint8Array.of(18, 1, 0, 2, 9, 8, 7, 64, 0x09, 0x12, 0x01, 0x00, 0x34, 0x12, 1, 2, 3, 1);
const configuration = Uint8Array.of(9, 2, 41, 0, 1, 1, 0, 0x80, 50, 9, 4, 0, 0, 2, 3, 5, 6, 0, 7, 5, 0x81, 3, 64, 0, 1);

/** Says what it is told to say, and keeps what it was told. */
class FakeHost {
    attached = false;
    turnsPerFrame = 1;
    frames = 0;
    resets = 0;
    toGive = [];
    takes = [];
    sent = [];
    #kinds = [deviceDescriptor, configuration];

    nextFrame() { ++this.frames; }
    reset() { ++this.resets; }
    setAddress() {}
    control([type, number, , kind]) {
        return type === 0x80 && number === 6 ? this.#kinds[kind - 1] ?? 'stall' : new Uint8Array(0);
    }
    askOnce() { return this.toGive.shift() ?? 'nak'; }
    sendOnce(_, bytes) {
        const answer = this.takes.shift() ?? 'ack';
        if (answer === 'ack')
            this.sent.push([...bytes]);
        return answer;
    }
}

function plugged() {
    const host = new FakeHost();
    const board = new PluggedBoard(host);
    host.attached = true;
    board.frame();
    return { host, board };
}

/** Submits a transfer; its `ending` is set when it ends. */
function submitted(board, { number = 1, isIn = false, user = 'a', length = 64, setup = new Uint8Array(8), data }) {
    const transfer = { user, endpoint: { number, isIn }, setup, length, data: data ?? new Uint8Array(0) };
    transfer.finish = (status, count, answer) => (transfer.ending = [status, count, answer && [...answer]]);
    board.submit(transfer);
    return transfer;
}

function frames(board, count) {
    for (let i = 0; i < count; ++i)
        board.frame();
}

test('a board is known when it has plugged itself in, and not before', () => {
    const board = new PluggedBoard(new FakeHost());
    frames(board, 3);
    assert.equal(board.identity, undefined);
    board.host.attached = true;
    board.frame();
    assert.deepEqual(board.identity, { vendor: 0x1209, product: 1, release: 0x1234, kind: Uint8Array.of(9, 8, 7),
        configurations: 1, interfaces: [Uint8Array.of(3, 5, 6)] });
    assert.equal(board.host.resets, 1);
});

test('a board that leaves by itself is told once, with all that waits for it, and may come back', () => {
    const { host, board } = plugged();
    let left = 0;
    board.onGone = () => ++left;
    const transfer = submitted(board, { isIn: true });
    host.attached = false;
    frames(board, 2);
    assert.deepEqual([left, board.identity, transfer.ending], [1, undefined, undefined]);
    host.attached = true;
    host.toGive = [packet(64)];
    frames(board, 2);
    assert.ok(board.identity);
    assert.deepEqual([host.toGive.length, transfer.ending], [1, undefined]);
});

test('what is longer than a packet goes in packets, one in a frame', () => {
    const { host, board } = plugged();
    const transfer = submitted(board, { data: packet(100) });
    host.takes = ['nak', 'ack', 'ack'];
    frames(board, 2);
    assert.equal(transfer.ending, undefined);
    board.frame();
    assert.deepEqual(transfer.ending, [done, 100, undefined]);
    assert.equal(board.taken, 2);
    assert.deepEqual(host.sent.map((bytes) => bytes.length), [64, 36]);
    assert.deepEqual(host.sent.flat(), [...packet(100)]);
});

test('an empty packet is sent as one', () => {
    const { host, board } = plugged();
    const transfer = submitted(board, { data: packet(0), length: 0 });
    board.frame();
    assert.deepEqual([transfer.ending, host.sent], [[done, 0, undefined], [[]]]);
});

test('packets are put together until one is short, or there is enough', () => {
    const { host, board } = plugged();
    host.toGive = [packet(64), packet(3, 64), packet(64), packet(64, 64)];
    const short = submitted(board, { isIn: true, length: 255 });
    const full = submitted(board, { isIn: true, length: 128 });
    frames(board, 4);
    assert.deepEqual([short.ending, full.ending], [[done, 67, [...packet(67)]], [done, 128, [...packet(128)]]]);
});

test('failures have the numbers that Linux gives them', () => {
    const { host, board } = plugged();
    const failing = (answer, options) => {
        const transfer = submitted(board, options);
        host.takes = host.toGive = [answer];
        board.frame();
        return transfer.ending[0];
    };
    assert.equal(failing('stall', { isIn: true }), stalled);
    assert.equal(failing('timeout', { isIn: true }), noAnswer);
    assert.equal(failing('stall', { data: packet(1) }), stalled);
    assert.equal(failing('timeout', { data: packet(1) }), noAnswer);
    assert.equal(failing(packet(64), { isIn: true, length: 8 }), tooLong);
    assert.equal(failing('', { number: 0, isIn: true, setup: Uint8Array.of(0x80, 6, 0, 9, 0, 0, 8, 0) }), stalled);
});

test('nobody is asked for what nobody waits for, and what was cancelled is forgotten', () => {
    const { host, board } = plugged();
    host.toGive = [packet(64)];
    board.cancel(submitted(board, { isIn: true }));
    frames(board, 3);
    assert.equal(host.toGive.length, 1);
});

test('every user gets what comes, each once', () => {
    const { host, board } = plugged();
    host.toGive = [packet(64)];
    const [first, second, later] = ['a', 'b', 'a'].map((user) => submitted(board, { isIn: true, user }));
    board.frame();
    assert.deepEqual([first, second, later].map(({ ending }) => ending?.[0]), [done, done, undefined]);
});
