// Shares the image tests/boards/pico/usb_trial.cpp, which sends every report back with one added to its first byte, over
// USB/IP: node pico_usbip_test.mjs pico-usb-trial.bin
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import readline from 'node:readline';
import test from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';

import { request } from './rp2040/usb_host.mjs';
import { Client } from './usbip/client.mjs';

const image = process.argv[2];
const server = fileURLToPath(new URL('usbip/serve.mjs', import.meta.url));
const busId = '1-1';
const reports = 1; // the endpoints
const roomOfRings = 16 + 4 + 1; // both, and what the program holds in between

const getDevice = (length = 18) => request(0x80, 6, 0x0100, 0, length);
const getConfiguration = request(0x80, 8, 0, 0, 1);
const getSerialNumber = request(0x80, 6, 0x0303, 0x0409, 255);
const configure = request(0x00, 9, 1);

const [done, stalled, cancelled] = [0, -32, -104];

const report = (seed) => Uint8Array.from({ length: 64 }, (_, i) => seed * 31 + i);

function sentBack(seed) {
    const back = report(seed);
    back[0] += 1;
    return back;
}

class Served {
    static async start(...options) {
        const served = new Served(spawn('node', [server, image, ...options], { stdio: ['pipe', 'pipe', 'inherit'] }));
        served.port = Number((await served.line()).split(' ')[1]);
        return served;
    }

    constructor(child) {
        this.child = child;
        this.lines = readline.createInterface({ input: child.stdout })[Symbol.asyncIterator]();
    }

    async line() {
        return (await this.lines.next()).value;
    }

    async command(word) {
        this.child.stdin.write(`${word}\n`);
        assert.equal(await this.line(), word);
    }
}

/** Runs `work` with a shared board, and a client that has it. */
async function withClient(work, ...options) {
    const served = await Served.start(...options);
    try {
        const client = await Client.connect(served.port);
        assert.ok(await client.import(busId));
        await client.control(configure);
        await work(client, served);
        client.close();
    } finally {
        served.child.stdin.end();
    }
}

async function expectEcho(client, seed) {
    client.submit(reports, { data: report(seed) });
    assert.deepEqual((({ status, count }) => [status, count])(await client.answer()), [done, 64]);
    const wanted = client.submit(reports, { isIn: true, length: 64 });
    const { sequence, data } = await client.answer(true);
    assert.deepEqual([sequence, data], [wanted, sentBack(seed)]);
}

const limit = { timeout: 120000 };

test('the device is told, and is there under its name alone', limit, () => withClient(async (_, served) => {
    const client = await Client.connect(served.port);
    const device = await client.list();
    assert.deepEqual([300, 302].map((at) => device.readUInt16BE(at)), [0x1209, 0x0001]);
    assert.deepEqual([...device.subarray(-4)], [3, 0, 0, 0]);
    assert.ok(!await client.import('1-2'));
    await client.ended;
}));

test('control transfers go both ways, and are stalled', limit, () => withClient(async (client) => {
    const { status, count, data } = await client.control(getDevice());
    assert.deepEqual([status, count, data.length], [done, 18, 18]);
    assert.equal((await client.control(request(0x80, 6, 0x0600, 0, 10))).status, stalled);
    assert.deepEqual(await client.control(request(0x21, 9, 0x0200, 0, 64), report(1)),
        { kind: 3, sequence: 4, status: done, count: 64, data: new Uint8Array(0) });
    client.submit(reports, { isIn: true, length: 64 });
    assert.deepEqual((await client.answer(true)).data, sentBack(1));
}));

test('hundreds of reports go there and back', limit, () => withClient(async (client) => {
    for (let i = 0; i < 300; ++i)
        await expectEcho(client, i);
}));

test('a transfer waits until the device has something, and others pass it', limit, () => withClient(async (client) => {
    client.submit(reports, { isIn: true, length: 64 });
    assert.deepEqual((await client.control(getConfiguration)).data, Uint8Array.of(1));
    client.submit(reports, { data: report(2) });
    assert.equal((await client.answer()).status, done);
    assert.deepEqual((await client.answer(true)).data, sentBack(2));
}));

test('a transfer is unlinked once', limit, () => withClient(async (client) => {
    const waiting = client.submit(reports, { isIn: true, length: 64 });
    client.unlink(waiting);
    assert.deepEqual((({ kind, status }) => [kind, status])(await client.answer()), [4, cancelled]);
    client.unlink(waiting);
    assert.deepEqual((({ kind, status }) => [kind, status])(await client.answer()), [4, 0]);
    await expectEcho(client, 5);
}));

test('a device without room takes a report later', limit, () => withClient(async (client) => {
    for (let i = 0; i < roomOfRings; ++i) {
        client.submit(reports, { data: report(i) });
        assert.equal((await client.answer()).status, done);
    }
    const late = client.submit(reports, { data: report(roomOfRings) });
    assert.deepEqual((await client.control(getConfiguration)).data, Uint8Array.of(1));
    client.submit(reports, { isIn: true, length: 64 });
    assert.deepEqual((await client.answer(true)).data, sentBack(0));
    assert.equal((await client.answer()).sequence, late);
}));

test('a halt stalls reports until it is cleared', limit, () => withClient(async (client) => {
    await client.control(request(0x02, 3, 0, 0x81));
    client.submit(reports, { isIn: true, length: 64 });
    assert.equal((await client.answer(true)).status, stalled);
    await client.control(request(0x02, 1, 0, 0x81));
    await expectEcho(client, 6);
}));

test('a port that is reset has a device that is not configured', limit, () => withClient(async (client) => {
    assert.deepEqual((await client.control(getConfiguration)).data, Uint8Array.of(1));
    assert.equal((await client.control(getDevice(64))).count, 18);
    assert.deepEqual((await client.control(getConfiguration)).data, Uint8Array.of(0));
    await client.control(configure);
    await expectEcho(client, 7);
}));

test('who opens the device a second time sees every report, and disturbs nobody', limit,
    () => withClient(async (first, served) => {
        const second = await Client.connect(served.port);
        assert.ok(await second.import(busId));
        for (const client of [first, second])
            client.submit(reports, { isIn: true, length: 64 });
        assert.equal((await second.control(getDevice())).count, 18);
        first.submit(reports, { data: report(3) });
        assert.equal((await first.answer()).status, done);
        for (const client of [first, second])
            assert.deepEqual((await client.answer(true)).data, sentBack(3));
        second.close();
        await expectEcho(first, 4);
    }));

test('unplugged it ends its connections; plugged in again it is there again', limit,
    () => withClient(async (client, served) => {
        client.submit(reports, { isIn: true, length: 64 });
        await served.command('unplug');
        await client.ended;
        const next = await Client.connect(served.port);
        assert.equal(await next.list(), undefined);
        assert.ok(!await next.import(busId));
        await served.command('plug');
        const last = await Client.connect(served.port);
        assert.ok(await last.import(busId));
        await last.control(configure);
        await expectEcho(last, 8);
        last.close();
    }));

test('it can be unplugged at a certain report', limit, () => withClient(async (client, served) => {
    await served.command('unplug after 3');
    for (let i = 0; i < 2; ++i)
        await expectEcho(client, i);
    client.submit(reports, { data: report(2) });
    await client.ended;
    await served.command('plug');
    const next = await Client.connect(served.port);
    assert.ok(await next.import(busId));
    await next.control(configure);
    for (let i = 0; i < 5; ++i)
        await expectEcho(next, i);
    next.close();
}));

test('frozen it takes nothing, until it is thawed', limit, () => withClient(async (client, served) => {
    await served.command('freeze');
    client.submit(reports, { data: report(1) });
    const answer = client.answer();
    const nothing = Symbol('nothing');
    assert.equal(await Promise.race([answer, sleep(300, nothing)]), nothing);
    await served.command('thaw');
    assert.equal((await answer).status, done);
}));

test('garbage ends a connection, and no other', limit, () => withClient(async (client, served) => {
    const rude = await Client.connect(served.port);
    rude.socket.write('GET / HTTP/1.1\r\n\r\n');
    await rude.ended;
    await expectEcho(client, 9);
}));

test('boards have the serial numbers of their chips', limit, () => withClient(async (client) => {
    const { data } = await client.control(getSerialNumber);
    assert.equal(Buffer.from(data.subarray(2)).toString('utf16le'), '00112233AABBCCDD');
}, '--chip-number', '00112233aabbccdd'));
