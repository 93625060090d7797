import { flashAddress } from './board.mjs';
import { fail, hex } from './emulation_error.mjs';
import { pageBytes, sectorBytes } from './flash_chip.mjs';

const magic = 0x431fd10b;
const commandBytes = 32;
const packetBytes = 64;
const eraseNanosPerSector = 45e6;
const programNanosPerPage = 0.4e6;

const rom = [0, 8191];
const ram = [0x20000000, 0x20042000];
const flash = [flashAddress, 0x20000000];

/** How a command has ended, for GET_COMMAND_STATUS. */
export const CommandStatus = {
    ok: 0, unknownCommand: 1, invalidCommandLength: 2, invalidTransferLength: 3, invalidAddress: 4, badAlignment: 5,
    rebooting: 7,
};

/** Their numbers, and how many bytes of arguments they have. */
const commands = new Map([
    [0x01, ['EXCLUSIVE_ACCESS', 1]], [0x02, ['REBOOT', 12]], [0x03, ['FLASH_ERASE', 8]], [0x84, ['READ', 8]],
    [0x05, ['WRITE', 8]], [0x06, ['EXIT_XIP', 0]], [0x07, ['ENTER_CMD_XIP', 0]], [0x08, ['EXEC', 4]],
    [0x09, ['VECTORIZE_FLASH', 4]],
]);
const isRange = (name) => name === 'READ' || name === 'WRITE';

const isWithin = ([first, last], address, count) => address >= first && address + count <= last;

/** A command as it arrives, or undefined if these bytes are none. */
function parsed(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    if (bytes.length !== commandBytes || view.getUint32(0, true) !== magic)
        return undefined;
    const argumentBytes = view.getUint8(9);
    return {
        token: view.getUint32(4, true), id: view.getUint8(8), argumentBytes, reserved: view.getUint16(10, true),
        transferBytes: view.getUint32(12, true),
        given: argumentBytes === 1 ? [view.getUint8(16)] : [16, 20, 24].map((at) => view.getUint32(at, true)),
    };
}

/**
 * The protocol of the RP2040's boot loader: commands, their data and their ends on two endpoints, and what they do to the
 * flash chip. It is what the ROM's published source does (usb_boot_device.c and async_task.c of
 * raspberrypi/pico-bootrom-rp2040, tag b2), but ends the run where the ROM would quietly do something else than it was
 * told, or nothing, and acknowledge it.
 *
 * Not modelled: RAM and ROM as places to read and write, EXEC, VECTORIZE_FLASH, a start at an address of the computer's
 * choice, and time that reading the flash takes.
 */
export class Picoboot {
    /** What it was told: [name, argument...]. */
    told = [];
    /** When the chip restarts, if it was told to. */
    restartAt = Infinity;

    #nanos = 0;
    #status = { token: 0, code: CommandStatus.ok, id: 0, inProgress: false };
    #out = { isHalted: false, awaits: undefined }; // 'command', 'data' or 'acknowledgement'
    #in = { isHalted: false, offers: undefined }; // 'data' or 'acknowledgement'
    #command;
    #lastToken;
    #chunk = [];
    #passed = 0;
    #work;
    #isExclusive = false;
    /** Whether what the flash chip says arrives. */
    #hearsFlash = false;

    constructor(chip) {
        this.chip = chip;
    }

    /** The chip's answers are forced low, so that nothing waits for it for ever; EXIT_XIP connects it again. */
    configure() {
        this.#abortFlash();
        this.reset();
    }

    /** INTERFACE_RESET. */
    reset() {
        if (this.#status.inProgress)
            this.#abortFlash();
        this.#status = { token: 0, code: CommandStatus.ok, id: 0, inProgress: false };
        this.#isExclusive = false;
        this.#lastToken = undefined;
        this.clearHalt(true);
        this.clearHalt(false);
    }

    /** CLEAR_FEATURE: what the endpoint was about to do is forgotten. */
    clearHalt(isIn) {
        if (this.#work)
            fail('PICOBOOT: an endpoint is cleared while the flash is being changed');
        if (isIn)
            this.#in = { isHalted: false, offers: undefined };
        else
            this.#out = { isHalted: false, awaits: 'command' };
    }

    isHalted(isIn) {
        return (isIn ? this.#in : this.#out).isHalted;
    }

    /** The answer to GET_COMMAND_STATUS. */
    get status() {
        const bytes = new Uint8Array(16);
        const view = new DataView(bytes.buffer);
        view.setUint32(0, this.#status.token, true);
        view.setUint32(4, this.#status.code, true);
        bytes.set([this.#status.id, Number(this.#status.inProgress)], 8);
        return bytes;
    }

    /** It has become that late. */
    passTime(nanos) {
        this.#nanos = nanos;
        if (!this.#work || nanos < this.#work.end)
            return;
        const { finish } = this.#work;
        this.#work = undefined;
        finish();
    }

    /** The power goes. */
    cut() {
        this.#abortFlash();
    }

    /** A packet from the computer: 'ack', 'nak' or 'stall'. */
    take(bytes) {
        if (this.#out.isHalted)
            return 'stall';
        if (this.#work || this.#out.awaits === undefined)
            return 'nak';
        const { awaits } = this.#out;
        this.#out.awaits = undefined;
        if (awaits === 'command')
            this.#obey(bytes);
        else if (awaits === 'data')
            this.#takeData(bytes);
        else
            this.#takeAcknowledgement(bytes);
        return 'ack';
    }

    /** A packet to the computer: bytes, 'nak' or 'stall'. */
    give() {
        if (this.#in.offers === 'data')
            this.#readChunk();
        if (this.#in.isHalted)
            return 'stall';
        if (this.#work || this.#in.offers === undefined)
            return 'nak';
        if (this.#in.offers === 'data')
            return this.#giveData();
        this.#in.offers = undefined;
        this.#out.awaits = 'command';
        return new Uint8Array(0);
    }

    // Commands.

    #obey(bytes) {
        const command = parsed(bytes);
        const known = command && this.#check(command);
        if (known)
            this.#begin(...known, command);
        else
            this.#in.isHalted = this.#out.isHalted = true;
    }

    /** What the ROM checks at once, and what it ought to. Nothing if the command was refused. */
    #check(command) {
        const { id, token, argumentBytes, transferBytes } = command;
        const refuse = (code) => void (this.#status.code = code);
        this.#status = { token, code: CommandStatus.ok, id, inProgress: false };
        this.#expectSane(command);
        const [name, wanted] = commands.get(id) ?? [];
        if (name === undefined)
            return refuse(CommandStatus.unknownCommand);
        if (argumentBytes !== wanted)
            return refuse(CommandStatus.invalidCommandLength);
        if (name !== 'REBOOT' && transferBytes !== (isRange(name) ? command.given[1] : 0))
            return refuse(CommandStatus.invalidTransferLength);
        return [name];
    }

    /** What the ROM does not look at. */
    #expectSane({ id, token, reserved }) {
        if (reserved !== 0)
            fail(`PICOBOOT: the reserved bytes of a command are ${hex(reserved)}`);
        if (token === this.#lastToken)
            fail(`PICOBOOT: two commands with the token ${hex(token)}: what the one has come to is told of the other`);
        this.#lastToken = token;
        if (!commands.has(id) && commands.has(id ^ 0x80))
            fail(`PICOBOOT: the command ${hex(id)} is taken for ${commands.get(id ^ 0x80)[0]}, with its end the wrong way`);
    }

    #begin(name, { argumentBytes, given, transferBytes }) {
        this.told.push([name, ...given.slice(0, Math.ceil(argumentBytes / 4))]);
        this.#command = { name, address: given[0], count: given[1] };
        this.#chunk = [];
        this.#passed = 0;
        this.#status.inProgress = name !== 'REBOOT';
        if (isRange(name) && transferBytes > 0)
            return this.#beginData();
        this.#perform(name, given, transferBytes);
        return this.#work ?? this.#acknowledge();
    }

    #beginData() {
        if (this.#command.name === 'READ')
            this.#in.offers = 'data';
        else
            this.#out.awaits = 'data';
    }

    #perform(name, given, transferBytes) {
        if (this.restartAt < Infinity)
            fail(`PICOBOOT: ${name} after REBOOT is acknowledged, but not obeyed`);
        switch (name) {
        case 'EXCLUSIVE_ACCESS':
            return this.#setExclusive(...given);
        case 'REBOOT':
            return this.#reboot(...given, transferBytes);
        case 'FLASH_ERASE':
            return this.#erase(...given);
        case 'EXIT_XIP':
            return (this.#hearsFlash = true);
        case 'ENTER_CMD_XIP': // of itself it does nothing: see the end of _execute_task()
            return undefined;
        default:
            return fail(`PICOBOOT: ${name} is not modelled, or has no bytes to transfer`);
        }
    }

    #setExclusive(how) {
        if (how > 2)
            fail(`PICOBOOT: exclusive access of the kind ${how} is not defined`);
        this.#isExclusive = how > 0;
    }

    #reboot(start, stack, milliseconds, transferBytes) {
        if (transferBytes !== 0)
            fail('PICOBOOT: REBOOT with data, which nobody takes');
        if (start !== 0)
            fail('PICOBOOT: a start at an address is not modelled');
        this.restartAt = this.#nanos + milliseconds * 1e6;
    }

    /** The ROM finds all this out, and acknowledges the command as if it had been obeyed. */
    #erase(address, count) {
        if (address % sectorBytes || count % sectorBytes)
            fail(`PICOBOOT: ${hex(count)} bytes at ${hex(address)} are not whole sectors, and will not be erased`);
        if (!isWithin(flash, address, count))
            fail(`PICOBOOT: at ${hex(address)} there is nothing to be erased`);
        this.#expectWritable('erased');
        const offset = this.#offset(address, count);
        this.#change(offset, count, (count / sectorBytes) * eraseNanosPerSector, () => {
            this.chip.erase(offset, count);
            this.#acknowledge();
        });
    }

    // Data.

    /** The place in flash of a chunk of data; nothing if it was refused. */
    #place(count, refuse) {
        const address = this.#command.address + this.#passed;
        if (this.restartAt < Infinity)
            return refuse(CommandStatus.rebooting);
        if (isWithin(ram, address, count) || (this.#command.name === 'READ' && isWithin(rom, address, count)))
            fail(`PICOBOOT: ${this.#command.name} of RAM or ROM is not modelled`);
        if (!isWithin(flash, address, count))
            return refuse(CommandStatus.invalidAddress);
        if (address % pageBytes)
            return refuse(CommandStatus.badAlignment);
        return this.#offset(address, count);
    }

    #readChunk() {
        if (this.#chunk.length > 0 || this.#in.isHalted)
            return;
        const count = Math.min(pageBytes, this.#command.count - this.#passed);
        const offset = this.#place(count, (code) => this.#fault(this.#in, code));
        if (offset === undefined)
            return;
        this.#expectFlash('read');
        this.#chunk = [...this.chip.memory.subarray(offset, offset + count)];
    }

    #giveData() {
        const packet = Uint8Array.from(this.#chunk.splice(0, packetBytes));
        this.#passed += packet.length;
        if (this.#passed === this.#command.count)
            this.#acknowledge();
        return packet;
    }

    #takeData(bytes) {
        const left = this.#command.count - this.#passed - this.#chunk.length;
        if (bytes.length !== Math.min(packetBytes, left))
            fail(`PICOBOOT: a packet of ${bytes.length} bytes within the data of WRITE, of which ${left} are to come`);
        this.#chunk.push(...bytes);
        if (this.#chunk.length === pageBytes || bytes.length === left)
            this.#writeChunk();
        else
            this.#out.awaits = 'data';
    }

    #writeChunk() {
        const bytes = Uint8Array.from(this.#chunk);
        const offset = this.#place(bytes.length, (code) => this.#fault(this.#out, code));
        if (offset === undefined)
            return;
        if (bytes.length % pageBytes)
            fail('PICOBOOT: WRITE ends within a page, whose rest would be programmed, too');
        this.#expectWritable('programmed');
        this.#change(offset, bytes.length, programNanosPerPage, () => {
            this.chip.program(offset, bytes);
            this.#chunk = [];
            this.#passed += bytes.length;
            if (this.#passed === this.#command.count)
                this.#acknowledge();
            else
                this.#out.awaits = 'data';
        });
    }

    /** The end of a command is an empty packet, against the direction of its data. */
    #acknowledge() {
        this.#status.inProgress = false;
        if (this.#status.id & 0x80) {
            this.#in.offers = undefined;
            this.#out.awaits = 'acknowledgement';
        } else {
            this.#in.offers = 'acknowledgement';
        }
    }

    #takeAcknowledgement(bytes) {
        if (bytes.length > 0)
            fail('PICOBOOT: READ has to be ended with an empty packet; another one would be lost');
        this.#out.awaits = 'command';
    }

    /** Data stop. The other endpoint waits for INTERFACE_RESET: the ROM only takes commands again after an end. */
    #fault(endpoint, code) {
        this.#status.code = code;
        this.#status.inProgress = false;
        endpoint.isHalted = true;
    }

    // The flash.

    #offset(address, count) {
        const offset = address - flashAddress;
        if (offset + count > this.chip.memory.length)
            fail(`PICOBOOT: the flash ends before ${hex(address + count)}; the chip begins anew there`);
        return offset;
    }

    #expectFlash(what) {
        if (!this.#hearsFlash)
            fail(`PICOBOOT: flash is ${what} without EXIT_XIP, while nothing arrives that it says`);
    }

    #expectWritable(what) {
        this.#expectFlash(what);
        if (!this.#isExclusive)
            fail(`PICOBOOT: flash is ${what} without exclusive access: the drive's writes come in between`);
    }

    #change(offset, count, nanos, finish) {
        this.#work = { end: this.#nanos + nanos, finish, spoil: () => this.chip.spoil(offset, count) };
    }

    #abortFlash() {
        this.#work?.spoil();
        this.#work = undefined;
        this.#hearsFlash = false;
    }
}
