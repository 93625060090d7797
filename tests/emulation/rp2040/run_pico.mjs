// Boots an image of boards/pico in rp2040js and records what happens at the pins; usage() tells how.
import fs from 'node:fs';
import { parseArgs } from 'node:util';

import { Board } from './board.mjs';
import { BusTime } from './bus_time.mjs';
import { Controls } from './controls.mjs';
import { Display } from './display.mjs';
import { busFor } from './display_buses.mjs';
import { EmulationError, fail } from './emulation_error.mjs';
import { HeldData } from './held_data.mjs';
import { Led } from './led.mjs';
import { LogLine } from './log_line.mjs';
import { Inputs, noPin } from './pins.mjs';
import { report } from './report.mjs';
import { readSettings, sceneOffset, settingsOffset } from './settings.mjs';
import { TearingLine } from './tearing_line.mjs';
import { Trace } from './trace.mjs';
import { UsbTraffic } from './usb_traffic.mjs';

const usage = `usage: node run_pico.mjs IMAGE.bin --settings RECORD --trace FILE --report FILE [OPTION]...

  --settings RECORD       the board record: placed in flash, and how the display is wired
  --wired-only            the record only tells how it is wired; the image has its own settings
  --scene FILE            placed in flash
  --patch OFFSET=BYTE     changes a byte of flash; may be repeated
  --for MILLISECONDS      ends after that much emulated time (default 1000)
  --frames COUNT          ends after so many lines "F …" of the log
  --press PIN@FROM-TO     holds a button from one millisecond to another; may be repeated
  --knob PIN@AT=VALUE     turns a knob at a millisecond so that 0 … 4095 is read; may be repeated
  --hold-data CLOCKS      the display was interrupted and holds SDA low for so many clocks of I2C
  --address ADDRESS       the display on I2C has this one, whatever the record says
  --absent FROM-TO        it does not answer from one millisecond to another; may be repeated
  --usb                   a computer sets the board up, and sends it a report every millisecond
  --te MICROSECONDS       the glass shows a picture every so often and its TE line tells; else it is not wired

Exits with 1 when something happened that would not work on hardware or that the emulator cannot do: the report says
what. "ending" in the report tells why it ended.`;

const options = {
    settings: { type: 'string' }, 'wired-only': { type: 'boolean' }, scene: { type: 'string' },
    patch: { type: 'string', multiple: true, default: [] }, trace: { type: 'string' }, report: { type: 'string' },
    for: { type: 'string', default: '1000' }, frames: { type: 'string' }, te: { type: 'string' },
    usb: { type: 'boolean' },
    'hold-data': { type: 'string' }, address: { type: 'string' },
    absent: { type: 'string', multiple: true, default: [] },
    press: { type: 'string', multiple: true, default: [] }, knob: { type: 'string', multiple: true, default: [] },
};

function parsed(text, pattern, option) {
    const match = pattern.exec(text) ?? fail(`--${option} ${text}: ${usage}`);
    return match.slice(1).map(Number);
}

function memoryFrom(image, values) {
    const bytes = new Uint8Array(2 * 1024 * 1024).fill(0xff);
    bytes.set(fs.readFileSync(image));
    if (!values['wired-only'])
        bytes.set(fs.readFileSync(values.settings), settingsOffset);
    if (values.scene)
        bytes.set(fs.readFileSync(values.scene), sceneOffset);
    for (const patch of values.patch) {
        const [offset, byte] = parsed(patch, /^(\w+)=(\w+)$/, 'patch');
        bytes[offset] = byte;
    }
    return bytes;
}

function actions(values) {
    const presses = values.press.flatMap((text) => {
        const [pin, from, to] = parsed(text, /^(\d+)@([\d.]+)-([\d.]+)$/, 'press');
        return [{ pin, nanos: from * 1e6, level: false }, { pin, nanos: to * 1e6, level: undefined }];
    });
    const turns = values.knob.map((text) => {
        const [pin, at, value] = parsed(text, /^(\d+)@([\d.]+)=(\d+)$/, 'knob');
        return { pin, nanos: at * 1e6, value };
    });
    return [...presses, ...turns];
}

/** Which addresses a display on I2C answers, and when, as options tell. */
function answersBy(board, settings, values) {
    const own = Number(values.address ?? settings.address);
    const absences = values.absent.map((text) => parsed(text, /^([\d.]+)-([\d.]+)$/, 'absent'));
    const isAbsent = (milliseconds) => absences.some(([from, to]) => milliseconds >= from && milliseconds < to);
    return (address) => address === own && !isAbsent(board.nanos / 1e6);
}

/** A board with everything wired to it that the settings and the options tell. */
function wiredBoard(memory, settings, values) {
    const trace = new Trace();
    const busTime = new BusTime();
    const board = new Board(memory);
    busTime.programCounter = () => board.mcu.core.PC;
    const inputs = board.add(new Inputs());
    const display = board.add(new Display(settings, trace, busTime));
    const bus = board.add(busFor(display));
    const led = board.add(new Led());
    const log = board.add(new LogLine(settings, trace));
    board.add(new Controls(inputs, actions(values)));
    log.onLine = (text, nanos) => {
        busTime.note(text, nanos);
        if (busTime.frames.length === Number(values.frames))
            board.end('enough frames');
    };
    if (values['hold-data']) {
        const held = board.add(new HeldData(inputs, settings.pins, Number(values['hold-data'])));
        bus.isFree = () => held.isFree;
    }
    if (values.address || values.absent.length > 0)
        bus.answers = answersBy(board, settings, values);
    let tearing;
    if (values.te && settings.pins.tearing !== noPin) {
        tearing = board.add(new TearingLine(inputs, settings.pins.tearing, Number(values.te) * 1000));
        display.onCommand = (byte) => tearing.command(byte);
    }
    const usb = values.usb && new UsbTraffic(board);
    return { board, bus, busTime, display, led, log, settings, tearing, trace, usb };
}

function run(wired, milliseconds) {
    try {
        (wired.usb || wired.board).run(milliseconds * 1e6);
    } catch (problem) {
        if (!(problem instanceof EmulationError))
            throw problem;
        return problem.message;
    }
    return undefined;
}

function main() {
    const { values, positionals: [image] } = parseArgs({ options, allowPositionals: true });
    if (!image || !values.settings || !values.trace || !values.report)
        fail(usage);
    const settings = readSettings(fs.readFileSync(values.settings));
    const wired = wiredBoard(memoryFrom(image, values), settings, values);
    const failure = run(wired, Number(values.for));
    wired.trace.write(values.trace);
    fs.writeFileSync(values.report, JSON.stringify(report(wired, failure), null, 1));
    if (failure)
        fail(failure);
}

try {
    main();
} catch (problem) {
    if (!(problem instanceof EmulationError))
        throw problem;
    console.error(problem.message);
    process.exitCode = 1;
}
