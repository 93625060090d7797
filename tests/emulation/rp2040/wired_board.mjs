import fs from 'node:fs';

import { Board, flashBytes } from './board.mjs';
import { BusTime } from './bus_time.mjs';
import { Controls } from './controls.mjs';
import { Display } from './display.mjs';
import { busFor } from './display_buses.mjs';
import { fail } from './emulation_error.mjs';
import { HeldData } from './held_data.mjs';
import { Led } from './led.mjs';
import { LogLine } from './log_line.mjs';
import { Mcp4922, ReadBack } from './mcp4922.mjs';
import { Inputs, noPin } from './pins.mjs';
import { sceneOffset, settingsOffset } from './settings.mjs';
import { TearingLine } from './tearing_line.mjs';
import { Trace } from './trace.mjs';

/** For parseArgs(): what lies in flash, and what is wired to the board. */
export const wiringOptions = {
    settings: { type: 'string' }, 'wired-only': { type: 'boolean' }, scene: { type: 'string' },
    flash: { type: 'string' }, patch: { type: 'string', multiple: true, default: [] }, te: { type: 'string' },
    'chip-number': { type: 'string' },
    'hold-data': { type: 'string' }, address: { type: 'string' },
    absent: { type: 'string', multiple: true, default: [] },
    press: { type: 'string', multiple: true, default: [] }, knob: { type: 'string', multiple: true, default: [] },
};

/** What they are, for a text on how a program is used. */
export const wiringUsage = `\
  --settings RECORD       the board record: placed in flash, and how the display is wired
  --wired-only            the record only tells how it is wired; the image has its own settings
  --scene FILE            placed in flash
  --patch OFFSET=BYTE     changes a byte of flash; may be repeated
  --press PIN@FROM-TO     holds a button from one millisecond to another; may be repeated
  --knob PIN@AT=VALUE     turns a knob at a millisecond so that 0 … 4095 is read; may be repeated
  --flash FILE            all of the flash: IMAGE and what else would be placed there are not looked at
  --chip-number HEX       16 digits, from which the board has its serial number
  --hold-data CLOCKS      the display was interrupted and holds SDA low for so many clocks of I2C
  --address ADDRESS       the display on I2C has this one, whatever the record says
  --absent FROM-TO        it does not answer from one millisecond to another; may be repeated
  --te MICROSECONDS       the glass shows a picture every so often and its TE line tells; else it is not wired`;

/** The numbers in an option's text. */
export function parsed(text, pattern, option) {
    const match = pattern.exec(text) ?? fail(`--${option} ${text}: no such value`);
    return match.slice(1).map(Number);
}

/** What lies in flash before the power comes on. */
export function memoryFrom(image, values) {
    if (values.flash)
        return new Uint8Array(fs.readFileSync(values.flash));
    const bytes = new Uint8Array(flashBytes).fill(0xff);
    bytes.set(fs.readFileSync(image));
    if (values.settings && !values['wired-only'])
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

/** Of a board: nothing if it is to have the usual one. */
export function chipNumber({ 'chip-number': text }) {
    if (text === undefined)
        return undefined;
    if (!/^[0-9a-f]{16}$/i.test(text))
        fail(`--chip-number ${text}: 16 hexadecimal digits are needed`);
    return Uint8Array.from(Buffer.from(text, 'hex'));
}

function addPanel(board, settings, trace, busTime) {
    const display = board.add(new Display(settings, trace, busTime));
    return { display, bus: board.add(busFor(display)) };
}

function addBeam(board, inputs, settings) {
    const beam = board.add(new Mcp4922(settings));
    board.add(new ReadBack(inputs, settings.pins.data));
    return { display: beam, bus: beam };
}

/** A board with everything wired to it that the settings and the options tell. */
export function wiredBoard(memory, settings, values) {
    const trace = new Trace();
    const busTime = new BusTime();
    const board = new Board(memory, chipNumber(values));
    busTime.programCounter = () => board.mcu.core.PC;
    const inputs = board.add(new Inputs());
    const { display, bus } = settings.bus === 'dac' ? addBeam(board, inputs, settings)
        : addPanel(board, settings, trace, busTime);
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
    return { board, bus, busTime, display, led, log, settings, tearing, trace };
}
