import { fail, hex } from './emulation_error.mjs';
import { pageBytes, sectorBytes } from './flash_chip.mjs';

export const bootBlockBytes = 256;
/** Where the ROM copies the boot block to and runs it. */
export const bootBlockAddress = 0x20041f00;

const programNanosPerPage = 0.4e6;
const tablePointer = 0x14;
const lookupPointer = 0x18;
const table = 0x100;
const code = 0x200;

/** CRC-32/MPEG-2. */
export function checksum(bytes) {
    let crc = 0xffffffff;
    for (const byte of bytes) {
        crc ^= byte << 24;
        for (let bit = 0; bit < 8; ++bit)
            crc = (crc << 1) ^ (crc & 0x80000000 ? 0x04c11db7 : 0);
    }
    return crc >>> 0;
}

/** Whether the ROM would run the boot block at the beginning of `flash`. */
export function acceptsBootBlock(flash) {
    const block = flash.subarray(0, bootBlockBytes);
    const stored = new DataView(block.buffer, block.byteOffset).getUint32(bootBlockBytes - 4, true);
    return checksum(block.subarray(0, bootBlockBytes - 4)) === stored;
}

/**
 * The functions of the boot ROM that firmware may call, found as in the real one through the table at 0x14 and the
 * look-up function at 0x18. Each is a breakpoint and a return; what it does is done here.
 */
export class BootRom {
    /** What was asked of the flash: [what, offset, bytes]. */
    flashOperations = [];

    #functions = [];
    #connected = false;

    /** @param board has mcu, flashInterface, flashChip, flashStale and passTime(nanos) */
    constructor(board) {
        this.board = board;
        this.view = new DataView(board.mcu.bootrom.buffer);
        [0x4d, 0x75, 1, 3].forEach((byte, i) => this.view.setUint8(0x10 + i, byte)); // "Mu", 1, version 3
        const entries = Object.entries(this.#published()).map(([name, run]) => [name, this.#place(run)]);
        entries.forEach(([name, address], i) => {
            this.view.setUint16(table + 4 * i, name.charCodeAt(0) | (name.charCodeAt(1) << 8), true);
            this.view.setUint16(table + 4 * i + 2, address, true);
        });
        this.view.setUint16(tablePointer, table, true);
        this.view.setUint16(lookupPointer, this.#place(() => this.#lookUp()), true);
    }

    /** A breakpoint in the ROM was met. */
    breakpoint(number) {
        this.#functions[number]();
    }

    #place(run) {
        const address = code + 4 * this.#functions.length;
        this.view.setUint16(address, 0xbe00 | this.#functions.length, true); // BKPT #number
        this.view.setUint16(address + 2, 0x4770, true); // BX LR
        this.#functions.push(run);
        return address | 1;
    }

    #argument(index) {
        return this.board.mcu.core.registers[index];
    }

    #lookUp() {
        const { mcu } = this.board;
        const wanted = this.#argument(1) & 0xffff;
        for (let entry = this.#argument(0); mcu.readUint16(entry); entry += 4) {
            if (mcu.readUint16(entry) === wanted) {
                mcu.core.registers[0] = mcu.readUint16(entry + 2);
                return;
            }
        }
        fail(`the boot ROM's function ${String.fromCharCode(wanted & 0xff, wanted >> 8)} is not modelled`);
    }

    #published() {
        return {
            IF: () => (this.#connected = true),
            EX: () => this.board.flashInterface.stopReading(),
            RE: () => this.#erase(this.#argument(0), this.#argument(1)),
            RP: () => this.#program(this.#argument(0), this.#argument(1), this.#argument(2)),
            FC: () => this.#flush(),
            CX: () => this.board.flashInterface.readSlowly(),
            UB: () => this.board.end('restarted as a USB drive'),
        };
    }

    #flush() {
        this.board.flashInterface.pins.release();
        this.board.setFlashStale(false);
    }

    #expectCommandMode(what) {
        const { core } = this.board.mcu;
        if (!this.#connected || this.board.flashInterface.isReadable())
            fail(`flash: ${what} before IF and EX were called`);
        if (!core.PM && core.enabledInterrupts !== 0)
            fail(`flash: ${what} while interrupts can come`);
    }

    #erase(offset, count) {
        this.#expectCommandMode('erased');
        this.flashOperations.push(['erase', offset, count]);
        this.board.onFlashOperation(offset, new Uint8Array(count).fill(0xff));
        this.board.flashChip.erase(offset, count);
        this.board.setFlashStale(true);
        this.board.passTime((count / sectorBytes) * this.board.eraseNanos);
    }

    #program(offset, address, count) {
        this.#expectCommandMode('programmed');
        if (address < 0x20000000 || address >= 0x20042000)
            fail(`flash: bytes from ${hex(address)} cannot be programmed: they must lie in RAM`);
        this.flashOperations.push(['program', offset, count]);
        const start = address - 0x20000000;
        const bytes = this.board.mcu.sram.slice(start, start + count);
        this.board.onFlashOperation(offset, bytes);
        this.board.flashChip.program(offset, bytes);
        this.board.setFlashStale(true);
        this.board.passTime((count / pageBytes) * programNanosPerPage);
    }
}
