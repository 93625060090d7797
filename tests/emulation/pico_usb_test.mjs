// Asks the image tests/boards/pico/usb_trial.cpp, which sends every report back with one added to its first byte,
// whatever a computer may ask: node pico_usb_test.mjs pico-usb-trial.bin
import assert from 'node:assert/strict';
import fs from 'node:fs';
import test from 'node:test';

import { Board } from './rp2040/board.mjs';
import { uniqueId } from './rp2040/flash_chip.mjs';
import { UsbHost, request, textOf } from './rp2040/usb_host.mjs';

const image = fs.readFileSync(process.argv[2]);
const address = 5;
const roomOfRings = 16 + 4 + 1; // both, and what the program holds in between
const reports = 1; // the endpoints
const rearmNanos = 4000; // from a report to when the next one may come

const getDevice = request(0x80, 6, 0x0100, 0, 18);
const getConfiguration = request(0x80, 6, 0x0200, 0, 255);
const getText = (index) => request(0x80, 6, 0x0300 | index, 0x0409, 255);
const configure = request(0x00, 9, 1);
const getHalt = (endpoint) => request(0x82, 0, 0, endpoint, 2);
const setHalt = (endpoint) => request(0x02, 3, 0, endpoint);
const clearHalt = (endpoint) => request(0x02, 1, 0, endpoint);
const setReport = (length) => request(0x21, 9, 0x0200, 0, length);
const getReport = request(0xa1, 1, 0x0100, 0, 64);
const done = new Uint8Array(0);

function report(seed, length = 64) {
    return Uint8Array.from({ length }, (_, i) => seed * 31 + i);
}

function sentBack(bytes) {
    const back = new Uint8Array(64);
    back.set(bytes);
    back[0] += 1;
    return back;
}

function attached() {
    const host = new UsbHost(new Board(image));
    host.awaitDevice(100e6);
    return host;
}

function setUp(host) {
    host.reset();
    host.setAddress(address);
    assert.deepEqual(host.control(configure), done);
    return host;
}

const configured = () => setUp(attached());

function expectEcho(host, seed) {
    assert.equal(host.send(reports, report(seed)), 'ack');
    assert.deepEqual(host.ask(reports), sentBack(report(seed)));
}

test('a computer finds the device as it always does', () => {
    const host = attached();
    host.reset();
    const first = host.control(request(0x80, 6, 0x0100, 0, 64));
    assert.equal(first.length, 18);
    host.reset();
    assert.deepEqual(host.setAddress(address), done);
    assert.equal(host.unit.address, address);
    assert.deepEqual(host.control(getDevice), first);
    const configuration = host.control(getConfiguration);
    assert.equal(configuration.length, configuration[2] | (configuration[3] << 8));
    assert.deepEqual(host.control(request(0x80, 6, 0x0200, 0, 9)), configuration.subarray(0, 9));
    assert.deepEqual(host.control(configure), done);
    assert.deepEqual(host.control(request(0x80, 8, 0, 0, 1)), Uint8Array.of(1));
    const description = host.control(request(0x81, 6, 0x2200, 0, 255));
    assert.equal(description.length, configuration[25] | (configuration[26] << 8));
    assert.deepEqual(description.subarray(0, 3), Uint8Array.of(0x06, 0x00, 0xff));
    assert.equal(description.at(-1), 0xc0);
    expectEcho(host, 1);
});

test('its names are there, and its number is that of the chip', () => {
    const host = configured();
    assert.deepEqual(host.control(request(0x80, 6, 0x0300, 0, 255)), Uint8Array.of(4, 3, 9, 4));
    const number = Buffer.from(uniqueId).toString('hex').toUpperCase();
    assert.deepEqual([1, 2, 3].map((index) => textOf(host.control(getText(index)))), ['KFAST', 'KFAST Pico', number]);
});

test('what it does not know it stalls, and goes on', () => {
    const host = configured();
    for (const unknown of [getText(4), getText(0xee), request(0x80, 6, 0x0600, 0, 10), request(0x80, 6, 0x0f00, 0, 5),
        request(0xc0, 1, 0, 0, 8), request(0x40, 1), request(0x00, 9, 2), request(0x01, 11, 1),
        request(0xa1, 3, 0, 0, 1), request(0x02, 3, 0, 0x82), request(0x00, 3, 1)]) {
        assert.equal(host.control(unknown), 'stall', `${unknown}`);
        assert.equal(host.askOnce(0), 'stall');
        assert.equal(host.sendOnce(0, new Uint8Array(0)), 'stall');
        assert.equal(host.control(getDevice).length, 18);
    }
    assert.equal(host.control(request(0x40, 1, 0, 0, 8), new Uint8Array(8)), 'stall');
    expectEcho(host, 2);
});

test('the idle rate is kept, and reports have no numbers', () => {
    const host = configured();
    assert.deepEqual(host.control(request(0x21, 0x0a, 0x0500)), done);
    assert.deepEqual(host.control(request(0xa1, 2, 0, 0, 1)), Uint8Array.of(5));
    assert.equal(host.control(request(0x21, 0x0a, 0x0501)), 'stall');
});

test('reports also go by the control endpoint', () => {
    const host = configured();
    assert.deepEqual(host.control(getReport), new Uint8Array(64));
    for (const length of [64, 63, 5, 1]) {
        assert.deepEqual(host.control(setReport(length), report(3, length)), done);
        assert.deepEqual(host.ask(reports), sentBack(report(3, length)));
        assert.deepEqual(host.control(getReport), sentBack(report(3, length)));
        assert.deepEqual(host.control(request(0xa1, 1, 0x0100, 0, 255)), sentBack(report(3, length)));
    }
    assert.equal(host.control(setReport(65), report(3, 65)), 'stall');
    expectEcho(host, 4);
});

test('short reports are filled up', () => {
    const host = configured();
    for (const length of [0, 1, 4, 63]) {
        host.send(reports, report(5));
        host.ask(reports);
        host.send(reports, report(6, length));
        assert.deepEqual(host.ask(reports), sentBack(report(6, length)));
    }
});

test('hundreds of reports come and go, one each way in a frame, and none has to wait', () => {
    const host = configured();
    host.naks = 0;
    for (let i = 0; i < 600; ++i) {
        host.nextFrame();
        assert.equal(host.sendOnce(reports, report(i)), 'ack', `report ${i}`);
        if (i > 0)
            assert.deepEqual(host.askOnce(reports), sentBack(report(i - 1)), `report ${i}`);
    }
    assert.equal(host.naks, 0);
});

test('hundreds of reports come as fast as the line allows', () => {
    const host = configured();
    for (let i = 0; i < 600; ++i) {
        assert.equal(host.sendOnce(reports, report(i)), 'ack', `report ${i}`);
        host.run(rearmNanos);
        if (i % 2 === 1)
            for (const one of [i - 1, i])
                assert.deepEqual(host.ask(reports), sentBack(report(one)), `report ${one}`);
    }
});

test('a computer that reads nothing has to wait, and loses nothing', () => {
    const host = configured();
    let sent = 0;
    while (host.sendOnce(reports, report(sent)) === 'ack') {
        ++sent;
        host.nextFrame();
    }
    assert.equal(sent, roomOfRings);
    assert.equal(host.control(setReport(64), report(99)), 'stall');
    for (let i = 0; i < sent; ++i)
        assert.deepEqual(host.ask(reports), sentBack(report(i)));
    assert.equal(host.askOnce(reports), 'nak');
    expectEcho(host, 7);
});

test('a halt is told, stops everything, and ends with DATA0', () => {
    const host = configured();
    for (const count of [1, 2]) // so that the halt comes after DATA0 and after DATA1
        for (const endpoint of [0x01, 0x81]) {
            for (let i = 0; i < count; ++i)
                expectEcho(host, 8 + i);
            assert.deepEqual(host.control(setHalt(endpoint)), done);
            assert.deepEqual(host.control(getHalt(endpoint)), Uint8Array.of(1, 0));
            assert.deepEqual(host.control(getHalt(endpoint ^ 0x80)), Uint8Array.of(0, 0));
            assert.equal(endpoint & 0x80 ? host.ask(reports) : host.send(reports, report(0)), 'stall');
            assert.deepEqual(host.control(clearHalt(endpoint)), done);
            assert.deepEqual(host.control(getHalt(endpoint)), Uint8Array.of(0, 0));
            expectEcho(host, 10);
        }
});

test('clearing a halt that is none also begins with DATA0, and loses no report', () => {
    const host = configured();
    for (const count of [1, 2]) {
        for (let i = 0; i < count; ++i)
            expectEcho(host, 11 + i);
        host.send(reports, report(13));
        host.nextFrame();
        host.control(clearHalt(0x01));
        host.control(clearHalt(0x81));
        assert.deepEqual(host.ask(reports), sentBack(report(13)));
        host.control(request(0x01, 11, 0));
        expectEcho(host, 14);
    }
});

test('a reset comes in the middle of anything', () => {
    const host = attached();
    const interruptions = [
        () => host.setup(getConfiguration),
        () => host.setup(setReport(64)),
        () => { host.setup(getConfiguration); host.ask(0); },
        () => { host.setup(setReport(64)); host.send(0, report(1)); },
        () => host.setup(request(0x00, 5, 77)),
        () => host.control(getText(9)),
        () => host.control(configure),
        () => { host.control(configure); host.control(setHalt(0x81)); host.control(setHalt(0x01)); },
        () => { host.control(configure); host.send(reports, report(1)); },
        () => { host.control(configure); host.send(reports, report(1)); host.nextFrame(); },
        () => { host.control(configure); host.unit.token({ number: 1, isIn: false }); },
    ];
    for (const interrupt of interruptions) {
        host.reset();
        host.setAddress(address);
        interrupt();
        setUp(host);
        assert.equal(host.askOnce(reports), 'nak', `something is left of before: ${interrupt}`);
        expectEcho(host, 15);
    }
});

test('a setup may come at any point of another transfer', () => {
    const host = configured();
    const beginnings = [
        () => host.setup(getDevice),
        () => { host.setup(getConfiguration); host.ask(0); },
        () => host.setup(setReport(64)),
        () => { host.setup(setReport(64)); host.send(0, report(1)); },
        () => host.setup(request(0x00, 8, 9)),
    ];
    for (const begin of beginnings) {
        begin();
        host.nextFrame(); // a computer gives up after a while
        assert.equal(host.control(getDevice).length, 18, `after ${begin}`);
        assert.deepEqual(host.control(request(0x80, 8, 0, 0, 1)), Uint8Array.of(1), `after ${begin}`);
    }
});

test('configured anew it begins with DATA0, and unconfigured it carries no reports', () => {
    const host = configured();
    for (const count of [1, 2]) {
        for (let i = 0; i < count; ++i)
            expectEcho(host, 16 + i);
        host.control(configure);
        expectEcho(host, 18);
    }
    host.control(request(0x00, 9, 0));
    assert.equal(host.askOnce(reports), 'timeout');
    assert.equal(host.sendOnce(reports, report(0)), 'timeout');
    assert.equal(host.control(getHalt(0x81)), 'stall');
    host.control(configure);
    expectEcho(host, 19);
});

test('it survives a sleep of the bus', () => {
    const host = configured();
    expectEcho(host, 20);
    host.suspend();
    host.run(50e6);
    host.resume();
    expectEcho(host, 21);
    host.suspend();
    host.run(50e6);
    setUp(host);
    expectEcho(host, 22);
});

test('a computer that slept and woke while nobody looked is awake with its first packet', () => {
    const host = configured();
    expectEcho(host, 23);
    for (const events of [['suspend', 'resume'], ['resume', 'suspend']]) {
        for (const event of events)
            host.unit[event]();
        host.run(1e6);
        expectEcho(host, 24);
    }
});

// What ended and the setup are found in one interrupt, or the one while the other is worked on.
test('of a transfer that is broken off nothing goes to the next one', () => {
    const host = configured();
    const stepNanos = 50;
    for (let delay = 0; delay < 12_000; delay += stepNanos) {
        host.setup(setReport(64));
        assert.equal(host.send(0, report(25)), 'ack'); // and now the device would end the transfer by an empty packet
        host.run(delay);
        host.unit.setup(getDevice);
        host.run(2900); // the token
        for (let waited = 0; host.unit.token({ number: 0, isIn: true }) === 'nak'; ++waited) {
            assert.ok(waited < 10_000);
            host.run(stepNanos);
        }
        const { pid, bytes } = host.unit.finishIn({ number: 0, isIn: true });
        assert.deepEqual([pid, bytes.length], [1, 18], `the setup ${delay} ns after the report`);
        host.unit.setup(getDevice);
        host.run(1e5);
        host.ask(reports); // the echo
    }
});
