import assert from 'node:assert/strict';
import test from 'node:test';

import { Board } from './board.mjs';
import { checksum } from './boot_rom.mjs';
import { uniqueId } from './flash_chip.mjs';
import { call, flashSetUp, load, makeImage, maskInterrupts, sleep, startClocks, store, wait } from './test_image.mjs';

const millisecond = 1e6;

function started(calls, setUp) {
    const board = new Board(makeImage([...calls, sleep()], setUp));
    return board;
}

function expectFailure(calls, message, setUp) {
    assert.throws(() => started(calls, setUp).run(100 * millisecond), message);
}

test('the checksum of boot blocks is CRC-32/MPEG-2', () => {
    assert.equal(checksum(Buffer.from('123456789')), 0x0376e6e7);
    assert.equal(checksum(new Uint8Array(252)), 0x7065399a);
    assert.equal(checksum(Uint8Array.from({ length: 252 }, (_, i) => i)), 0xb454e2a8);
});

test('the boot block runs in RAM and its stores to the flash interface are recorded', () => {
    const board = started([store(0x20001000, 0x12345678)]);
    board.run(millisecond);
    assert.equal(board.mcu.readUint32(0x20001000), 0x12345678);
    assert.equal(board.bootBlock.vectors, 0x10000100);
    assert.deepEqual(board.flashInterface.writes.map(([name]) => name),
        ['SSIENR', 'BAUDR', 'CTRLR0', 'SPI_CTRLR0', 'CTRLR1', 'SSIENR']);
});

test('a damaged boot block is refused', () => {
    const image = makeImage([sleep()]);
    image[17] ^= 1;
    const board = new Board(image);
    board.run(millisecond);
    assert.equal(board.ending, 'the boot block was refused');
    assert.equal(board.cycles, 0);
});

test('without a proper set-up of the flash interface nothing can be fetched', () => {
    const without = (register) => flashSetUp.filter(([address]) => address !== 0x18000000 + register);
    expectFailure([], /its interface is not set up/, without(0x08).slice(0, 0).concat([[0x18000008, 0]]));
    expectFailure([], /BAUDR is written while the unit is enabled/, flashSetUp.slice(1));
    expectFailure([], /its interface is not set up/,
        flashSetUp.map(([address, value]) => [address, value === 0x03000218 ? 0x0b000218 : value]));
});

test('flash changes as NOR flash does, by the functions of the boot ROM alone', () => {
    const rom = functionsOfRom();
    const command = [maskInterrupts(), call(rom.IF), call(rom.EX)];
    const change = [call(rom.RE, 0x100000, 4096, 0x10000, 0xd8), store(0x20002000, 0xf0f0f0f0),
        call(rom.RP, 0x100000, 0x20002000, 256), store(0x20002000, 0x3fffffff),
        call(rom.RP, 0x100000, 0x20002000, 256)];
    const board = started([...command, ...change, call(rom.FC), call(rom.CX), load(0x10100000)]);
    board.run(100 * millisecond);
    assert.equal(board.memoryWord(0x10100000), 0x30f0f0f0);
    assert.deepEqual(board.rom.flashOperations.map(([what]) => what), ['erase', 'program', 'program']);
    expectFailure([...command, load(0x10100000)], /its interface is not set up/);
    expectFailure([...command, call(rom.FC), ...change, call(rom.CX), load(0x10100000)],
        /its cache holds what was there before/);
    expectFailure([...command, call(rom.CX), load(0x10100000)], /its interface is not set up/); // select is still forced
    expectFailure([maskInterrupts(), ...change], /before IF and EX/);
    expectFailure([store(0xe000e100, 1), ...command.slice(1), ...change], /while interrupts can come/);
    expectFailure([...command, call(rom.RE, 0x100100, 4096)], /not whole sectors/);
    expectFailure([store(0x10100000, 0)], /a store to flash/);
});

test('the flash chip tells its number', () => {
    const rom = functionsOfRom();
    const command = [maskInterrupts(), call(rom.IF), call(rom.EX)];
    const select = store(0x4001b00c, 1 << 8); // forced high by the boot ROM, and low by this
    const exchange = (byte) => [store(0x18000060, byte), load(0x18000060)];
    const bytes = [0x4b, 0, 0, 0, 0, ...uniqueId.map(() => 0)].flatMap(exchange);
    const board = started([...command, select, ...bytes]);
    const read = [];
    board.run(millisecond / 100);
    const { readUint32 } = board.flashInterface;
    board.flashInterface.readUint32 = function (offset) {
        const value = readUint32.call(this, offset);
        read.push(value);
        return value;
    };
    board.run(millisecond);
    assert.deepEqual(read.slice(5), [...uniqueId]);
    expectFailure([...command, ...exchange(0x4b)], /the chip not selected/);
    expectFailure([...command, select, store(0x18000060, 0x9f)], /the command 0x9f is not modelled/);
    expectFailure([...command, select, call(rom.FC)], /a command has not ended/);
    expectFailure([...command, select, load(0x18000060)], /a byte is read that is not there/);
    expectFailure([select, store(0x18000060, 0x4b)], /not set up for that/);
});

test('what would not work on hardware ends the run', () => {
    expectFailure([store(0x4003c000, 7)], /SPI0 is touched while it is held in reset/);
    expectFailure([store(0x4000f000, 1 << 21), load(0x40054028)], /TIMER is used, but has no ticks/);
    expectFailure([...startClocks, store(0x4005802c, 0x20d)], /TICK counts 13 cycles, a microsecond has 12/);
    expectFailure([load(0x20000001)], /not 32 bit aligned/);
    expectFailure([load(0x60000000)], /invalid memory address/);
    expectFailure([store(0x20001000, 0xbe05be05), call(0x20001001)], /breakpoint 5/);
    expectFailure([store(0x20001000, 0xdeffdeff), call(0x20001001)], /breakpoint 255/);
});

test('the watchdog restarts the chip: RAM stays, units are as new', () => {
    const board = started([...startClocks, store(0x20001000, 1), store(0x40058004, 2000), store(0x40058000, 1 << 30)]);
    board.run(1.6 * millisecond);
    assert.equal(board.starts, 2);
    assert.equal(board.mcu.readUint32(0x20001000), 1);
    assert.equal(board.mcu.peripherals[0x40058].reason, 1);
    assert.ok(board.watchdogResets[0] > 1e6 && board.watchdogResets[0] < 1.5e6);
});

test('a masked interrupt ends WFI and is not taken', () => {
    const alarm = [store(0x40054038, 1), store(0xe000e100, 1), store(0x40054010, 500)];
    const board = started([...startClocks, maskInterrupts(), ...alarm]);
    board.run(millisecond);
    assert.equal(board.mcu.core.IPSR, 0);
    assert.ok(board.cycles > 50000, 'it does not sleep while the interrupt waits');
});

test('an instruction takes its cycles at the speed of the clock', () => {
    const slow = started([wait(1000), store(0x20001000, 1)]);
    slow.run(0.3 * millisecond); // 3000 cycles at 6.5 MHz need longer
    assert.equal(slow.mcu.readUint32(0x20001000), 0);
    const fast = started([...startClocks, wait(1000), store(0x20001000, 1)]);
    fast.run(0.8 * millisecond);
    assert.equal(fast.mcu.readUint32(0x20001000), 1);
});

function functionsOfRom() {
    const board = started([]);
    board.run(millisecond);
    const view = new DataView(board.mcu.bootrom.buffer);
    const functions = {};
    for (let entry = view.getUint16(0x14, true); view.getUint16(entry, true); entry += 4)
        functions[String.fromCharCode(view.getUint8(entry), view.getUint8(entry + 1))] =
            view.getUint16(entry + 2, true);
    return functions;
}
