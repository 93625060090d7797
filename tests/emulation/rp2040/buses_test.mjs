import assert from 'node:assert/strict';
import test from 'node:test';

import { Board } from './board.mjs';
import { BusTime } from './bus_time.mjs';
import { Display } from './display.mjs';
import { busFor } from './display_buses.mjs';
import { HeldData } from './held_data.mjs';
import { LogLine } from './log_line.mjs';
import { Inputs } from './pins.mjs';
import { makeImage, sleep, startClocks, store, wait } from './test_image.mjs';
import { Kind } from './trace.mjs';

const io = 0x40014000;
const sio = 0xd0000000;
const spi0 = 0x4003c000;
const i2c0 = 0x40044000;
const pio0 = 0x50200000;
const dma = 0x50000000;
const uart0 = 0x40034000;

const pins = { clock: 18, data: 19, select: 17, dc: 16, reset: 20, backlight: 255, tearing: 255, log: 0 };
const connect = (pin, pinFunction) => store(io + 8 * pin + 4, pinFunction);
const level = (pin, high) => store(sio + (high ? 0x14 : 0x18), 2 ** pin);
const outputs = [16, 17, 20].flatMap((pin) => [level(pin, true), connect(pin, 5), store(sio + 0x24, 2 ** pin)]);

/** Keeps what a Trace would write. */
class Received {
    all = [];

    bytes(kind, begin, end, bytes) {
        this.all.push(...bytes.map((byte) => [kind, byte]));
        this.times = [...(this.times ?? []), begin, end];
    }

    line(kind) {
        this.all.push([kind]);
    }

    note() {
        return (text) => this.all.push([Kind.note, text]);
    }
}

function run(settings, calls, nanos = 2e6) {
    const board = new Board(makeImage([...startClocks, ...calls, sleep()]));
    const received = new Received();
    const busTime = new BusTime();
    const inputs = board.add(new Inputs());
    const display = board.add(new Display({ address: 0x3c, pins, ...settings }, received, busTime));
    const bus = board.add(busFor(display));
    if (settings.heldFor) {
        const held = board.add(new HeldData(inputs, settings.pins, settings.heldFor));
        bus.isFree = () => held.isFree;
    }
    board.add(new LogLine(display.settings, received));
    board.run(nanos);
    return { board, bus, received };
}

const bytesOf = ({ received }) => received.all.filter(([kind]) => kind <= Kind.data).map(([, byte]) => byte);

function spiSetUp({ phase = 0x80, bits = 8, dmaControl = 2, enable = 2, clockPin = 18, divider = 2 } = {}) {
    return [...outputs, connect(clockPin, 1), connect(19, 1), store(spi0 + 0x10, divider),
        store(spi0, phase | (bits - 1)), store(spi0 + 0x24, dmaControl), store(spi0 + 4, enable)];
}

/** 480 bytes of RAM, in pieces of 8 or 16 bits. */
const byDma = (to, request, size = 0, bytes = 480) => [store(dma, 0x20000000), store(dma + 4, to),
    store(dma + 8, bytes >> size), store(dma + 12, 1 | (size << 2) | (1 << 4) | (request << 15))];

const spi = { bus: 'spi' };

test('SPI: bytes arrive with D/C as it is, words high byte first', () => {
    const seen = run(spi, [...spiSetUp(), level(17, false), level(16, false), store(spi0 + 8, 0x2a), wait(20),
        level(16, true), store(spi0 + 8, 0x55), wait(20), store(spi0, 0x8f), store(spi0 + 8, 0x1234)]);
    assert.deepEqual(seen.received.all, [[Kind.selected], [Kind.command, 0x2a], [Kind.data, 0x55], [Kind.data, 0x12],
        [Kind.data, 0x34]]);
});

test('SPI: frames take their bits, and a gap where the unit makes one', () => {
    const seconds = (phase, bits) => {
        const { received: { times } } = run(spi, [...spiSetUp({ phase, bits }), level(17, false),
            ...byDma(spi0 + 8, 16, bits === 16 ? 1 : 0)]);
        return times.at(-1) - times[0];
    };
    assert.ok(Math.abs(seconds(0x80, 16) - 480 * 8 * 16) < 1);
    assert.ok(Math.abs(seconds(0x80, 8) - 480 * 8 * 16) < 1);
    assert.ok(Math.abs(seconds(0, 16) - (240 * 18 - 2) * 16) < 1);
    assert.ok(Math.abs(seconds(0, 8) - (480 * 10 - 2) * 16) < 1);
});

test('SPI: nothing is sent while the unit is off, or does not ask for DMA', () => {
    const sent = (options) =>
        bytesOf(run(spi, [...spiSetUp(options), level(17, false), ...byDma(spi0 + 8, 16)])).length;
    assert.equal(sent({}), 480);
    assert.equal(sent({ enable: 0 }), 0);
    assert.equal(sent({ dmaControl: 0 }), 0);
});

test('SPI: what a display would not understand ends the run', () => {
    const refused = (calls, message) => assert.throws(() => run(spi, calls), message);
    const select = level(17, false);
    const send = store(spi0 + 8, 1);
    refused([...spiSetUp(), send], /not selected/);
    refused([...spiSetUp({ divider: 8 }), select, send, level(16, false)], /D\/C changes within a byte/);
    refused([...spiSetUp({ divider: 8 }), select, send, level(17, true)], /released within a byte/);
    refused([...spiSetUp({ clockPin: 22 }), select, send], /its pins are not connected/);
    refused([...spiSetUp({ enable: 6 }), select, send], /as a slave/);
    refused([...spiSetUp({ bits: 9 }), select, send], /words of 9 bits/);
    refused([...spiSetUp(), connect(16, 31), select, send], /D\/C is not driven/);
    refused([...spiSetUp(), store(0x40008048, 0), select, send], /without a clock/);
});

const parallel = { bus: 'parallel', pins: { ...pins, clock: 14, data: 6 } };
const shiftOut = [0x6008, 0xb042]; // OUT PINS, 8 side 0; NOP side 1

function pioSetUp(divider, program = shiftOut) {
    const directions = Array.from({ length: 9 }, (_, i) => [connect(6 + i, 6),
        store(pio0 + 0xdc, (1 << 26) | ((6 + i) << 5)), store(pio0 + 0xd8, 0xe081)]).flat();
    return [...outputs, ...directions, ...program.map((word, i) => store(pio0 + 0x48 + 4 * i, word)),
        store(pio0 + 0xcc, (program.length - 1) << 12), store(pio0 + 0xd0, (1 << 17) | (8 << 25)),
        store(pio0 + 0xdc, ((1 << 29) | (14 << 10) | (8 << 20) | 6) >>> 0), store(pio0 + 0xd8, 0xb042),
        store(pio0 + 0xc8, divider * 65536), store(pio0, 1), level(17, false)];
}

test('parallel: bytes are taken when WR rises', () => {
    const seen = run(parallel, [...pioSetUp(4), store(pio0 + 0x10, 0xa5000000), store(pio0 + 0x10, 0x5a000000)]);
    assert.deepEqual(bytesOf(seen), [0xa5, 0x5a]);
});

test('parallel: a write takes its instructions, their delays and the divider, whose parts jitter', () => {
    const shortest = (...setUp) => run(parallel, [...pioSetUp(...setUp), ...byDma(pio0 + 0x10, 0, 0, 64)]).bus.shortest;
    const cycle = (...setUp) => Math.round(shortest(...setUp).cycle);
    assert.equal(cycle(4), 64);
    assert.equal(cycle(5), 80);
    assert.equal(cycle(4.125), 64);
    assert.equal(cycle(4.5), 72);
    assert.equal(cycle(1, [0x6008 | (3 << 8), 0xb042 | (4 << 8)]), 72);
    assert.equal(Math.round(shortest(1, [0x6008 | (3 << 8), 0xb042 | (4 << 8)]).low), 32);
});

const i2c = { bus: 'i2c', pins: { ...pins, clock: 5, data: 4, select: 255, dc: 255, reset: 255 } };

function i2cSetUp(address = 0x3c) {
    return [connect(4, 3), connect(5, 3), store(i2c0 + 0x6c, 0), store(i2c0, 0x65), store(i2c0 + 4, address),
        store(i2c0 + 0x1c, 119), store(i2c0 + 0x20, 178), store(i2c0 + 0xa0, 7), store(i2c0 + 0x7c, 38),
        store(i2c0 + 0x6c, 1)];
}

test('I2C: control bytes tell commands from data, and bits take their time', () => {
    const words = [0x00, 0xae, 0x2af].map((word) => store(i2c0 + 0x10, word));
    const more = [wait(40000), store(i2c0 + 0x10, 0x40), store(i2c0 + 0x10, 0x27f)];
    const { received } = run(i2c, [...i2cSetUp(), ...words, ...more], 4e6);
    assert.deepEqual(received.all, [[Kind.selected], [Kind.command, 0xae], [Kind.command, 0xaf], [Kind.released],
        [Kind.selected], [Kind.data, 0x7f], [Kind.released]]);
    assert.equal(Math.round(received.times[1] - received.times[0]), 9 * 312 * 8);
});

test('I2C: another address is nobody\'s', () => {
    assert.throws(() => run(i2c, [...i2cSetUp(0x3d), store(i2c0 + 0x10, 0)]), /0x3d, which nobody has/);
});

test('I2C: nothing can be sent while the display is in the middle of a byte', () => {
    const pulses = (count) => Array.from({ length: count }, () => [store(sio + 0x24, 1 << 5), wait(200),
        store(sio + 0x28, 1 << 5), wait(200)]).flat();
    const stop = [store(sio + 0x24, 1 << 5), store(sio + 0x24, 1 << 4), wait(200), store(sio + 0x28, 1 << 5), wait(200),
        store(sio + 0x28, 1 << 4)];
    const send = (...before) => run({ ...i2c, heldFor: 2 }, [connect(4, 5), connect(5, 5), ...before.flat(),
        ...i2cSetUp(), store(i2c0 + 0x10, 0x200)]).received.all;
    assert.deepEqual(send(pulses(2), stop), [[Kind.selected], [Kind.released]]);
    assert.throws(() => send(pulses(2)), /in the middle of a byte/);
    assert.throws(() => send(stop), /in the middle of a byte/);
    assert.throws(() => send(pulses(1).slice(0, 1), pulses(1).slice(2)), /SCL changes after/);
    assert.throws(() => send([store(sio + 0x14, 1 << 5)], pulses(1)), /driven high/);
});

test('I2C: the interrupt for more stays while bytes are few', () => {
    const { board } = run(i2c, [...i2cSetUp(), store(i2c0 + 0x3c, 2), store(i2c0 + 0x30, 1 << 4)]);
    assert.ok(board.mcu.core.pendingInterrupts & (1 << 23));
});

const uartSetUp = [connect(0, 2), store(uart0 + 0x24, 67), store(uart0 + 0x28, 52), store(uart0 + 0x2c, 0x70),
    store(uart0 + 0x30, 0x101)];
const write = (text) => [...text].map((letter) => store(uart0, letter.charCodeAt(0)));

test('the log: lines count for their first letter, and letters take their time', () => {
    const { board, received } = run(spi, [...uartSetUp, ...write('F 0\n')]);
    assert.deepEqual(received.all, [[Kind.note, 'F 0']]);
    const busy = (nanos) => run(spi, [...uartSetUp, ...write('F 0\n')], nanos).board.mcu.uart[0].readUint32(0x18) & 8;
    assert.ok(busy(0.6e6) && !busy(1.2e6), `${board.nanos}`);
    assert.throws(() => run(spi, [...uartSetUp, ...write('x'.repeat(34))]), /no room/);
    assert.throws(() => run(spi, [...uartSetUp.slice(1), ...write('x')]), /not to the log's pin/);
});
