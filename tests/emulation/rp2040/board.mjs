import { RP2040 } from 'rp2040js';

import { BootRom, acceptsBootBlock, bootBlockAddress, bootBlockBytes } from './boot_rom.mjs';
import { EmulationError, fail, hex } from './emulation_error.mjs';
import { FlashChip } from './flash_chip.mjs';
import { FlashInterface } from './flash_interface.mjs';
import { addRegisters } from './register_files.mjs';
import { Resets } from './resets.mjs';
import { timePio } from './timed_pio.mjs';
import { correctTimer } from './timer.mjs';
import { UsbController } from './usb_controller.mjs';

export const flashAddress = 0x10000000;
export const flashBytes = 2 * 1024 * 1024;

const flashWindow = 0x04000000;
const longestBootBlock = 1e6; // instructions
const padAfterReset = 0x56; // rp2040js has IE = 0

/**
 * A Pico: the chip, 2 MiB of flash with an image, and what is wired to it. It starts as the real one does: the boot
 * ROM checks the boot block, copies it to RAM and runs it there; all after that is what the image says.
 *
 * Whatever rp2040js warns of, and whatever would not work on hardware and is known here, ends the run.
 */
export class Board {
    /** Changes when the watchdog restarts the chip. */
    mcu;
    /** Why the run ended by itself, if it did. */
    ending;
    /** The boot block's run, the latest one: {cycles, vectors}. */
    bootBlock;
    /** What a sector takes; up to 400 ms, says its maker. */
    eraseNanos = 45e6;
    /** Called before flash changes: (offset, what will lie there). */
    onFlashOperation = () => {};
    /** How often the chip was started. */
    starts = 0;
    /** What the watchdog brought about: [nanoseconds]. */
    watchdogResets = [];
    /** Whether more went on since then than a cache that was not flushed can know. */
    #flashStale = false;

    #devices = [];
    #cyclesBefore = 0;
    #nanosPerCycle = 8;
    #restart = false;
    #interrupted = false;
    #startedAt = 0;

    /**
     * @param {Uint8Array} image what lies in flash from its beginning; the rest is empty
     * @param {Uint8Array} [chipNumber] of the flash chip
     */
    constructor(image, chipNumber) {
        if (image.length > flashBytes)
            fail(`the image has ${image.length} bytes, the flash ${flashBytes}`);
        this.mcu = new RP2040();
        this.clock = this.mcu.clock;
        this.memory = new Uint8Array(flashBytes).fill(0xff);
        this.memory.set(image);
        this.flashChip = new FlashChip(this.memory, chipNumber);
    }

    /** Wires `device` up: attach(board) is called each time the chip starts, before it runs. */
    add(device) {
        this.#devices.push(device);
        return device;
    }

    /** Emulated time since the power came on. */
    get nanos() {
        return this.clock.nanosCounter;
    }

    /** Cycles of the core since the power came on. */
    get cycles() {
        return this.#cyclesBefore + this.mcu.core.cycles;
    }

    /** Ends the run after the current instruction. */
    end(why) {
        this.ending ??= why;
        this.#interrupted = true;
    }

    /** The registers of the watchdog that its restarts leave as they are. */
    get scratch() {
        return this.#watchdog.scratchData;
    }

    passTime(nanos) {
        this.clock.tick(nanos);
    }

    /** Flash was written, or the cache flushed, without which old contents might be read. */
    setFlashStale(stale) {
        this.#flashStale = stale;
        this.#guardFlash();
    }

    /**
     * Runs until `nanos` since the power came on, or until it ends by itself.
     * @throws {EmulationError} with time and place
     */
    run(nanos) {
        const { warn, error } = console;
        console.warn = console.error = (...words) => fail(words.join(' ')); // rp2040js's SIO has no logger
        try {
            this.#run(nanos);
        } catch (problem) {
            throw this.#placed(problem);
        } finally {
            Object.assign(console, { warn, error });
        }
    }

    #run(end) {
        if (this.starts === 0)
            this.#start(new Uint8Array(0));
        while (this.nanos < end && this.ending === undefined) {
            this.#execute(end);
            if (this.#restart)
                this.#start(this.mcu.sram);
        }
    }

    /** Runs until something changes that it takes for granted; the innermost loop, so that all is at hand. */
    #execute(end) {
        const { clock } = this;
        const { core } = this.mcu;
        const nanosPerCycle = this.#nanosPerCycle;
        this.#interrupted = false;
        while (clock.nanosCounter < end && !this.#interrupted) {
            if (core.waiting && !this.#wakeUp(core, end))
                continue;
            const cycles = core.executeInstruction(); // first: in it the boot ROM may let time pass
            const after = clock.nanosCounter + cycles * nanosPerCycle;
            if (clock.nextAlarm !== null && clock.nextAlarm.nanos <= after)
                clock.tick(after - clock.nanosCounter);
            else
                clock.nanosCounter = after;
        }
    }

    /** Whether the core goes on after WFI or WFE; if not, time has passed. */
    #wakeUp(core, end) {
        if (!wakes(core)) {
            this.clock.tick(Math.min(this.#idleNanos(), end - this.nanos));
            return false;
        }
        core.waiting = false;
        core.interruptsUpdated = true;
        return true;
    }

    #idleNanos() {
        return this.clock.nextAlarm ? Math.max(this.clock.nanosToNextAlarm, 0) : Infinity;
    }

    #start(sram) {
        this.#cyclesBefore += this.starts > 0 ? this.mcu.core.cycles : 0;
        this.#restart = false;
        this.#startedAt = this.nanos;
        ++this.starts;
        const { watchdogScratch, watchdogReason } = this.#kept();
        this.clock.nextAlarm = null;
        this.mcu = new RP2040(this.clock);
        this.mcu.sram.set(sram);
        this.#build();
        this.#watchdog.scratchData.set(watchdogScratch);
        this.#watchdog.reason = watchdogReason;
        for (const device of this.#devices)
            device.attach(this);
        this.#boot();
    }

    get #watchdog() {
        return this.mcu.peripherals[0x40058];
    }

    #kept() {
        return { watchdogScratch: this.#watchdog.scratchData, watchdogReason: this.#watchdog.reason };
    }

    #build() {
        const { mcu } = this;
        const complain = (unit, message) => fail(`${unit}: ${message}`);
        mcu.logger = { debug() {}, info() {}, warn: complain, error: complain };
        this.#showFlash();
        addRegisters(mcu, () => this.setFlashStale(false));
        this.flashInterface = new FlashInterface(mcu, this.flashChip);
        this.flashInterface.onChange = () => this.#guardFlash();
        mcu.peripherals[0x18000] = this.flashInterface;
        mcu.peripherals[0x40018] = this.flashInterface.pins;
        this.rom = new BootRom(this);
        mcu.onBreak = (number) => this.#breakpoint(number);
        for (const pin of [...mcu.gpio, ...mcu.qspi])
            pin.padValue = padAfterReset;
        this.#followClock();
        this.#correctCore();
        this.#correctTimers();
        mcu.pio.forEach((pio) => timePio(mcu, pio));
        new UsbController(mcu);
        new Resets(mcu); // last, so that it sees all accesses
    }

    /** The emulator's 16 MiB become this board's, which only the boot ROM's functions change. */
    #showFlash() {
        const refuse = () => fail('a store to flash');
        this.mcu.flash = this.memory;
        this.mcu.flashView = new DataView(this.memory.buffer);
        Object.assign(this.mcu.flashView, { setUint32: refuse, setUint16: refuse });
    }

    #followClock() {
        this.mcu.addClockListener((hertz) => {
            this.#nanosPerCycle = 1e9 / hertz;
            this.#interrupted = true;
        });
        this.mcu.updateClocks(); // at first it runs from the ring oscillator; rp2040js from 125 MHz
    }

    /** A masked interrupt ends WFI, but is not taken; rp2040js takes it. */
    #correctCore() {
        const { core } = this.mcu;
        const check = core.checkForInterrupts.bind(core);
        core.checkForInterrupts = () => (core.waiting && core.PM ? wakes(core) : check());
    }

    #correctTimers() {
        const watchdog = this.#watchdog;
        watchdog.tickEnable = false;
        watchdog.onWatchdogTrigger = () => this.#watchdogFired();
        correctTimer(this.mcu, this.#startedAt);
        const write = watchdog.writeUint32.bind(watchdog);
        watchdog.writeUint32 = (offset, value) => {
            this.#checkTicks(offset, value);
            write(offset, value);
        };
    }

    #checkTicks(offset, value) {
        const TICK = 0x2c;
        const cycles = this.mcu.clocks.refFreq / 1e6;
        if (offset === TICK && value & 0x200 && (value & 0x1ff) !== cycles)
            fail(`WATCHDOG: TICK counts ${value & 0x1ff} cycles, a microsecond has ${cycles}`);
    }

    #watchdogFired() {
        this.watchdogResets.push(this.nanos);
        this.#watchdog.alarm.enable = false; // or rp2040js rings for ever
        this.#restart = true;
        this.#interrupted = true;
    }

    #boot() {
        if (!acceptsBootBlock(this.memory))
            return this.end('the boot block was refused');
        const { core, sram } = this.mcu;
        this.flashInterface.readSlowly();
        sram.set(this.memory.subarray(0, bootBlockBytes), bootBlockAddress - 0x20000000);
        core.SP = bootBlockAddress;
        core.LR = 0;
        core.PC = bootBlockAddress;
        this.#runBootBlock();
    }

    #runBootBlock() {
        const { core } = this.mcu;
        const before = core.cycles;
        this.flashInterface.writes = [];
        for (let i = 0; core.PC - bootBlockAddress >>> 0 < bootBlockBytes; ++i) {
            if (i === longestBootBlock)
                fail('the boot block does not end');
            this.clock.tick(core.executeInstruction() * this.#nanosPerCycle);
        }
        this.bootBlock = { cycles: core.cycles - before, vectors: core.VTOR };
        if ((core.PC & ~1) !== (this.memoryWord(core.VTOR + 4) & ~1) || core.SP !== this.memoryWord(core.VTOR))
            fail('the boot block does not enter the image through its vectors');
    }

    /** A word of flash, at the processor's address. */
    memoryWord(address) {
        return new DataView(this.memory.buffer).getUint32(address - flashAddress, true);
    }

    /** While code cannot be fetched, nobody may read the flash. */
    #guardFlash() {
        const { mcu } = this;
        const isOpen = this.flashInterface.isReadable() && !this.#flashStale;
        for (const name of ['readUint8', 'readUint16', 'readUint32']) {
            const read = RP2040.prototype[name];
            mcu[name] = isOpen ? read : (address) => (address - flashAddress >>> 0 < flashWindow
                ? this.#refuseFlash(address) : read.call(mcu, address)); // `delete` would make it slow for ever
        }
    }

    #refuseFlash(address) {
        fail(`flash is read at ${hex(address)}, but ${this.flashInterface.isReadable()
            ? 'its cache holds what was there before' : 'its interface is not set up for that'}`);
    }

    #breakpoint(number) {
        const place = this.mcu.core.PC - 2;
        if (place >= this.mcu.bootrom.byteLength)
            fail(`breakpoint ${number}, which is a fault without a debugger`);
        this.rom.breakpoint(number);
    }

    #placed(problem) {
        if (!(problem instanceof EmulationError))
            return problem;
        const microseconds = (this.nanos / 1000).toFixed(1);
        return new EmulationError(`${problem.message} (at ${microseconds} µs, PC ${hex(this.mcu.core.PC)})`);
    }
}

/** Whether something waits that ends WFI. */
function wakes(core) {
    return !!(core.pendingInterrupts & core.enabledInterrupts) || core.pendingSystick || core.pendingPendSV
        || core.pendingNMI;
}
