import fs from 'node:fs';
import { setImmediate as otherThings, setTimeout as sleep } from 'node:timers/promises';

import { Board, flashBytes } from '../rp2040/board.mjs';
import { BootLoader } from '../rp2040/boot_loader.mjs';
import { fail } from '../rp2040/emulation_error.mjs';
import { FlashChip } from '../rp2040/flash_chip.mjs';
import { report } from '../rp2040/report.mjs';
import { readSettings } from '../rp2040/settings.mjs';
import { UsbHost, asLinux } from '../rp2040/usb_host.mjs';
import { chipNumber, memoryFrom, parsed, wiredBoard } from '../rp2040/wired_board.mjs';
import { Pace } from './pace.mjs';
import { PluggedBoard } from './plugged_board.mjs';
import { UsbIpServer } from './server.mjs';

const longestTurn = 5; // milliseconds, until connections are looked after

/**
 * A board that can be unplugged, and everything that is wired to it. It runs what lies in its flash, or the boot loader:
 * when nothing can be run, when the firmware wants it, or when its button is held.
 */
export class Bench {
    hasEnded = false;
    /** Why the board cannot go on. */
    failure;
    /** What runs, unless it is the boot loader. */
    wired;
    /** What boot loaders were told since the latest keep(), as of Picoboot. */
    commands = [];

    #pace;
    #isFrozen = false;
    #takenBefore = 0;
    #later = { count: Infinity, act() {} };

    /** @param {string | undefined} image nothing if the flash is empty */
    constructor(image, values) {
        this.values = values;
        this.memory = image ? memoryFrom(image, values) : new Uint8Array(flashBytes).fill(0xff);
        this.settings = values.settings && readSettings(fs.readFileSync(values.settings));
        this.stuck = values.stuck.map((text) => parsed(text, /^(\w+)=(\w+)$/, 'stuck'));
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
        this.unplug();
        this.#later.count = Infinity;
        this.#runFlash();
    }

    bootsel() {
        this.unplug();
        this.#later.count = Infinity;
        this.#runBootLoader();
    }

    freeze() {
        this.#isFrozen = true;
        this.#later.count = Infinity;
    }

    thaw() {
        this.#isFrozen = false;
    }

    unplug() {
        this.plugged?.host.cut?.();
        this.#leave();
    }

    /** Does `act` when the board has taken `count` more packets. */
    after(count, act) {
        this.#later = { count: this.#taken + count, act };
    }

    record() {
        if (!this.wired?.trace || !this.values.trace || !this.values.report)
            fail('record: needs --settings, --trace and --report, and a board that is not in its boot loader');
        this.wired.trace.write(this.values.trace);
        fs.writeFileSync(this.values.report, JSON.stringify(report(this.wired, this.failure), null, 1));
    }

    /** For tests that look at the flash, and at what its boot loader was told. */
    keep() {
        if (!this.values['keep-flash'] || !this.values.commands)
            fail('keep: needs --keep-flash and --commands');
        fs.writeFileSync(this.values['keep-flash'], this.memory);
        fs.writeFileSync(this.values.commands, JSON.stringify(this.commands));
        this.commands.length = 0;
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
            if (this.#taken >= this.#later.count)
                this.#later.act();
            wait = this.#wait();
        }
        await (wait > 0 ? sleep(Math.min(wait, longestTurn)) : otherThings());
    }

    get #taken() {
        return this.#takenBefore + (this.plugged?.taken ?? 0);
    }

    #runFlash() {
        this.wired = this.settings ? wiredBoard(this.memory, this.settings, this.values)
            : { board: new Board(this.memory, chipNumber(this.values)) };
        const { board } = this.wired;
        this.memory = board.memory;
        this.#wearOut(board.flashChip);
        this.#connect(new UsbHost(board, asLinux));
        this.plugged.onGone = () => this.server.unplug();
    }

    #runBootLoader() {
        this.wired = undefined;
        const chip = new FlashChip(this.memory);
        this.#wearOut(chip);
        const bootLoader = new BootLoader(chip, this.values.chip);
        bootLoader.picoboot.told = this.commands;
        this.#connect(bootLoader);
        this.plugged.onGone = () => {
            this.#leave();
            this.#runFlash();
        };
    }

    #wearOut(chip) {
        this.stuck.forEach(([offset, mask]) => chip.stick(offset, mask));
    }

    #connect(host) {
        this.plugged = new PluggedBoard(host);
        this.#pace = new Pace();
    }

    #leave() {
        this.#takenBefore = this.#taken;
        this.plugged = undefined;
        this.server.unplug();
    }

    /** A board ends by itself when the ROM's boot loader takes over. */
    #frame() {
        try {
            this.plugged.frame();
        } catch (problem) {
            if (this.wired?.board.ending === undefined)
                throw problem;
            this.#leave();
            this.#runBootLoader();
        }
    }

    #wait() {
        return this.plugged && !this.#isFrozen ? this.#pace.wait(this.plugged.host.nanos) : longestTurn;
    }
}
