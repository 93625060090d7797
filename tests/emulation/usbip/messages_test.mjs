import assert from 'node:assert/strict';
import test from 'node:test';

import { Inbox, Status, WrongMessage, ended, imported, listed, refused, taken } from './messages.mjs';

const identity = { vendor: 0x1209, product: 0x0001, release: 0x0100, kind: Uint8Array.of(0, 0, 0), configurations: 1,
    interfaces: [Uint8Array.of(3, 0, 0)] };
const list = Buffer.from('0111800500000000', 'hex');
const wanted = Buffer.concat([Buffer.from('0111800300000000', 'hex'), Buffer.from('1-1'.padEnd(32, '\0'))]);

function transfer(kind, { sequence = 7, isIn = 0, endpoint = 1, word = 0, length = 0, setup = '00'.repeat(8) }) {
    const words = [kind, sequence, 0x10002, isIn, endpoint, word, length, 0, 0, 1];
    const bytes = Buffer.alloc(40);
    words.forEach((value, i) => bytes.writeUInt32BE(value >>> 0, 4 * i));
    return Buffer.concat([bytes, Buffer.from(setup, 'hex')]);
}

function inboxWithDevice() {
    const inbox = new Inbox();
    inbox.hasDevice = true;
    return inbox;
}

test('requests arrive in any pieces', () => {
    const inbox = new Inbox();
    const bytes = Buffer.concat([list, wanted]);
    const found = [...bytes].flatMap((byte) => [...inbox.messages(Buffer.of(byte))]);
    assert.deepEqual(found, [{ kind: 'list' }, { kind: 'import', busId: '1-1' }]);
});

test('transfers follow an import, in the same piece as well', () => {
    const inbox = new Inbox();
    const kinds = [];
    for (const { kind } of inbox.messages(Buffer.concat([wanted, transfer(2, { word: 5 })]))) {
        kinds.push(kind);
        inbox.hasDevice = true;
    }
    assert.deepEqual(kinds, ['import', 'unlink']);
});

test('data follow a transfer to the device alone', () => {
    const inbox = inboxWithDevice();
    const out = Buffer.concat([transfer(1, { length: 2, setup: '2109000200000200' }), Buffer.of(8, 9)]);
    const found = [out, transfer(1, { isIn: 1, length: 64 })].flatMap((piece) => [...inbox.messages(piece)]);
    assert.deepEqual(found.map(({ endpoint, length, data }) => [endpoint, length, data]), [
        [{ number: 1, isIn: false }, 2, Uint8Array.of(8, 9)], [{ number: 1, isIn: true }, 64, Uint8Array.of()]]);
    assert.deepEqual(found[0].setup, Uint8Array.of(0x21, 9, 0, 2, 0, 0, 2, 0));
    assert.equal([...inbox.messages(transfer(1, { length: 1 }))].length, 0);
});

test('what is no message is refused', () => {
    const refuses = (inbox, bytes) => assert.throws(() => [...inbox.messages(bytes)], WrongMessage);
    refuses(new Inbox(), Buffer.alloc(8));
    refuses(inboxWithDevice(), transfer(3, {}));
    refuses(inboxWithDevice(), transfer(1, { length: -1 }));
});

test('answers have the sizes and places that clients expect', () => {
    assert.equal(listed('1-1', undefined).toString('hex'), '011100050000000000000000');
    const one = listed('1-1', identity);
    assert.equal(one.length, 8 + 4 + 312 + 4);
    assert.deepEqual([one.readUInt32BE(8), ...one.subarray(-4)], [1, 3, 0, 0, 0]);
    const granted = imported('1-1', identity);
    assert.equal(granted.length, 8 + 312);
    assert.equal(granted.toString('latin1', 8 + 256, 8 + 259), '1-1');
    assert.deepEqual([296, 300, 302].map((at) => granted.readUInt16BE(8 + at)), [0, 0x1209, 0x0001]);
    assert.deepEqual([...granted.subarray(-6)], [0, 0, 0, 0, 1, 1]);
    assert.equal(refused().readUInt32BE(4), 1);
    const end = ended(7, Status.done, 2, Uint8Array.of(1, 2));
    assert.deepEqual([0, 4, 20, 24].map((at) => end.readInt32BE(at)), [3, 7, 0, 2]);
    assert.equal(end.length, 50);
    assert.deepEqual([true, false].map((was) => taken(8, was).readInt32BE(20)), [Status.cancelled, 0]);
});
