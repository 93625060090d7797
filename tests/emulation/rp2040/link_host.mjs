import zlib from 'node:zlib';

import { fail } from './emulation_error.mjs';
import { UsbHost } from './usb_host.mjs';
import { setUp } from './usb_traffic.mjs';

const endpoint = 1;
const reportBytes = 64;
const payloadAt = 2;
export const blockBytes = 60;
const patienceFrames = 2000;

export const home = { builtIn: 0, slot: 1, ram: 2, here: 3, start: 4 };
export const kind = {
    hello: 0x01, names: 0x02, playing: 0x03, statistics: 0x04, input: 0x05, begin: 0x10, data: 0x11, commit: 0x12,
    cancel: 0x13, slot: 0x20, erase: 0x21, choose: 0x22, play: 0x30, pause: 0x31, resume: 0x32, seek: 0x33, speed: 0x34,
    brightness: 0x35, inputs: 0x36, silence: 0x3a, arm: 0x3b, disarm: 0x3c, bootLoader: 0x3f, error: 0x7f,
};
const fromDevice = 0x80;
/** What carries a checksum in its last two bytes, and its answers. */
const checksummed = [kind.begin, kind.commit, kind.cancel, kind.slot, kind.erase, kind.choose, kind.play,
    kind.silence, kind.arm, kind.bootLoader];

export const u16 = (value) => [value & 0xff, (value >>> 8) & 0xff];
export const u32 = (value) => [...u16(value), ...u16(value >>> 16)];
export const text = (words, room = 24) => [...Buffer.from(words.padEnd(room, '\0'))];
export const crc = (bytes) => zlib.crc32?.(bytes) ?? crc32(bytes);

function crc32(bytes) {
    let value = 0xffffffff;
    for (const byte of bytes) {
        value ^= byte;
        for (let bit = 0; bit < 8; ++bit)
            value = (value >>> 1) ^ (value & 1 ? 0xedb88320 : 0);
    }
    return ~value >>> 0;
}

function crc16(bytes) {
    let value = 0xffff;
    for (const byte of bytes) {
        value ^= byte << 8;
        for (let bit = 0; bit < 8; ++bit)
            value = ((value << 1) ^ (value & 0x8000 ? 0x1021 : 0)) & 0xffff;
    }
    return value;
}

/** What a device sent. */
class Answer {
    constructor(bytes) {
        this.bytes = bytes;
        this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
        this.kind = bytes[0];
        this.tag = bytes[1];
        if (checksummed.includes(this.kind & ~fromDevice) && this.u16(reportBytes - 2) !== crc16(bytes.subarray(0, -2)))
            fail(`link: the checksum of ${this.kind.toString(16)} is wrong`);
    }

    u8(at) { return this.bytes[at]; }
    u16(at) { return this.view.getUint16(at, true); }
    u32(at) { return this.view.getUint32(at, true); }
    i32(at) { return this.view.getInt32(at, true); }
    text(at, room = 24) { return Buffer.from(this.bytes.subarray(at, at + room)).toString().replace(/\0.*/, ''); }
    get isError() { return this.kind === (kind.error | fromDevice); }
    get error() { return this.isError ? this.u8(3) : 0; }
}

/** A computer that speaks the link (docs/link.md) with a board over USB, as strictly as UsbHost does. */
export class LinkHost {
    /** How often the device let it wait when it had a report to send. */
    waits = 0;
    /** Of those that carried data: reports, and the bytes of scenes in them. */
    dataReports = 0;
    dataBytes = 0;
    /** Answers that nobody has looked at. */
    inbox = [];

    #tag = 100;

    constructor(board) {
        this.board = board;
        this.usb = new UsbHost(board);
    }

    setUp() {
        return setUp(this.usb);
    }

    /** Unplugs and plugs in again, as far as a device that is powered otherwise sees it. */
    begin() {
        this.inbox = [];
        this.usb.reset();
        return this.setUp();
    }

    /** One frame of the bus: a report to the device, if there is one and it takes it, and one from it. */
    frame(report) {
        this.usb.nextFrame();
        const isTaken = report === undefined || this.usb.sendOnce(endpoint, report) === 'ack';
        this.waits += isTaken ? 0 : 1;
        const answer = this.usb.askOnce(endpoint);
        if (answer !== 'nak')
            this.inbox.push(new Answer(answer));
        return isTaken;
    }

    wait(milliseconds) {
        for (let frame = 0; frame < milliseconds; ++frame)
            this.frame();
    }

    static report(which, payload, tag) {
        const bytes = new Uint8Array(reportBytes);
        bytes.set([which, tag, ...payload]);
        if (checksummed.includes(which))
            bytes.set(u16(crc16(bytes.subarray(0, -2))), reportBytes - 2);
        return bytes;
    }

    /** Sends a report that needs no answer. */
    tell(which, payload = [], tag = 0) {
        this.sendBytes(LinkHost.report(which, payload, tag));
    }

    sendBytes(bytes) {
        for (let frame = 0; frame < patienceFrames; ++frame)
            if (this.frame(bytes))
                return;
        fail(`link: the device takes nothing for ${patienceFrames} ms`);
    }

    /** The answer to a request, an error too. */
    ask(which, payload = [], tag = this.#nextTag()) {
        this.tell(which, payload, tag);
        return this.answer(which, tag);
    }

    /** The answer to a request that was sent. */
    answer(which, tag) {
        const isIt = (report) => report.tag === tag && (report.kind === (which | fromDevice)
            || (report.isError && report.u8(payloadAt) === which));
        for (let frame = 0; frame < patienceFrames; ++frame) {
            const found = this.inbox.findIndex(isIt);
            if (found >= 0)
                return this.inbox.splice(found, 1)[0];
            this.frame();
        }
        return fail(`link: no answer to ${which.toString(16)} for ${patienceFrames} ms`);
    }

    /** Asks for what must succeed. */
    must(which, payload = [], tag = undefined) {
        const answer = this.ask(which, payload, tag);
        if (answer.isError)
            fail(`link: ${which.toString(16)} fails: ${answer.error}, ${answer.text(8, 56)}`);
        return answer;
    }

    playing() {
        const told = this.must(kind.playing);
        return { plays: !!told.u8(2), isPaused: !!told.u8(3), home: told.u8(4), slot: told.u8(5),
            brightness: told.u8(6), inputs: told.u8(7), moment: told.i32(20), speed: told.i32(24), clip: told.text(28),
            arming: told.u8(52), restarts: { count: told.u8(53), home: told.u8(54), slot: told.u8(55) } };
    }

    statistics() {
        const told = this.must(kind.statistics);
        return { frames: told.u32(2), late: told.u32(6), skipped: told.u32(10), errors: told.u32(14) };
    }

    play(where, slot = 255, clip = '') {
        return this.must(kind.play, [where, slot, ...text(clip)]);
    }

    beginUpload(where, slot, bytes, tag = this.#nextTag()) {
        const begun = this.must(kind.begin, [where, slot, ...u32(bytes.length), ...u32(crc(bytes)), ...text('scene')], tag);
        return { tag, bytes, blocks: Math.ceil(bytes.length / blockBytes), sent: 0, acked: begun.u16(2), window: begun.u16(4) };
    }

    /** Keeps the window full until all has come. */
    sendData(upload) {
        while (upload.acked < upload.blocks) {
            const next = upload.sent < Math.min(upload.blocks, upload.acked + upload.window)
                ? this.dataReport(upload, upload.sent) : undefined;
            if (this.frame(next) && next)
                this.#count(upload, upload.sent++);
            for (const told of this.inbox.splice(0))
                this.#heed(upload, told);
        }
    }

    dataReport({ bytes, tag }, block) {
        const at = block * blockBytes;
        return LinkHost.report(kind.data, [...u16(block), ...bytes.subarray(at, at + blockBytes)], tag);
    }

    #count({ bytes }, block) {
        this.dataReports += 1;
        this.dataBytes += Math.min(blockBytes, bytes.length - block * blockBytes);
    }

    #heed(upload, told) {
        if (told.kind !== (kind.data | fromDevice) || told.tag !== upload.tag)
            fail(`link: ${told.kind.toString(16)} comes during an upload`);
        upload.acked = told.u16(2);
        if (told.u8(6))
            upload.sent = upload.acked;
    }

    /** From begin to commit. */
    upload(where, slot, bytes) {
        const upload = this.beginUpload(where, slot, bytes);
        this.sendData(upload);
        this.must(kind.commit, [], upload.tag);
    }

    #nextTag() {
        this.#tag = (this.#tag % 250) + 1;
        return this.#tag;
    }
}
