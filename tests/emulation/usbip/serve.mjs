// Boots an image of boards/pico, plugs it in, and shares it over USB/IP; usage tells how.
import fs from 'node:fs';
import readline from 'node:readline';
import { setImmediate as otherThings, setTimeout as sleep } from 'node:timers/promises';
import { parseArgs } from 'node:util';

import { Board } from '../rp2040/board.mjs';
import { EmulationError, fail } from '../rp2040/emulation_error.mjs';
import { report } from '../rp2040/report.mjs';
import { readSettings } from '../rp2040/settings.mjs';
import { UsbHost, asLinux } from '../rp2040/usb_host.mjs';
import { chipNumber, memoryFrom, wiredBoard, wiringOptions, wiringUsage } from '../rp2040/wired_board.mjs';
import { Pace } from './pace.mjs';
import { PluggedBoard } from './plugged_board.mjs';
import { UsbIpServer } from './server.mjs';

const usage = `usage: node serve.mjs IMAGE.bin [OPTION]...

  --port PORT             where it listens, on this computer alone (default: any)
  --trace FILE            for "record": what happened at the display's pins
  --report FILE           for "record": what else there is to tell
${wiringUsage}

Without --settings nothing is wired to the board. Prints "port PORT" when the board can be found, then obeys commands, a
line each, and answers with their name when they are done:

  record                  writes trace and report, from the latest power-on until now
  unplug                  takes the power away
  plug                    gives it back; the flash is as it was
  freeze                  stops the board's time: it takes and gives nothing more
  thaw                    lets it go on
  unplug after COUNT      when the board has taken so many more reports; freeze as well
  end                     or no more input: the program ends

Emulated time passes no faster than time. Exits with 1 when something happened that would not work on hardware.`;

const options = {
    ...wiringOptions,
    port: { type: 'string', default: '0' }, trace: { type: 'string' }, report: { type: 'string' },
};

const attachNanos = 1000e6;
const longestTurn = 5; // milliseconds, until connections are looked after

/** A board that can be unplugged, and everything that is wired to it. */
class Bench {
    hasEnded = false;
    /** Why the board cannot go on. */
    failure;

    #pace;
    #isFrozen = false;
    #later = { count: Infinity, act() {} };

    constructor(image, values) {
        this.values = values;
        this.memory = memoryFrom(image, values);
        this.settings = values.settings && readSettings(fs.readFileSync(values.settings));
        this.server = new UsbIpServer(this);
        this.plug();
    }

    // What UsbIpServer asks of a device.

    get identity() {
        return this.plugged?.identity;
    }

    submit(transfer) {
        this.plugged?.submit(transfer);
    }

    cancel(transfer) {
        this.plugged?.cancel(transfer);
    }

    // What the commands ask.

    plug() {
        this.wired = this.settings ? wiredBoard(this.memory, this.settings, this.values)
            : { board: new Board(this.memory, chipNumber(this.values)) };
        this.memory = this.wired.board.memory;
        this.plugged = new PluggedBoard(new UsbHost(this.wired.board, asLinux));
        this.plugged.onGone = () => this.server.unplug();
        this.#later.count = Infinity;
        this.#pace = new Pace();
    }

    freeze() {
        this.#isFrozen = true;
        this.#later.count = Infinity;
    }

    thaw() {
        this.#isFrozen = false;
    }

    unplug() {
        this.plugged = undefined;
        this.server.unplug();
    }

    /** Does `act` when the board has taken `count` more reports. */
    after(count, act) {
        this.#later = { count: this.plugged.taken + count, act };
    }

    record() {
        if (!this.wired.trace || !this.values.trace || !this.values.report)
            fail('record: needs --settings, --trace and --report');
        this.wired.trace.write(this.values.trace);
        fs.writeFileSync(this.values.report, JSON.stringify(report(this.wired, this.failure), null, 1));
    }

    end() {
        this.hasEnded = true;
    }

    /** Lets time pass until there is something else to do. */
    async turn() {
        const end = performance.now() + longestTurn;
        let wait = this.#wait();
        while (wait === 0 && performance.now() < end) {
            this.#frame();
            if (this.plugged?.taken >= this.#later.count)
                this.#later.act();
            wait = this.#wait();
        }
        await (wait > 0 ? sleep(Math.min(wait, longestTurn)) : otherThings());
    }

    /** A board that ends by itself, as one in its boot loader does, is none that this can share. */
    #frame() {
        try {
            this.plugged.frame();
        } catch (problem) {
            if (this.wired.board.ending === undefined)
                throw problem;
            this.unplug();
        }
    }

    #wait() {
        return this.plugged && !this.#isFrozen ? this.#pace.wait(this.wired.board.nanos) : longestTurn;
    }
}

async function untilFound(bench) {
    while (!bench.identity) {
        if (bench.wired.board.nanos > attachNanos)
            fail('the board does not plug itself in');
        await bench.turn();
    }
}

/** Obeys what comes while the board runs. */
async function obey(bench, line) {
    const [, command, count] = /^(record|unplug|plug|freeze|thaw|end)(?: after (\d+))?$/.exec(line)
        ?? fail(`${line} is no command: ${usage}`);
    if (count)
        bench.after(Number(count), () => bench[command]());
    else
        bench[command]();
    if (line === 'plug')
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
    if (!image)
        fail(usage);
    const bench = new Bench(image, values);
    try {
        await serve(bench, Number(values.port));
    } catch (problem) {
        bench.failure = problem.message;
        bench.server.close();
        if (bench.wired.trace && values.trace && values.report)
            bench.record();
        throw problem;
    }
}

main().then(() => process.exit(0), (problem) => {
    console.error(problem instanceof EmulationError ? problem.message : problem);
    process.exit(1);
});
