import assert from 'node:assert/strict';
import test from 'node:test';

import { Board } from './board.mjs';
import { EmulationError } from './emulation_error.mjs';
import { makeImage, sleep, startClocks, store } from './test_image.mjs';
import { UsbHost, request, textOf } from './usb_host.mjs';

const unit = 0x50110000;
const memory = 0x50100000;
const startUsbClock = [[0x4002c000, 1], [0x4002c008, 100], [0x4002f004, 0x21], [0x4002c00c, 0x55000], [0x4002f004, 8],
    [0x40008054, 1 << 11]].map(([address, value]) => store(address, value)); // PLL_USB, CLK_USB
const attach = {
    muxing: store(unit + 0x74, 9), power: store(unit + 0x78, 0xc), main: store(unit + 0x40, 1),
    line: store(unit + 0x4c, (1 << 29) | (1 << 16)),
};

const AVAILABLE_0 = 1 << 10;
const STALL = 1 << 11;
const PID_0 = 1 << 13;
const FULL_0 = 1 << 15;
const enabled = 0x80000000 | (1 << 29) | (3 << 26);
const wait = Array.from({ length: 3 }, () => store(0x20001000, 0)); // each is more than four cycles
const control = (index, word) => store(memory + 0x80 + 4 * index, word);
const handOver = (index, word) => [control(index, word), ...wait, control(index, word | AVAILABLE_0)];
const endpoint = (index, word) => store(memory + 4 * index, word);

/** A host whose board has made `calls` after it plugged itself in. */
function plugged(calls = [], steps = attach, clock = startUsbClock) {
    const board = new Board(makeImage([...startClocks, ...clock, ...Object.values(steps), ...calls, sleep()]));
    const host = new UsbHost(board);
    host.run(3e6);
    return host;
}

const finished = (host) => host.board.mcu.readUint32(unit + 0x58);
const refuses = (work, message) => assert.throws(work, (problem) =>
    problem instanceof EmulationError && message.test(problem.message));

test('nothing is plugged in before clock, pins, power and pull-up are right', () => {
    assert.ok(plugged().unit.attached);
    assert.ok(!plugged([], attach, []).unit.attached);
    assert.ok(!plugged([], attach, startUsbClock.slice(0, -1)).unit.attached);
    for (const step of Object.keys(attach)) {
        const others = Object.fromEntries(Object.entries(attach).filter(([name]) => name !== step));
        assert.ok(!plugged([], others).unit.attached, step);
    }
    refuses(() => plugged([], attach, []).awaitDevice(5e6), /no USB device/);
});

test('a packet stays until the host asks, and is told then', () => {
    const host = plugged([store(memory + 0x180, 0x04030201), ...handOver(2, FULL_0 | 3), endpoint(2, enabled | 0x180)]);
    assert.equal(finished(host), 0);
    host.run(1e6);
    assert.equal(finished(host), 0);
    assert.deepEqual(host.askOnce(1), Uint8Array.of(1, 2, 3));
    assert.equal(finished(host), 1 << 2);
    assert.equal(host.askOnce(1), 'nak');
    assert.equal(host.naks, 1);
});

test('a packet to the device needs room, and lies where it was to lie', () => {
    const host = plugged([...handOver(3, 64), endpoint(3, enabled | 0x1c0)]);
    assert.equal(host.sendOnce(1, Uint8Array.of(9, 8, 7, 6)), 'ack');
    assert.equal(host.board.mcu.readUint32(memory + 0x1c0), 0x06070809);
    assert.equal(host.board.mcu.readUint32(memory + 0x8c), FULL_0 | 4);
    assert.equal(finished(host), 1 << 3);
    assert.equal(host.sendOnce(1, Uint8Array.of(1)), 'nak');
    refuses(() => host.send(1, Uint8Array.of(1), 1e6), /NAK for 1 ms/);
});

test('packets take their time', () => {
    const host = plugged([...handOver(3, 64), endpoint(3, enabled | 0x1c0)]);
    const before = host.board.nanos;
    host.sendOnce(1, new Uint8Array(64));
    assert.ok(Math.abs(host.board.nanos - before - 77 * 8 * 1000 / 12) < 1000);
});

test('DATA0 and DATA1 take turns', () => {
    const twice = (first, second) => () => {
        const host = plugged([...handOver(3, 64 | first), endpoint(3, enabled | 0x1c0)]);
        host.sendOnce(1, new Uint8Array(1));
        host.unit.DPRAMUpdated(0x8c, 64 | second);
        host.run(1000);
        host.unit.DPRAMUpdated(0x8c, 64 | second | AVAILABLE_0);
        return host.sendOnce(1, new Uint8Array(1));
    };
    assert.equal(twice(0, PID_0)(), 'ack');
    refuses(twice(0, 0), /DATA1 comes to endpoint 1 OUT, which waits for the other one/);
    refuses(twice(PID_0, 0), /DATA0 comes/);
    const host = plugged([...handOver(2, FULL_0 | PID_0), endpoint(2, enabled | 0x180)]);
    refuses(() => host.askOnce(1), /endpoint 1 sends DATA1/);
});

test('an endpoint that is not enabled does not answer', () => {
    const host = plugged([...handOver(2, FULL_0), ...handOver(3, 64)]);
    assert.equal(host.askOnce(1), 'timeout');
    assert.equal(host.sendOnce(1, new Uint8Array(1)), 'timeout');
    refuses(() => host.ask(1), /does not answer/);
});

test('what is not told to the program is not told', () => {
    const silent = 0x80000000 | (3 << 26);
    const host = plugged([...handOver(2, FULL_0), endpoint(2, silent | 0x180), ...handOver(0, FULL_0)],
        { ...attach, line: store(unit + 0x4c, 1 << 16) });
    assert.deepEqual(host.askOnce(1), new Uint8Array(0));
    assert.deepEqual(host.askOnce(0), new Uint8Array(0));
    assert.equal(finished(host), 0);
});

test('a control endpoint stalls when it is armed for that, until a setup', () => {
    assert.equal(plugged([control(0, STALL)]).askOnce(0), 'nak');
    const host = plugged([control(0, STALL), store(unit + 0x68, 1)]);
    assert.equal(host.askOnce(0), 'stall');
    host.setup(request(0x80, 6, 0x100, 0, 18));
    assert.equal(host.askOnce(0), 'nak');
    assert.equal(plugged([control(3, STALL), endpoint(3, enabled | 0x1c0)]).sendOnce(1, new Uint8Array(1)), 'stall');
});

test('another address is not heard', () => {
    const host = plugged([...handOver(0, FULL_0), store(unit, 7)]);
    assert.equal(host.askOnce(0), 'timeout');
    refuses(() => host.setup(request(0x80, 6)), /no device has the address 0/);
});

test('what the bus does is told, until it is cleared', () => {
    const host = plugged([store(unit + 0x90, 0x1d010)]);
    const raised = () => host.board.mcu.readUint32(unit + 0x98);
    for (const [work, status, bit] of [[() => host.suspend(), 4, 14], [() => host.resume(), 11, 15],
        [() => host.reset(), 19, 12], [() => host.setup(request(0, 9, 1)), 17, 16]]) {
        work();
        assert.equal(raised(), 1 << bit);
        host.board.mcu.writeUint32(unit + 0x3000 + 0x50, 1 << status);
        assert.equal(raised(), 0);
    }
    assert.equal(host.board.mcu.readUint32(memory), 0x00010900);
});

test('what would not work on a chip ends the run', () => {
    refuses(() => plugged([control(2, FULL_0 | AVAILABLE_0)]), /in the same write/);
    refuses(() => plugged([...handOver(2, FULL_0), store(memory + 8, enabled | 0x180), store(memory + 0x180, 1)]),
        /is written while the unit has it/);
    refuses(() => plugged([control(2, 65)]), /a packet of 65 bytes/);
    refuses(() => plugged([control(2, 1 << 16)]), /not modelled/);
    refuses(() => plugged([...handOver(2, FULL_0), endpoint(2, enabled | 0x120)]).askOnce(1), /is set up as/);
    refuses(() => plugged([...handOver(2, 0), endpoint(2, enabled | 0x180)]).askOnce(1), /given away empty/);
    refuses(() => plugged([...handOver(3, 4), endpoint(3, enabled | 0x1c0)]).sendOnce(1, new Uint8Array(5)),
        /has room for 4/);
    refuses(() => plugged([store(unit + 0x44, 1)]), /Unimplemented peripheral write/);
});

test('a packet is available some time after what is said about it', () => {
    const host = plugged();
    const after = (nanos) => {
        host.unit.DPRAMUpdated(0x88, FULL_0);
        host.run(nanos);
        host.unit.DPRAMUpdated(0x88, FULL_0 | AVAILABLE_0);
    };
    refuses(() => after(0), /available 0 ns after/);
    refuses(() => after(95), /available 95 ns after/);
    after(96);
});

test('a packet is not changed while it is on the line', () => {
    const host = plugged([...handOver(3, 64), endpoint(3, enabled | 0x1c0)]);
    host.unit.token({ number: 1, isIn: false });
    refuses(() => host.unit.DPRAMUpdated(0x8c, 0), /while it is on the line/);
});

test('a control transfer that has no data ends with an empty packet, and starts toggles anew', () => {
    const host = plugged([...handOver(0, FULL_0 | PID_0)]);
    assert.deepEqual(host.control(request(0x00, 9, 1)), new Uint8Array(0));
    refuses(() => host.control(request(0x00, 9, 1)), /NAK for 50 ms/);
    refuses(() => plugged([...handOver(0, FULL_0 | PID_0 | 1)]).control(request(0x00, 9, 1)), /not empty/);
});

test('requests and texts are as on the wire', () => {
    assert.deepEqual(request(0x81, 6, 0x2200, 0x0102, 0x0304), Uint8Array.of(0x81, 6, 0, 0x22, 2, 1, 4, 3));
    assert.equal(textOf(Uint8Array.of(8, 3, 0x4b, 0, 0x46, 0, 0xe9, 0)), 'KFé');
});
