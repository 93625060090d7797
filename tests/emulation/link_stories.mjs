// What a computer does with a board over the link: run_pico.mjs --link NAME. Each is told a host (link_host.mjs), the
// files that were named, and all that is wired, and tells what it found; a test looks at the rest (pico_link_test.py).
import assert from 'node:assert/strict';

import { EmulationError } from './rp2040/emulation_error.mjs';
import { Hang } from './rp2040/hang.mjs';
import { blockBytes, crc, home, kind, text, u16, u32 } from './rp2040/link_host.mjs';
import { wiredBoard } from './rp2040/wired_board.mjs';

const frameTicks = 1024;
const asAuthored = 65536;

/** How many frames the log has told of. */
const framesTold = ({ log }) => log.lines.filter(([, line]) => line.startsWith('F ')).length;
/** The times of the last frames, in frames of the scene. */
const lastFrames = ({ log }, count) => log.lines.filter(([, line]) => line.startsWith('F ')).slice(-count)
    .map(([, line]) => Number(line.split(' ')[1]) / frameTicks);

function waitForFrames(host, wired, count) {
    for (const wanted = framesTold(wired) + count; framesTold(wired) < wanted;)
        host.wait(5);
}

function tells(host, _files, wired) {
    waitForFrames(host, wired, 2);
    const hello = host.must(kind.hello);
    const names = host.must(kind.names);
    const playing = host.playing();
    return { protocol: hello.u8(2), slots: hello.u8(3), panel: [hello.u16(4), hello.u16(6)], block: hello.u32(8),
        ram: hello.u32(12), pool: hello.u32(16), room: hello.u32(20), serial: hello.text(24), firmware: names.text(2, 14),
        board: names.text(16), display: names.text(40), playing };
}

/** Into RAM, twice, with what plays going on meanwhile. */
function ram(host, { first, second }, wired) {
    waitForFrames(host, wired, 3);
    const told = { delays: [] };
    for (const scene of [first, second, first]) {
        const before = framesTold(wired);
        host.upload(home.ram, 255, scene);
        assert.ok(framesTold(wired) > before || scene.length < 10 * blockBytes, 'nothing is shown during the upload');
        const asked = wired.board.nanos;
        const scenes = wired.log.lines.filter(([, line]) => line.startsWith('SCENE')).length;
        host.play(home.ram);
        waitForFrames(host, wired, 12);
        const begun = wired.log.lines.filter(([, line]) => line.startsWith('SCENE'))[scenes];
        told.delays.push((begun[0] - asked) / 1e6);
    }
    return { ...told, waits: host.waits, dataReports: host.dataReports, dataBytes: host.dataBytes,
        playing: host.playing(), statistics: host.statistics() };
}

/** Into a slot, while the built-in scene plays; then it is chosen. The slot is replaced while it plays. */
function slot(host, { first, second }, wired) {
    waitForFrames(host, wired, 3);
    host.upload(home.slot, 4, first);
    host.must(kind.choose, [4]);
    waitForFrames(host, wired, 3);
    host.play(home.slot, 4);
    waitForFrames(host, wired, 3);
    host.upload(home.slot, 4, second);
    waitForFrames(host, wired, 3);
    const contents = host.must(kind.slot, [4]);
    assert.equal(contents.u8(3), 1);
    assert.equal(contents.u32(4), second.length);
    assert.equal(contents.u32(8), crc(second));
    assert.equal(contents.text(12), 'scene');
    return { statistics: host.statistics(), playing: host.playing() };
}

function nothing(host, _files, wired) {
    waitForFrames(host, wired, 5);
    return { playing: host.playing() };
}

function steers(host, { first }, wired) {
    waitForFrames(host, wired, 3);
    const told = {};
    host.must(kind.pause);
    waitForFrames(host, wired, 6);
    const paused = lastFrames(wired, 4);
    assert.deepEqual(new Set(paused).size, 1, `paused it shows ${paused}`);
    assert.ok(host.playing().isPaused);
    host.must(kind.seek, u32(10 * frameTicks));
    waitForFrames(host, wired, 3);
    assert.deepEqual(lastFrames(wired, 1), [10]);
    host.must(kind.speed, u32(2 * asAuthored));
    host.must(kind.resume);
    waitForFrames(host, wired, 6);
    const fast = lastFrames(wired, 3);
    assert.deepEqual([fast[1] - fast[0], fast[2] - fast[1]], [2, 2]);
    host.must(kind.brightness, [64]);
    waitForFrames(host, wired, 3);
    assert.equal(host.playing().brightness, 64);
    assert.ok(Math.abs(wired.light() - 64 / 255) < 0.02, `the light is at ${wired.light()}`);
    host.upload(home.ram, 255, first);
    host.play(home.ram, 255, 'late');
    waitForFrames(host, wired, 5);
    assert.ok(lastFrames(wired, 3).every((frame) => frame >= 20 && frame <= 30), `${lastFrames(wired, 3)}`);
    assert.equal(host.playing().clip, 'late');
    assert.equal(host.playing().speed, asAuthored);
    const input = host.must(kind.input, [0]);
    assert.equal(input.text(4), 'gaze');
    assert.deepEqual([input.i32(28), input.i32(32), input.i32(36), input.u32(40)], [-1000, 1000, 0, 32768]);
    assert.equal(host.ask(kind.input, [9]).error, 24);
    host.must(kind.seek, u32(20 * frameTicks));
    host.must(kind.pause);
    host.must(kind.inputs, [1, 0, ...u32(65536)]);
    assert.equal(host.must(kind.input, [0]).u32(40), 65536);
    waitForFrames(host, wired, 3);
    told.seen = lastFrames(wired, 1)[0];
    return told;
}

/** A computer that falls silent, one that goes, and one that resets the bus. */
function silence(host, { first }, wired) {
    waitForFrames(host, wired, 2);
    const returns = (leave) => {
        host.upload(home.ram, 255, first);
        host.play(home.ram);
        host.must(kind.silence, [...u16(200), 1]);
        waitForFrames(host, wired, 3);
        assert.equal(host.playing().home, home.ram);
        leave();
        waitForFrames(host, wired, 3);
        assert.equal(host.playing().home, home.builtIn);
    };
    returns(() => host.wait(260));
    returns(() => { host.usb.suspend(); host.usb.run(60e6); host.usb.resume(); });
    returns(() => { host.usb.reset(); host.usb.run(60e6); host.begin(); });
    host.must(kind.silence, [...u16(100), 0]);
    host.wait(160);
    assert.ok(host.playing().isPaused);
    host.must(kind.resume);
    host.wait(300);
    assert.ok(!host.playing().isPaused, 'it is done twice');
    return {};
}

function bootLoader(host, _files, wired) {
    waitForFrames(host, wired, 2);
    host.must(kind.bootLoader);
    const answered = wired.board.nanos;
    try {
        host.wait(300);
    } catch (problem) {
        if (!(problem instanceof EmulationError))
            throw problem;
    }
    return { ending: wired.board.ending, after: (wired.board.nanos - answered) / 1e6, kept: wired.board.scratch[3] };
}

/** Reports that mean nothing, and some that are too short, between those of an upload. */
function garbage(host, { first }, wired) {
    let seed = 12345;
    const random = () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) >>> 16;
    const upload = host.beginUpload(home.ram, 255, first);
    const safe = (which) => ![kind.begin, kind.cancel, kind.commit, kind.bootLoader, kind.data].includes(which);
    for (let block = 0; block < upload.blocks; ++block) {
        const bytes = Uint8Array.from({ length: 64 }, random);
        if (!safe(bytes[0]))
            bytes[0] = 0xee;
        host.sendBytes(block % 3 === 0 ? bytes.subarray(0, random() % 64) : bytes);
        host.sendBytes(host.dataReport(upload, block));
    }
    host.wait(50);
    host.inbox = [];
    host.must(kind.commit, [], upload.tag);
    host.must(kind.choose, [255]);
    host.must(kind.resume);
    host.play(home.ram);
    waitForFrames(host, wired, 4);
    return { errors: host.statistics().errors };
}

/** A board that shows a card can be talked to. */
function card(host, { first }, wired) {
    host.wait(2000);
    assert.ok(!host.playing().plays);
    assert.equal(host.ask(kind.play, [home.builtIn, 255, ...text('')]).error, 36);
    host.upload(home.ram, 255, first);
    host.play(home.ram);
    waitForFrames(host, wired, 4);
    return { playing: host.playing() };
}

/** A board without settings can show nothing, and says so. */
function blind(host, { first }) {
    host.upload(home.slot, 0, first);
    assert.equal(host.ask(kind.play, [home.slot, 0, ...text('')]).error, 31);
    return { playing: host.playing() };
}

/** Everything that flash may be when power goes during an upload and a choice. */
function flashStates(board) {
    const states = [board.memory.slice()];
    let seed = 99;
    board.onFlashOperation = (offset, wanted) => {
        const half = board.memory.slice();
        const random = board.memory.slice();
        for (let i = 0; i < wanted.length; ++i) {
            seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
            const next = board.memory[offset + i] & wanted[i];
            random[offset + i] = seed >>> 24;
            if (2 * i < wanted.length)
                half[offset + i] = wanted[i] === 0xff ? 0xff : next;
        }
        states.push(board.memory.slice(), half, random);
    };
    return states;
}

/** Starts a board with that flash; what it plays: the size and the sum that its log tells, once a frame is shown. */
function playedAfter(memory, settings) {
    const wired = wiredBoard(memory, settings, { press: [], knob: [], absent: [], frames: '1' });
    wired.board.run(2e9);
    const scene = wired.log.lines.find(([, line]) => line.startsWith('SCENE'));
    assert.equal(wired.board.ending, 'enough frames');
    return scene[1];
}

function cuts(host, { first, second }, wired) {
    waitForFrames(host, wired, 2);
    host.upload(home.slot, 1, first);
    host.must(kind.choose, [1]);
    const states = flashStates(wired.board);
    host.upload(home.slot, 2, second);
    host.must(kind.choose, [2]);
    states.push(wired.board.memory.slice());
    wired.board.onFlashOperation = () => {};
    return { played: states.map((memory) => playedAfter(memory, wired.settings)) };
}

/** A laser: armed, disarmed, armed again; then the computer falls silent. */
function arming(host, _files, wired) {
    const told = { arming: [host.playing().arming], at: [] };
    const order = (which) => {
        waitForFrames(host, wired, 5);
        host.must(which);
        told.at.push(wired.board.nanos);
        told.arming.push(host.playing().arming);
    };
    order(kind.arm);
    order(kind.disarm);
    order(kind.arm);
    host.must(kind.silence, [...u16(100), 1]);
    host.wait(300);
    told.arming.push(host.playing().arming);
    return told;
}

function armsNothing(host) {
    return { errors: [host.ask(kind.arm).error, host.ask(kind.disarm).error], arming: host.playing().arming };
}

/** Into a slot while the built-in scene plays, which goes on. */
function keeps(host, { first }, wired) {
    waitForFrames(host, wired, 3);
    host.upload(home.slot, 4, first);
    waitForFrames(host, wired, 3);
    return {};
}

const watchdogNanos = 8.4e9;

/** What begins, as the log tells it, in the order of time. */
const scenesTold = ({ log }) => log.lines.map(([, line]) => line).filter((line) => line.startsWith('SCENE'));

/** Until the watchdog has restarted the board, which the computer sets up anew. */
function awaitRestart(host, { board }) {
    const { starts } = board;
    const end = board.nanos + watchdogNanos + 1e9;
    while (board.starts === starts && board.nanos < end)
        host.usb.run(1e6);
    assert.equal(board.starts, starts + 1, 'the watchdog does not bite');
    host.inbox = [];
    host.setUp();
}

/** The scene of the chosen slot hangs whenever it begins. */
function hangs(host, { first }, wired) {
    waitForFrames(host, wired, 2);
    const [builtIn] = scenesTold(wired);
    host.upload(home.slot, 2, first);
    host.must(kind.choose, [2]);
    const hang = new Hang(wired, (line) => line.startsWith('SCENE') && line !== builtIn);
    const told = { before: host.playing().restarts };
    host.play(home.slot, 2);
    awaitRestart(host, wired);
    awaitRestart(host, wired);
    told.hangs = hang.count;
    const frames = framesTold(wired);
    told.atStart = host.playing();
    host.wait(4000);
    assert.equal(framesTold(wired), frames, 'the notice is gone too soon');
    waitForFrames(host, wired, 3);
    told.playing = host.playing();
    assert.equal(host.must(kind.slot, [2]).u8(3), 1, 'it is no longer chosen');
    host.must(kind.choose, [255]);
    host.must(kind.erase, [2]);
    host.play(home.start);
    waitForFrames(host, wired, 3);
    return { ...told, starts: wired.board.starts, afterwards: host.playing(), powered: afterPower(wired) };
}

/** How often a board with the same flash says that its watchdog has restarted it when its power comes on. */
function afterPower({ board, settings }) {
    const wired = wiredBoard(board.memory.slice(), settings, { press: [], knob: [], absent: [], frames: '1' });
    wired.board.run(2e9);
    assert.equal(wired.board.ending, 'enough frames');
    return wired.log.lines.filter(([, line]) => line.startsWith('RESTARTED')).length;
}

/** The built-in scene hangs whenever it begins, and no slot is chosen. */
function hangsBuiltIn(host, { first }, wired) {
    waitForFrames(host, wired, 2);
    const [builtIn] = scenesTold(wired);
    const hang = new Hang(wired, (line) => line === builtIn);
    host.play(home.builtIn);
    awaitRestart(host, wired);
    awaitRestart(host, wired);
    host.wait(6000);
    const told = { hangs: hang.count, playing: host.playing() };
    host.upload(home.ram, 255, first);
    host.play(home.ram);
    waitForFrames(host, wired, 3);
    told.fromRam = host.playing();
    host.play(home.start);
    host.wait(200);
    return { ...told, starts: wired.board.starts };
}

export const stories = {
    arming, armsNothing, keeps, tells, ram, slot, nothing, steers, silence, bootLoader, garbage, card, blind, cuts,
    hangs, hangsBuiltIn,
};
