import { BasePeripheral } from 'rp2040js';

import { fail, hex } from './emulation_error.mjs';

const ADDR_ENDP = 0x00;
const MAIN_CTRL = 0x40;
const SIE_CTRL = 0x4c;
const SIE_STATUS = 0x50;
const BUFF_STATUS = 0x58;
const EP_STALL_ARM = 0x68;
const USB_MUXING = 0x74;
const USB_PWR = 0x78;
const INTE = 0x90;
const INTS = 0x98;

const USBCTRL_IRQ = 5;
const CLK_USB_CTRL_ENABLE = 1 << 11;
const needed = new Map([[USB_MUXING, 1 | (1 << 3)], [USB_PWR, (1 << 2) | (1 << 3)]]); // to the PHY; VBUS is there
const CONTROLLER_EN = 1;
const PULLUP_EN = 1 << 16;
const EP0_INT_1BUF = 1 << 29;

const SUSPENDED = 1 << 4;
const RESUME = 1 << 11;
const SETUP_REC = 1 << 17;
const BUS_RESET = 1 << 19;
const clearedByWriting = SUSPENDED | RESUME | SETUP_REC | BUS_RESET;

/** Which interrupt a bit of SIE_STATUS brings. */
const interrupts = [[BUS_RESET, 12], [SUSPENDED, 14], [RESUME, 15], [SETUP_REC, 16]];
const INT_BUFF_STATUS = 1 << 4;

// The memory of the unit: what is said about endpoints, about packets, and the packets
const packetControls = 0x80;
const packets = 0x100;
const memoryBytes = 0x1000;
const longestPacket = 64;

const DOUBLE_BUFFERED = 1 << 30;
const INTERRUPT_PER_BUFF = 1 << 29;
const interruptType = 3;

const AVAILABLE_0 = 1 << 10;
const STALL = 1 << 11;
const PID_0 = 1 << 13;
const FULL_0 = 1 << 15;
const LENGTH_0 = 0x3ff;
const known = AVAILABLE_0 | STALL | PID_0 | FULL_0 | LENGTH_0;

/** What must lie between what is said about a packet and that it is available: 12 cycles at 125 MHz. */
const nanosToSee = 96;

/**
 * The chip's unit for USB, as a device: what rp2040js has answers no token of a host. A packet stays with the unit
 * until the host's token, and touching it meanwhile ends the run, as do other things that would not work on a chip.
 * Two buffers for an endpoint, isochronous ones, errors on the line and the host's side are not modelled.
 *
 * An endpoint is {number, isIn}.
 */
export class UsbController extends BasePeripheral {
    #values = new Map([[ADDR_ENDP, 0], [MAIN_CTRL, 0], [SIE_CTRL, 0], [SIE_STATUS, 0], [BUFF_STATUS, 0],
        [EP_STALL_ARM, 0], [USB_MUXING, 0], [USB_PWR, 0], [INTE, 0]]);
    /** What was last said about each packet, and when: [word, nanoseconds]. */
    #said = Array.from({ length: 32 }, () => [0, -Infinity]);
    /** The packet that is on the line. */
    #onLine;

    /** Takes the place of the emulator's in `mcu`. */
    constructor(mcu) {
        super(mcu, 'USB');
        mcu.usbCtrl = this;
        mcu.peripherals[0x50110] = this;
    }

    /** Whether the host sees that something is plugged in. */
    get attached() {
        return this.#isClocked() && this.#has(MAIN_CTRL, CONTROLLER_EN) && this.#has(SIE_CTRL, PULLUP_EN)
            && [...needed].every(([register, bits]) => this.#has(register, bits));
    }

    get address() {
        return this.#values.get(ADDR_ENDP) & 0x7f;
    }

    readUint32(offset) {
        if (offset === INTS)
            return this.#raised() & this.#values.get(INTE);
        return this.#values.get(offset) ?? super.readUint32(offset);
    }

    writeUint32(offset, value) {
        if (!this.#values.has(offset))
            return super.writeUint32(offset, value);
        if (offset === SIE_STATUS)
            this.#clear(SIE_STATUS, this.rawWriteValue & clearedByWriting);
        else if (offset === BUFF_STATUS)
            this.#clear(BUFF_STATUS, this.rawWriteValue);
        else
            this.#values.set(offset, value >>> 0);
        this.#interrupt();
    }

    /** The core has written a word of the memory. */
    DPRAMUpdated(offset, value) {
        if (offset >= packetControls && offset < packets)
            this.#say((offset - packetControls) / 4, value >>> 0);
        else if (offset >= packets)
            this.#checkOwner(offset);
    }

    // What a host does on the line.

    /** Holds both lines low. */
    reset() {
        this.#onLine = undefined;
        this.#raise(BUS_RESET);
    }

    suspend() {
        this.#raise(SUSPENDED);
    }

    resume() {
        this.#raise(RESUME);
    }

    /** @returns whether a device with that address is there to answer */
    hears(address) {
        return this.attached && this.address === address;
    }

    /** A setup is always taken. */
    setup(packet) {
        this.rp2040.usbDPRAM.set(packet, 0);
        this.#values.set(EP_STALL_ARM, 0);
        this.#raise(SETUP_REC);
    }

    /**
     * A token has come.
     * @returns 'timeout' (there is no such endpoint), 'stall', 'nak', or 'ready': finishIn() or finishOut() follows
     */
    token(endpoint) {
        if (!this.#isEnabled(endpoint))
            return 'timeout';
        const word = this.#word(endpoint);
        if (word & STALL && (endpoint.number !== 0 || this.#has(EP_STALL_ARM, endpoint.isIn ? 1 : 2)))
            return 'stall';
        if (!(word & AVAILABLE_0))
            return 'nak';
        if (!!(word & FULL_0) !== endpoint.isIn)
            fail(`USB: the packet of ${name(endpoint)} is given away ${endpoint.isIn ? 'empty' : 'full'}`);
        this.#onLine = endpoint;
        return 'ready';
    }

    /** Of the packet that an endpoint has to give. */
    lengthOf(endpoint) {
        return this.#word(endpoint) & LENGTH_0;
    }

    /** @returns {{pid: number, bytes: Uint8Array}} of an endpoint that is ready, whose packet has arrived */
    finishIn(endpoint) {
        const word = this.#word(endpoint);
        const at = this.#place(endpoint);
        const bytes = this.rp2040.usbDPRAM.slice(at, at + (word & LENGTH_0));
        this.#finish(endpoint, word & ~(AVAILABLE_0 | FULL_0));
        return { pid: word & PID_0 ? 1 : 0, bytes };
    }

    /** `bytes` have arrived as DATA`pid` at an endpoint that is ready. */
    finishOut(endpoint, pid, bytes) {
        const word = this.#word(endpoint);
        if (pid !== (word & PID_0 ? 1 : 0))
            fail(`USB: DATA${pid} comes to ${name(endpoint)}, which waits for the other one`);
        if (bytes.length > (word & LENGTH_0))
            fail(`USB: ${bytes.length} bytes come to ${name(endpoint)}, which has room for ${word & LENGTH_0}`);
        this.rp2040.usbDPRAM.set(bytes, this.#place(endpoint));
        this.#finish(endpoint, (word & ~(AVAILABLE_0 | LENGTH_0)) | FULL_0 | bytes.length);
    }

    #isClocked() {
        const { clocks, pllUsb } = this.rp2040;
        return !!(clocks.usbCtrl & CLK_USB_CTRL_ENABLE) && pllUsb.frequency === 48e6;
    }

    #has(register, bits) {
        return (this.#values.get(register) & bits) === bits;
    }

    #clear(register, bits) {
        this.#values.set(register, this.#values.get(register) & ~bits);
    }

    #raise(status) {
        this.#values.set(SIE_STATUS, this.#values.get(SIE_STATUS) | status);
        this.#interrupt();
    }

    #raised() {
        const line = interrupts.filter(([status]) => this.#has(SIE_STATUS, status));
        return line.reduce((bits, [, bit]) => bits | (1 << bit), this.#values.get(BUFF_STATUS) ? INT_BUFF_STATUS : 0);
    }

    #interrupt() {
        this.rp2040.setInterrupt(USBCTRL_IRQ, (this.#raised() & this.#values.get(INTE)) !== 0);
    }

    #say(index, word) {
        const [before, since] = this.#said[index];
        const now = this.rp2040.clock.nanos;
        const who = name(endpointAt(index));
        if (this.#onLine && indexOf(this.#onLine) === index)
            fail(`USB: the packet of ${who} is changed while it is on the line`);
        if (word & ~known)
            fail(`USB: ${hex(word)} for the packet of ${who} is not modelled`);
        if ((word & LENGTH_0) > longestPacket)
            fail(`USB: a packet of ${word & LENGTH_0} bytes for ${who}`);
        if (word & AVAILABLE_0 && (word & ~AVAILABLE_0) !== before)
            fail(`USB: the packet of ${who} is available in the same write as what is said about it`);
        if (word & AVAILABLE_0 && Math.round(now - since) < nanosToSee)
            fail(`USB: the packet of ${who} is available ${Math.round(now - since)} ns after what is said about it`);
        this.#said[index] = [word, now];
    }

    /** A packet that the unit has is not to be written. */
    #checkOwner(offset) {
        const owner = this.#said.findIndex(([word], index) => {
            const at = word & AVAILABLE_0 ? this.#place(endpointAt(index)) : memoryBytes;
            return offset + 4 > at && offset < at + longestPacket;
        });
        if (owner >= 0)
            fail(`USB: the packet of ${name(endpointAt(owner))} is written while the unit has it`);
    }

    #control(endpoint) {
        return this.rp2040.usbDPRAMView.getUint32(4 * indexOf(endpoint), true);
    }

    #isEnabled(endpoint) {
        if (endpoint.number === 0)
            return true;
        const control = this.#control(endpoint);
        if (!(control >>> 31))
            return false;
        const at = this.#place(endpoint);
        if (control & DOUBLE_BUFFERED || ((control >>> 26) & 3) !== interruptType || at < packets + 2 * longestPacket)
            fail(`USB: ${name(endpoint)} is set up as ${hex(control)}`);
        return true;
    }

    #place(endpoint) {
        return endpoint.number === 0 ? packets : this.#control(endpoint) & 0xffc0;
    }

    #tells(endpoint) {
        return endpoint.number === 0 ? this.#has(SIE_CTRL, EP0_INT_1BUF)
            : (this.#control(endpoint) & INTERRUPT_PER_BUFF) !== 0;
    }

    #word(endpoint) {
        return this.#said[indexOf(endpoint)][0];
    }

    #finish(endpoint, word) {
        const index = indexOf(endpoint);
        this.#onLine = undefined;
        this.#said[index] = [word, this.rp2040.clock.nanos];
        this.rp2040.usbDPRAMView.setUint32(packetControls + 4 * index, word, true);
        if (this.#tells(endpoint))
            this.#values.set(BUFF_STATUS, this.#values.get(BUFF_STATUS) | (1 << index));
        this.#interrupt();
    }
}

function indexOf({ number, isIn }) {
    return 2 * number + (isIn ? 0 : 1);
}

function endpointAt(index) {
    return { number: index >>> 1, isIn: index % 2 === 0 };
}

function name({ number, isIn }) {
    return `endpoint ${number} ${isIn ? 'IN' : 'OUT'}`;
}
