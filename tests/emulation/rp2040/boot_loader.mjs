import { descriptor, products } from './boot_loader_descriptors.mjs';
import { fail } from './emulation_error.mjs';
import { Picoboot } from './picoboot.mjs';

const attachNanos = 50e6;
const frameNanos = 1e6;
const packetNanos = 50e3;

const picobootInterface = 1;
const [massStorageIn, massStorageOut, picobootOut, picobootIn] = [1, 2, 3, 4];
const endpoints = [massStorageIn | 0x80, massStorageOut, picobootOut, picobootIn | 0x80];
const haltFeature = 0;
const nothing = new Uint8Array(0);

/** A request as one number, by which those that are known can be told. */
const kindOf = ([type, number]) => (type << 8) | number;

/**
 * The boot loader of the RP2040 at a port of a computer, and that port: what PluggedBoard asks of its host. The drive is
 * there, but never answers.
 *
 * Packets have no DATA0 and DATA1 here: the computer's own are Linux's, which USB/IP does not tell.
 */
export class BootLoader {
    /** 19 packets of 64 bytes fit into a frame; of a real one about ten were measured. */
    turnsPerFrame = 10;
    nanos = 0;

    #configuration = 0;

    /**
     * @param {FlashChip} flash
     * @param {string} chip whose boot loader it is: another one than "rp2040" is there to be refused
     */
    constructor(flash, chip = 'rp2040') {
        this.picoboot = new Picoboot(flash);
        this.product = products[chip] ?? fail(`no boot loader of the chip ${chip} is known`);
    }

    get attached() {
        return this.nanos >= attachNanos && this.nanos < this.picoboot.restartAt;
    }

    nextFrame() {
        this.#pass(frameNanos - (this.nanos % frameNanos));
    }

    reset() {
        this.#configure(0);
    }

    setAddress() {}

    /** The power goes, whatever is being done. */
    cut() {
        this.picoboot.cut();
    }

    /** A packet to the device, once: 'ack', 'nak', 'stall' or 'timeout'. */
    sendOnce(number, bytes) {
        this.#pass(packetNanos);
        if (!this.#configuration || ![massStorageOut, picobootOut].includes(number))
            return 'timeout';
        return number === massStorageOut ? 'nak' : this.#known.take(bytes);
    }

    /** A packet from the device, once: bytes, 'nak', 'stall' or 'timeout'. */
    askOnce(number) {
        this.#pass(packetNanos);
        if (!this.#configuration || ![massStorageIn, picobootIn].includes(number))
            return 'timeout';
        return number === massStorageIn ? 'nak' : this.#known.give();
    }

    /** A whole control transfer: what comes from the device, or 'stall'. */
    control(setup) {
        this.#pass(3 * packetNanos);
        const answer = this.#recipient(setup)?.(setup);
        return answer === undefined ? 'stall' : Uint8Array.from(answer).subarray(0, setup[6] | (setup[7] << 8));
    }

    /** Other chips have other commands. */
    get #known() {
        return this.product === products.rp2040 ? this.picoboot : fail('commands of this chip are not modelled');
    }

    #pass(nanos) {
        this.nanos += nanos;
        this.picoboot.passTime(this.nanos);
    }

    #configure(number) {
        this.#configuration = number;
        this.picoboot.configure();
    }

    #recipient([type]) {
        const recipients = [(setup) => this.#asDevice(setup), (setup) => this.#asInterface(setup),
            (setup) => this.#asEndpoint(setup)];
        return recipients[type & 0x1f];
    }

    #asDevice(setup) {
        const [, , low, high] = setup;
        switch (kindOf(setup)) {
        case 0x8000: // GET_STATUS
            return [0, 0];
        case 0x8006: // GET_DESCRIPTOR
            return descriptor(this.product, high, low);
        case 0x8008: // GET_CONFIGURATION
            return [this.#configuration];
        case 0x0009: // SET_CONFIGURATION
            return low <= 1 ? (this.#configure(low), nothing) : undefined;
        default:
            return undefined;
        }
    }

    #asInterface(setup) {
        const [, , , , index, , length] = setup;
        if (!this.#configuration || index > picobootInterface)
            return undefined;
        switch (kindOf(setup) | (index === picobootInterface ? 0x10000 : 0)) {
        case 0x0a1fe: // GET_MAX_LUN
            return [0];
        case 0x021ff: // MASS_STORAGE_RESET
            return nothing;
        case 0x14141: // INTERFACE_RESET
            return length === 0 ? (this.picoboot.reset(), nothing) : fail('PICOBOOT: INTERFACE_RESET has no data');
        case 0x1c142: // GET_COMMAND_STATUS
            return length === 16 ? this.picoboot.status : undefined;
        case 0x08100: // GET_STATUS
        case 0x18100:
            return [0, 0];
        default:
            return undefined;
        }
    }

    #asEndpoint(setup) {
        const [, , feature, , address] = setup;
        const isIn = (address & 0x80) !== 0;
        if (!this.#configuration || !endpoints.includes(address))
            return undefined;
        const isDrive = ![picobootOut, picobootIn | 0x80].includes(address); // which is never halted
        switch (kindOf(setup)) {
        case 0x8200: // GET_STATUS
            return [Number(!isDrive && this.picoboot.isHalted(isIn)), 0];
        case 0x0201: // CLEAR_FEATURE
            return feature === haltFeature ? (isDrive || this.picoboot.clearHalt(isIn), nothing) : undefined;
        default:
            return undefined;
        }
    }
}
