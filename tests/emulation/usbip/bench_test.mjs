import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';

import { BootLoaderComputer, into, out } from '../rp2040/boot_loader_computer.mjs';
import { call, makeImage, sleep } from '../rp2040/test_image.mjs';
import { Board } from '../rp2040/board.mjs';
import { Bench } from './bench.mjs';
import { Client } from './client.mjs';

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'kfast'));
test.after(() => fs.rmSync(folder, { recursive: true }));

const flashAddress = 0x10000000;
const sector = 4096;
const bootLoader = [0x2e8a, 0x0003];
const limit = { timeout: 60000 };
const none = { press: [], knob: [], absent: [], patch: [], stuck: [] };

function imageFile(image) {
    const file = path.join(folder, 'image.bin');
    fs.writeFileSync(file, image);
    return file;
}

/** An image that calls the ROM's UB function when it starts, and one that does nothing. */
function images() {
    const board = new Board(makeImage([sleep()]));
    board.run(1e6);
    const view = new DataView(board.mcu.bootrom.buffer);
    for (let entry = view.getUint16(0x14, true); ; entry += 4)
        if (view.getUint8(entry) === 0x55 && view.getUint8(entry + 1) === 0x42) // UB
            return { leaving: makeImage([call(view.getUint16(entry + 2, true), 0, 0)]), still: makeImage([sleep()]) };
}

async function until(bench, condition) {
    for (const end = Date.now() + 30000; !condition();) {
        assert.ok(Date.now() < end, 'it does not happen');
        await bench.turn();
    }
}

const inBootLoader = (bench) => until(bench, () => bench.identity?.vendor === bootLoader[0]);

/** A transfer; what it ends with. */
async function transferred(bench, number, { data = new Uint8Array(0), length = data.length, isIn = false } = {}) {
    let ending;
    const finish = (status, count, answer) => (ending = { status, count, answer });
    bench.submit({ user: 'a', endpoint: { number, isIn }, setup: new Uint8Array(8), length, data, finish });
    await until(bench, () => ending);
    return ending;
}

/** Configures the boot loader, and makes commands for it. */
function computerOf(bench) {
    return new BootLoaderComputer(bench.plugged.host);
}

async function command(bench, packet) {
    assert.equal((await transferred(bench, out, { data: packet })).status, 0);
    return transferred(bench, into, { isIn: true, length: 64 });
}

test('a board with nothing in flash is its boot loader', limit, async () => {
    const bench = new Bench(undefined, none);
    await inBootLoader(bench);
    assert.deepEqual([bench.identity.vendor, bench.identity.product], bootLoader);
    assert.equal(bench.wired, undefined);
    assert.throws(() => bench.record(), /in its boot loader/);
});

test('firmware that wants the boot loader gets it, and what lies in flash then runs', limit, async () => {
    const { leaving, still } = images();
    const bench = new Bench(imageFile(leaving), none);
    assert.equal(bench.identity, undefined);
    await inBootLoader(bench);
    const computer = computerOf(bench);
    computer.begin();
    computer.erase(flashAddress, 2 * sector);
    computer.write(flashAddress, still);
    await command(bench, computer.packet(0x02, [0, 0x20042000, 500]));
    await until(bench, () => bench.wired);
    assert.equal(bench.identity, undefined);
    await until(bench, () => bench.wired.board.nanos > 100e6);
    assert.equal(bench.wired.board.ending, undefined);
});

test('a board whose first sector is gone comes back as its boot loader', limit, async () => {
    const bench = new Bench(imageFile(images().still), none);
    bench.bootsel();
    await inBootLoader(bench);
    const computer = computerOf(bench);
    computer.begin();
    computer.erase(flashAddress, sector);
    bench.plug();
    await inBootLoader(bench);
    assert.equal(bench.memory[0], 0xff);
});

test('with the button held it is in its boot loader, and without it is not', limit, async () => {
    const bench = new Bench(imageFile(images().still), none);
    await until(bench, () => bench.wired.board.nanos > 10e6);
    bench.bootsel();
    await inBootLoader(bench);
    bench.plug();
    await until(bench, () => bench.wired?.board.nanos > 100e6);
    assert.equal(bench.identity, undefined);
});

test('clients lose a device that becomes another one', limit, async () => {
    const bench = new Bench(imageFile(images().still), none);
    const port = await bench.server.listen(0);
    bench.bootsel();
    await inBootLoader(bench);
    const client = await Client.connect(port);
    assert.ok(await client.import('1-1'));
    let hasEnded = false;
    client.ended.then(() => (hasEnded = true));
    await command(bench, computerOf(bench).packet(0x02, [0, 0x20042000, 500]));
    await until(bench, () => hasEnded);
    bench.bootsel();
    await inBootLoader(bench);
    const second = await Client.connect(port);
    assert.ok(await second.import('1-1'));
    bench.plug(); // without an unplug before
    await second.ended;
    bench.server.close();
});

test('it is unplugged after so many packets, across restarts, and what it did breaks off', limit, async () => {
    const bench = new Bench(imageFile(images().leaving), none);
    bench.after(3, () => bench.unplug());
    await inBootLoader(bench);
    const computer = computerOf(bench);
    await command(bench, computer.packet(0x01, [1], { length: 1 }));
    await command(bench, computer.packet(0x06));
    await transferred(bench, out, { data: computer.packet(0x03, [flashAddress, sector]) });
    await until(bench, () => !bench.plugged);
    assert.equal(bench.identity, undefined);
    assert.ok(new Set(bench.memory.subarray(0, sector)).size > 100, 'the sector is spoiled');
    bench.plug();
    await inBootLoader(bench);
});

test('bulk transfers are faster than a packet in a frame', limit, async () => {
    const bench = new Bench(undefined, none);
    await inBootLoader(bench);
    const computer = computerOf(bench);
    computer.begin();
    const begin = bench.plugged.host.nanos;
    await transferred(bench, out, { data: computer.packet(0x84, [flashAddress, sector], { transfer: sector }) });
    const { answer } = await transferred(bench, into, { isIn: true, length: sector });
    assert.equal(answer.length, sector);
    assert.ok(bench.plugged.host.nanos - begin < 20e6);
});

test('bits are stuck for the firmware as for the boot loader', limit, async () => {
    const bench = new Bench(undefined, { ...none, stuck: ['0x1000=0x80'] });
    assert.equal(bench.memory[0x1000], 0x7f);
    await inBootLoader(bench);
    const computer = computerOf(bench);
    computer.begin();
    computer.erase(flashAddress + 0x1000, sector);
    assert.deepEqual([bench.memory[0x1000], bench.memory[0x1001]], [0x7f, 0xff]);
    assert.throws(() => new Bench(undefined, { ...none, stuck: ['here'] }), /no such value/);
});

test('the boot loader may be that of another chip', limit, async () => {
    const bench = new Bench(undefined, { ...none, chip: 'rp2350' });
    await inBootLoader(bench);
    assert.equal(bench.identity.product, 0x000f);
});
