/**
 * Makes the emulator's PIO run by the emulated clock: instructions take the cycles of their machine's clock divider
 * and their delays. rp2040js runs it from a timer of the host, all machines whether enabled or not, without dividers
 * and delays.
 *
 * A machine that waits for its FIFO, or for a flag, goes on at its next cycle after the word has come or the flag was
 * set, as the real one does.
 */
export function timePio(mcu, pio) {
    pio.run = () => {};
    const machines = pio.machines.map((machine) => new TimedMachine(mcu, pio, machine));
    pio.irqUpdated = () => { // rp2040js's lets waiting machines go on at once
        pio.checkInterrupts();
        for (const machine of machines)
            machine.heed();
    };
    const write = pio.writeUint32.bind(pio);
    pio.writeUint32 = (offset, value) => {
        write(offset, value);
        pio.checkChangedPins(); // an instruction may have been executed by hand
        for (const machine of machines)
            machine.follow();
    };
}

class TimedMachine {
    #running = false;
    #start = 0;
    #ticks = 0; // of the machine's clock since #start
    #starved = false;

    constructor(mcu, pio, machine) {
        this.mcu = mcu;
        this.pio = pio;
        this.machine = machine;
        this.alarm = mcu.clock.createAlarm(() => this.#step());
        machine.clkDivRestart = () => this.#align(); // rp2040js only warns
        machine.writeFIFO = (value) => this.#take(value);
    }

    /** The machine may have been enabled or stopped. */
    follow() {
        if (this.#running === this.machine.enabled)
            return;
        this.#running = this.machine.enabled;
        this.#starved = false;
        this.alarm.cancel();
        if (this.#running) {
            this.#align();
            this.#wait(1);
        }
    }

    get #cycleNanos() {
        return 1e9 / this.mcu.clkSys;
    }

    /** Cycles of the chip for one of the machine. */
    get #divider() {
        const { clockDivInt, clockDivFrac } = this.machine;
        return (clockDivInt || 65536) + clockDivFrac / 256;
    }

    #align() {
        this.#start = this.mcu.clock.nanosCounter;
        this.#ticks = 0;
    }

    /** With a divider that is no whole number some of the machine's cycles are a cycle of the chip longer. */
    #wait(ticks) {
        this.#ticks += ticks;
        const cycles = Math.floor(this.#ticks * this.#divider);
        this.alarm.schedule(Math.max(this.#start + cycles * this.#cycleNanos - this.mcu.clock.nanosCounter, 0));
    }

    #step() {
        const { machine } = this;
        const before = machine.cycles;
        if (machine.waiting)
            machine.checkWait();
        else
            machine.step();
        this.pio.checkChangedPins();
        this.#starved = machine.waiting && (waitsForFlag(machine) || machine.txFIFO.empty && isStarved(machine));
        if (!this.#starved)
            this.#wait(Math.max(machine.cycles - before, 1));
    }

    /** As StateMachine.writeFIFO, but the word is taken at the machine's next cycle and not at once. */
    #take(value) {
        const { machine } = this;
        if (machine.txFIFO.full) {
            this.pio.fdebug |= FDEBUG_TXOVER << machine.index;
            return;
        }
        machine.txFIFO.push(value);
        this.pio.txStall &= ~(FDEBUG_TXSTALL << machine.index);
        machine.updateDMATx();
        this.pio.checkInterrupts();
        if (this.#starved && !waitsForFlag(machine))
            this.#resume();
    }

    /** A flag has changed. */
    heed() {
        if (this.#starved && waitsForFlag(this.machine) && this.pio.irq & (1 << this.machine.waitIndex))
            this.#resume();
    }

    #resume() {
        this.#starved = false;
        const cycles = (this.mcu.clock.nanosCounter - this.#start) / this.#cycleNanos;
        const passed = Math.floor(cycles / this.#divider) + 1;
        this.#wait(Math.max(passed - this.#ticks, 1));
    }
}

const FDEBUG_TXOVER = 1 << 16;
const FDEBUG_TXSTALL = 1 << 24;

/** Whether a machine that waits does so for a flag to be set. */
function waitsForFlag(machine) {
    const flag = 4; // rp2040js's WaitType.IRQ
    return machine.waitType === flag && machine.waitPolarity;
}

/** Whether a machine that waits does so for a word to send. */
function isStarved(machine) {
    const pull = 3; // rp2040js's WaitType.txFIFO
    const out = 5; // and WaitType.Out
    return machine.waitType === pull || machine.waitType === out;
}
