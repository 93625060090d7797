import { bootBlockBytes, checksum } from './boot_rom.mjs';

// Of the program that makeImage() puts into RAM.
const programAddress = 0x20000000;
const program = [
    0xa407, // ADR r4, calls
    0xcc0f, 0x4798, 0xe7fc, // next: LDM r4!, {r0-r3}; BLX r3; B next
    0x6001, 0x4770, // store: STR r1, [r0]; BX LR
    0x3801, 0xd1fd, 0x4770, // wait: SUBS r0, #1; BNE wait; BX LR
    0xbf30, 0xe7fd, // sleep: WFI; B sleep
    0xb672, 0x4770, // mask: CPSID i; BX LR
    0x6800, 0x4770, // load: LDR r0, [r0]; BX LR
    0x46c0,
];
const routine = (halfWord) => (programAddress + 2 * halfWord) | 1;

export const store = (address, value) => [address, value, 0, routine(4)];
export const wait = (turns) => [turns, 0, 0, routine(6)];
export const sleep = () => [0, 0, 0, routine(9)];
export const maskInterrupts = () => [0, 0, 0, routine(11)];
export const load = (address) => [address, 0, 0, routine(13)];
export const call = (address, ...parameters) => [...parameters, 0, 0, 0].slice(0, 3).concat(address);

const vectors = 0x10000100;
const ssi = 0x18000000;
/** What a boot block must store so that flash can be read. */
export const flashSetUp = [
    [ssi + 0x08, 0], [ssi + 0x14, 4], [ssi + 0x00, (31 << 16) | (3 << 8)], [ssi + 0xf4, 0x03000218], [ssi + 0x04, 0],
    [ssi + 0x08, 1], [0xe000ed08, vectors],
];

const bootCode = [
    0xa404, // ADR r4, table
    0xcc03, 0x2800, 0xd001, 0x6001, 0xe7fa, // next: LDM r4!, {r0, r1}; CMP r0, #0; BEQ done; STR r1, [r0]; B next
    0xc90c, 0xf382, 0x8808, 0x4718, // done: LDM r1!, {r2, r3}; MSR MSP, r2; BX r3
];
const copyCode = [
    0xa005, 0x2120, 0x0609, 0x22ff, // ADR r0, program; r1 = 0x20000000; MOVS r2, #255
    0xc808, 0xc108, 0x3a01, 0xd1fb, // LDM r0!, {r3}; STM r1!, {r3}; SUBS r2, #1; BNE
    0x2120, 0x0609, 0x3101, 0x4708, // r1 = 0x20000001; BX r1
];

/**
 * An image that makes `calls` from RAM, one after another; without sleep() at the end it runs on into what lies
 * behind them. `setUp` is what its boot block stores.
 */
export function makeImage(calls, setUp = flashSetUp) {
    const image = new Uint8Array(0x2000);
    const view = new DataView(image.buffer);
    place16(view, 0, bootCode);
    place32(view, 2 * bootCode.length, [...setUp.flat(), 0, vectors]);
    view.setUint32(bootBlockBytes - 4, checksum(image.subarray(0, bootBlockBytes - 4)), true);
    place32(view, 0x100, [0x20040000, 0x10000109]);
    place16(view, 0x108, copyCode);
    place16(view, 0x120, program);
    place32(view, 0x120 + 2 * program.length, calls.flat());
    return image;
}

function place16(view, offset, halfWords) {
    halfWords.forEach((value, i) => view.setUint16(offset + 2 * i, value, true));
}

function place32(view, offset, words) {
    words.forEach((value, i) => view.setUint32(offset + 4 * i, value, true));
}

/** Calls that start the clocks as firmware does: 125 MHz from the crystal, and ticks. */
export const startClocks = [
    [0x40024000, 0xfabaa0], // XOSC_CTRL
    [0x4000f000, 1 << 12], [0x40028000, 1], [0x40028008, 125], [0x4002b004, 0x21], [0x4002800c, 0x62000],
    [0x4002b004, 8], // PLL_SYS
    [0x40008030, 2], [0x4000803c, 1], [0x40008048, 1 << 11], // CLK_REF, CLK_SYS, CLK_PERI
    [0x4005802c, 0x20c], // WATCHDOG_TICK
    [0x4000f000, 0x01ffffff], // RESETS
].map(([address, value]) => store(address, value));
