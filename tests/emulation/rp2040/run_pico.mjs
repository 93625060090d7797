// Boots an image of boards/pico in rp2040js and records what happens at the pins; usage() tells how.
import fs from 'node:fs';
import { parseArgs } from 'node:util';

import { EmulationError, fail } from './emulation_error.mjs';
import { LinkTraffic } from './link_traffic.mjs';
import { report } from './report.mjs';
import { readSettings } from './settings.mjs';
import { UsbTraffic } from './usb_traffic.mjs';
import { memoryFrom, wiredBoard } from './wired_board.mjs';

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
  --link STORY            a computer speaks the link with it, as a story of ../link_stories.mjs has it
  --file NAME=FILE        for the story; may be repeated
  --flash FILE            all of the flash: IMAGE and what else would be placed there are not looked at
  --keep-flash FILE       writes the flash there at the end
  --erase-time MILLISECONDS  that a sector takes (default 45)
  --te MICROSECONDS       the glass shows a picture every so often and its TE line tells; else it is not wired

Exits with 1 when something happened that would not work on hardware or that the emulator cannot do: the report says
what. "ending" in the report tells why it ended.`;

const options = {
    settings: { type: 'string' }, 'wired-only': { type: 'boolean' }, scene: { type: 'string' },
    patch: { type: 'string', multiple: true, default: [] }, trace: { type: 'string' }, report: { type: 'string' },
    for: { type: 'string', default: '1000' }, frames: { type: 'string' }, te: { type: 'string' },
    usb: { type: 'boolean' }, link: { type: 'string' }, file: { type: 'string', multiple: true, default: [] },
    flash: { type: 'string' }, 'keep-flash': { type: 'string' }, 'erase-time': { type: 'string' },
    'hold-data': { type: 'string' }, address: { type: 'string' },
    absent: { type: 'string', multiple: true, default: [] },
    press: { type: 'string', multiple: true, default: [] }, knob: { type: 'string', multiple: true, default: [] },
};

/** What lets time pass: the board alone, or a computer with it. */
function runner(wired, settings, values) {
    if (values.link)
        return new LinkTraffic(wired, settings, values);
    return values.usb ? new UsbTraffic(wired.board) : wired.board;
}

function run(wired, milliseconds) {
    try {
        wired.usb.run(milliseconds * 1e6);
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
    if (values['erase-time'])
        wired.board.eraseNanos = Number(values['erase-time']) * 1e6;
    wired.usb = runner(wired, settings, values);
    const failure = run(wired, Number(values.for));
    if (values['keep-flash'])
        fs.writeFileSync(values['keep-flash'], wired.board.memory);
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
