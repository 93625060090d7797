// Boots an image of boards/pico in rp2040js and records what happens at the pins; usage tells how.
import fs from 'node:fs';
import { parseArgs } from 'node:util';

import { EmulationError, fail } from './emulation_error.mjs';
import { LinkTraffic } from './link_traffic.mjs';
import { report } from './report.mjs';
import { readSettings } from './settings.mjs';
import { UsbTraffic } from './usb_traffic.mjs';
import { memoryFrom, wiredBoard, wiringOptions, wiringUsage } from './wired_board.mjs';

const usage = `usage: node run_pico.mjs IMAGE.bin --settings RECORD --trace FILE --report FILE [OPTION]...

${wiringUsage}
  --for MILLISECONDS      ends after that much emulated time (default 1000)
  --frames COUNT          ends after so many lines "F …" of the log
  --usb                   a computer sets the board up, and sends it a report every millisecond
  --link STORY            a computer speaks the link with it, as a story of ../link_stories.mjs has it
  --file NAME=FILE        for the story; may be repeated
  --points FILE           what a beam has shown, 16 bytes for each point (mcp4922.mjs)
  --keep-flash FILE       writes the flash there at the end
  --erase-time MILLISECONDS  that a sector takes (default 45)

Exits with 1 when something happened that would not work on hardware or that the emulator cannot do: the report says
what. "ending" in the report tells why it ended.`;

const options = {
    ...wiringOptions,
    trace: { type: 'string' }, report: { type: 'string' },
    for: { type: 'string', default: '1000' }, frames: { type: 'string' },
    usb: { type: 'boolean' }, link: { type: 'string' }, file: { type: 'string', multiple: true, default: [] },
    points: { type: 'string' }, 'keep-flash': { type: 'string' }, 'erase-time': { type: 'string' },
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
    if (values.points)
        fs.writeFileSync(values.points, wired.display.points());
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
