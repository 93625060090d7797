// Boots an image of boards/pico, plugs it in, and shares it over USB/IP; usage tells how.
import readline from 'node:readline';
import { parseArgs } from 'node:util';

import { EmulationError, fail } from '../rp2040/emulation_error.mjs';
import { wiringOptions, wiringUsage } from '../rp2040/wired_board.mjs';
import { Bench } from './bench.mjs';

const usage = `usage: node serve.mjs IMAGE.bin | --blank [OPTION]...

  --blank                 nothing lies in flash: it begins in its boot loader
  --port PORT             where it listens, on this computer alone (default: any)
  --trace FILE            for "record": what happened at the display's pins
  --report FILE           for "record": what else there is to tell
  --keep-flash FILE       for "keep": all of the flash
  --commands FILE         for "keep": which commands its boot loader was given, in JSON
  --stuck OFFSET=BITS     these bits of a byte of flash read as 0 whatever is done; may be repeated
  --chip CHIP             whose boot loader it says it has: rp2040, or rp2350, which takes no commands here
${wiringUsage}

Without --settings nothing is wired to the board. Prints "port PORT" when the board can be found, then obeys commands, a
line each, and answers with their name when they are done:

  record                  writes trace and report, from the latest power-on until now
  keep                    writes the flash, and the commands since the keep before
  unplug                  takes the power away; flash that was being changed is spoiled
  plug                    gives it back; the flash is as it was
  bootsel                 the same with the board's button held: it is in its boot loader
  freeze                  stops the board's time: it takes and gives nothing more
  thaw                    lets it go on
  unplug after COUNT      when the board has taken so many more reports, or packets for its boot loader; freeze as well
  end                     or no more input: the program ends

A board whose firmware wants the boot loader, or which has nothing in flash that can be run, unplugs itself and comes back
as the boot loader; one that this restarts comes back with what lies in flash then.

Emulated time passes no faster than time. Exits with 1 when something happened that would not work on hardware.`;

const options = {
    ...wiringOptions,
    blank: { type: 'boolean' }, port: { type: 'string', default: '0' }, trace: { type: 'string' },
    report: { type: 'string' }, 'keep-flash': { type: 'string' }, commands: { type: 'string' },
    chip: { type: 'string' }, stuck: { type: 'string', multiple: true, default: [] },
};

const attachNanos = 1000e6;

async function untilFound(bench) {
    while (!bench.identity) {
        if (bench.plugged.host.nanos > attachNanos)
            fail('the board does not plug itself in');
        await bench.turn();
    }
}

/** Obeys what comes while the board runs. */
async function obey(bench, line) {
    const [, command, count] = /^(record|keep|unplug|plug|bootsel|freeze|thaw|end)(?: after (\d+))?$/.exec(line)
        ?? fail(`${line} is no command: ${usage}`);
    if (count)
        bench.after(Number(count), () => bench[command]());
    else
        bench[command]();
    if (line === 'plug' || line === 'bootsel')
        await untilFound(bench);
    console.log(line);
}

async function serve(bench, port) {
    const lines = [];
    const input = readline.createInterface({ input: process.stdin });
    input.on('line', (line) => lines.push(line)).on('close', () => lines.push('end'));
    await untilFound(bench);
    console.log(`port ${await bench.server.listen(port)}`);
    while (!bench.hasEnded)
        await (lines.length > 0 ? obey(bench, lines.shift()) : bench.turn());
    bench.server.close();
    input.close();
}

async function main() {
    const { values, positionals: [image] } = parseArgs({ options, allowPositionals: true });
    if (!image === !values.blank)
        fail(usage);
    const bench = new Bench(image, values);
    try {
        await serve(bench, Number(values.port));
    } catch (problem) {
        bench.failure = problem.message;
        bench.server.close();
        if (bench.wired?.trace && values.trace && values.report)
            bench.record();
        throw problem;
    }
}

main().then(() => process.exit(0), (problem) => {
    console.error(problem instanceof EmulationError ? problem.message : problem);
    process.exit(1);
});
