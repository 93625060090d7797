import assert from 'node:assert/strict';
import test from 'node:test';

import { BootLoader } from './boot_loader.mjs';
import { BootLoaderComputer, clearHalt, configure, getCommandStatus, interfaceReset, into, out }
    from './boot_loader_computer.mjs';
import { EmulationError } from './emulation_error.mjs';
import { FlashChip } from './flash_chip.mjs';
import { CommandStatus } from './picoboot.mjs';
import { request, textOf } from './usb_host.mjs';

const flashAddress = 0x10000000;
const sector = 4096;
const nothing = new Uint8Array(0);
const bytesFrom = (seed, count) => Uint8Array.from({ length: count }, (_, i) => seed + 7 * i);

/** A computer with a boot loader in front of 16 sectors of `was`. */
function plugged(was = 0xff) {
    const chip = new FlashChip(new Uint8Array(16 * sector).fill(was));
    const computer = new BootLoaderComputer(new BootLoader(chip));
    return Object.assign(computer, { chip, told: () => computer.device.picoboot.told });
}

/** The same when it may change flash. */
function ready(was) {
    const computer = plugged(was);
    computer.begin();
    return computer;
}

const endsRun = (work, message) => assert.throws(work, (problem) =>
    problem instanceof EmulationError && message.test(problem.message));

function expectRefused(computer, code, work) {
    assert.equal(work(), 'stall');
    assert.deepEqual(computer.status().code, code);
}

test('it says that it is the boot loader of an RP2040, with a drive and PICOBOOT', () => {
    const { device } = plugged();
    const own = device.control(request(0x80, 6, 0x0100, 0, 18));
    assert.deepEqual([...own.subarray(2, 4), ...own.subarray(8, 12)], [0x10, 0x01, 0x8a, 0x2e, 0x03, 0x00]);
    const all = device.control(request(0x80, 6, 0x0200, 0, 255));
    assert.deepEqual([all.length, all[2], all[4]], [55, 55, 2]);
    assert.deepEqual([...all.subarray(9 + 5, 9 + 8), ...all.subarray(32 + 5, 32 + 8)], [8, 6, 0x50, 0xff, 0, 0]);
    assert.deepEqual([43, 50].map((at) => all[at]), [0x03, 0x84]);
    assert.equal(device.control(request(0x80, 6, 0x0200, 0, 9)).length, 9);
    assert.deepEqual([1, 2, 3].map((i) => textOf(device.control(request(0x80, 6, 0x0300 + i, 0x409, 255)))),
        ['Raspberry Pi', 'RP2 Boot', 'E0C9125B0D9B']);
    assert.equal(device.control(request(0x80, 6, 0x0600, 0, 10)), 'stall');
});

test('it is another chip if it is told so, and then takes no commands', () => {
    const other = new BootLoaderComputer(new BootLoader(new FlashChip(new Uint8Array(sector)), 'rp2350'));
    assert.equal(other.device.control(request(0x80, 6, 0x0100, 0, 18))[10], 0x0f);
    endsRun(() => other.exclusive(), /of this chip are not modelled/);
    endsRun(() => new BootLoader(new FlashChip(new Uint8Array(sector)), 'stm32'), /no boot loader/);
});

test('endpoints answer when it is configured, and those of the drive say NAK', () => {
    const { device } = plugged();
    const answers = [device.sendOnce(2, new Uint8Array(31)), device.askOnce(1), device.askOnce(5)];
    assert.deepEqual(answers, ['nak', 'nak', 'timeout']);
    device.reset();
    assert.deepEqual([device.askOnce(into), device.sendOnce(out, nothing)], ['timeout', 'timeout']);
    assert.equal(device.control(interfaceReset), 'stall');
    assert.deepEqual(device.control(request(0x80, 8, 0, 0, 1)), Uint8Array.of(0));
    assert.equal(device.control(request(0x00, 9, 2)), 'stall');
    assert.deepEqual(device.control(configure), nothing);
    assert.deepEqual(device.control(request(0xa1, 0xfe, 0, 0, 1)), Uint8Array.of(0));
    assert.equal(device.control(request(0xc1, 0x42, 0, 0, 16)), 'stall'); // of the drive
    assert.equal(device.control(request(0xc1, 0x42, 0, 1, 8)), 'stall');
});

test('flash is erased, written and read', () => {
    const computer = ready(0);
    const bytes = bytesFrom(3, sector);
    const begin = computer.device.nanos;
    assert.deepEqual(computer.erase(flashAddress + sector, sector), nothing);
    assert.ok(computer.device.nanos - begin > 45e6, 'a sector takes its time');
    assert.deepEqual(computer.write(flashAddress + sector, bytes), nothing);
    assert.deepEqual(computer.read(flashAddress + sector, sector), bytes);
    assert.deepEqual(computer.read(flashAddress + sector, 100), bytes.subarray(0, 100));
    assert.deepEqual([0, sector - 1, sector, 2 * sector].map((at) => computer.chip.memory[at]), [0, 0, 3, 0]);
    assert.deepEqual(computer.told().map(([name]) => name), ['EXCLUSIVE_ACCESS', 'EXIT_XIP', 'FLASH_ERASE', 'WRITE',
        'READ', 'READ']);
    assert.deepEqual(computer.told()[2], ['FLASH_ERASE', flashAddress + sector, sector]);
    assert.deepEqual(computer.told()[0], ['EXCLUSIVE_ACCESS', 1]);
});

test('bits can be cleared, not set, and some are stuck', () => {
    const computer = ready();
    computer.chip.stick(5, 0x01);
    computer.erase(flashAddress, sector);
    computer.write(flashAddress, new Uint8Array(256).fill(0xf1));
    computer.write(flashAddress, new Uint8Array(256).fill(0x1f));
    assert.deepEqual([...computer.read(flashAddress, 6)], [0x11, 0x11, 0x11, 0x11, 0x11, 0x10]);
});

test('commands are told from other bytes, and refused by their numbers and lengths', () => {
    const { invalidCommandLength, invalidTransferLength, ok, unknownCommand } = CommandStatus;
    const packets = [
        [ok, (computer) => computer.packet(0x06, [], { magic: 0x431fd10c })],
        [ok, (computer) => computer.packet(0x06).subarray(0, 31)],
        [ok, () => nothing],
        [unknownCommand, (computer) => computer.packet(0x0a)],
        [unknownCommand, (computer) => computer.packet(0x00)],
        [invalidCommandLength, (computer) => computer.packet(0x01, [1])],
        [invalidCommandLength, (computer) => computer.packet(0x06, [1])],
        [invalidTransferLength, (computer) => computer.packet(0x06, [], { transfer: 1 })],
        [invalidTransferLength, (computer) => computer.packet(0x03, [flashAddress, sector], { transfer: sector })],
        [invalidTransferLength, (computer) => computer.packet(0x05, [flashAddress, 256], { transfer: 255 })],
        [invalidTransferLength, (computer) => computer.packet(0x84, [flashAddress, 256])],
    ];
    for (const [code, packet] of packets) {
        const computer = plugged();
        assert.equal(computer.send(packet(computer)), 'ack');
        assert.deepEqual([computer.send(nothing), computer.receive(0)], ['stall', 'stall']);
        assert.equal(computer.status().code, code);
        assert.deepEqual(computer.told(), []);
    }
});

test('the status tells of the last command', () => {
    const computer = ready();
    computer.send(computer.packet(0x03, [flashAddress, sector], { token: 0x12345678 }));
    assert.deepEqual(computer.status(), { token: 0x12345678, code: 0, id: 0x03, inProgress: 1 });
    computer.receive(0);
    assert.deepEqual(computer.status(), { token: 0x12345678, code: 0, id: 0x03, inProgress: 0 });
    assert.equal(computer.device.control(getCommandStatus).length, 16);
    computer.device.control(interfaceReset);
    assert.deepEqual(computer.status(), { token: 0, code: 0, id: 0, inProgress: 0 });
});

test('data at wrong places stall the endpoint that has them', () => {
    const { badAlignment, invalidAddress } = CommandStatus;
    for (const [address, code] of [[flashAddress + 4, badAlignment], [0x0f000000, invalidAddress]]) {
        const reader = ready();
        expectRefused(reader, code, () => reader.read(address, 256));
        assert.equal(reader.status().inProgress, 0);
        assert.equal(reader.send(reader.packet(0x06)), 'nak'); // until it is reset
        const writer = ready();
        assert.equal(writer.write(address, new Uint8Array(512)), 'stall');
        assert.equal(writer.status().code, code);
        assert.equal(writer.receive(0), 'nak');
    }
});

test('after a stall an endpoint is cleared, or both by a reset of the interface', () => {
    const isHalted = (computer, address) => computer.device.control(request(0x82, 0, 0, address, 2))[0];
    const stalled = () => {
        const computer = plugged();
        computer.send(computer.packet(0x7f));
        assert.deepEqual([isHalted(computer, 3), isHalted(computer, 0x84)], [1, 1]);
        return computer;
    };
    const cleared = stalled();
    cleared.device.control(clearHalt(0x84));
    assert.deepEqual([isHalted(cleared, 3), isHalted(cleared, 0x84)], [1, 0]);
    assert.equal(cleared.send(cleared.packet(0x06)), 'stall');
    cleared.device.control(clearHalt(3));
    assert.deepEqual(cleared.exclusive(), nothing);
    const reset = stalled();
    reset.device.control(interfaceReset);
    assert.deepEqual(reset.command(0x01, [1], { length: 1, token: 1 }), nothing); // as another program would begin
    assert.equal(reset.device.control(request(0x02, 1, 1, 3)), 'stall'); // no such feature
    assert.deepEqual(reset.device.control(clearHalt(0x81)), nothing);
});

test('phases have their order', () => {
    const early = plugged();
    early.send(early.packet(0x06));
    assert.equal(early.device.sendOnce(out, early.packet(0x06)), 'nak'); // its end was not fetched
    assert.deepEqual(early.receive(0), nothing);
    assert.equal(early.receive(0), 'nak');
    const reader = ready();
    reader.send(reader.packet(0x84, [flashAddress, 256], { transfer: 256 }));
    assert.equal(reader.device.sendOnce(out, nothing), 'nak'); // there are data to be fetched
    reader.receive(256);
    assert.equal(reader.device.askOnce(into), 'nak');
    endsRun(() => reader.send(reader.packet(0x06)), /empty packet/);
});

test('what the ROM would quietly not do, or do wrong, ends the run', () => {
    endsRun(() => plugged().erase(flashAddress, sector), /without EXIT_XIP/);
    endsRun(() => plugged().read(flashAddress, 256), /without EXIT_XIP/);
    const shared = plugged();
    shared.command(0x06);
    assert.equal(shared.read(flashAddress, 256).length, 256);
    endsRun(() => shared.erase(flashAddress, sector), /without exclusive access/);
    const reset = ready();
    reset.device.control(interfaceReset);
    endsRun(() => reset.write(flashAddress, new Uint8Array(256)), /without exclusive access/);
    endsRun(() => ready().exclusive(3), /kind 3/);
    endsRun(() => ready().erase(flashAddress + 256, sector), /will not be erased/);
    endsRun(() => ready().erase(flashAddress, 256), /will not be erased/);
    endsRun(() => ready().erase(0, sector), /nothing to be erased/);
    endsRun(() => ready().erase(flashAddress + 16 * sector, sector), /the flash ends/);
    endsRun(() => ready().read(flashAddress + 16 * sector - 256, 512), /the flash ends/);
    endsRun(() => ready().write(flashAddress, new Uint8Array(300)), /ends within a page/);
    endsRun(() => ready().write(0x20000000, new Uint8Array(256)), /RAM or ROM is not modelled/);
    endsRun(() => ready().command(0x83, [flashAddress, sector]), /taken for FLASH_ERASE/);
    endsRun(() => ready().command(0x08, [0x20000000]), /EXEC is not modelled/);
    endsRun(() => ready().command(0x06, [], { reserved: 1 }), /reserved bytes/);
    endsRun(() => ready().command(0x06, [], { token: 2 }), /two commands with the token/);
    endsRun(() => ready().reboot(0x20000000), /start at an address/);
    endsRun(() => ready().command(0x02, [0, 0, 1], { transfer: 1 }), /REBOOT with data/);
    endsRun(() => ready().device.control(request(0x41, 0x41, 0, 1, 1)), /INTERFACE_RESET has no data/);
    const writer = ready();
    writer.send(writer.packet(0x05, [flashAddress, 256], { transfer: 256 }));
    endsRun(() => writer.send(new Uint8Array(32)), /a packet of 32 bytes within the data/);
});

test('a configuration needs EXIT_XIP anew, and exclusive access', () => {
    const computer = ready();
    computer.device.control(configure);
    endsRun(() => computer.read(flashAddress, 256), /without EXIT_XIP/);
    const again = ready();
    again.device.control(configure);
    again.command(0x06);
    endsRun(() => again.erase(flashAddress, sector), /without exclusive/);
});

test('what breaks off spoils the flash: by a reset, a new configuration, or without power', () => {
    const ways = [(device) => device.control(interfaceReset), (device) => device.reset(), (device) => device.cut()];
    for (const breakOff of ways) {
        const computer = ready(0x55);
        computer.send(computer.packet(0x03, [flashAddress, sector]));
        breakOff(computer.device);
        const found = new Set(computer.chip.memory.subarray(0, sector));
        assert.ok(found.size > 100, 'the sector is neither what it was nor erased');
        assert.equal(computer.chip.memory[sector], 0x55);
    }
    const cleared = ready();
    cleared.send(cleared.packet(0x03, [flashAddress, sector]));
    endsRun(() => cleared.device.control(clearHalt(0x84)), /while the flash is being changed/);
    const whole = ready();
    whole.erase(flashAddress, sector);
    whole.device.cut();
    assert.equal(whole.chip.memory[0], 0xff);
});

test('it restarts after it has acknowledged it, and obeys nothing until then', () => {
    const computer = ready();
    assert.deepEqual(computer.reboot(0, 100), nothing);
    assert.ok(computer.device.attached);
    expectRefused(computer, CommandStatus.rebooting, () => computer.read(flashAddress, 256));
    const { device } = computer;
    const end = device.nanos + 100e6;
    while (device.nanos < end)
        device.nextFrame();
    assert.ok(!device.attached);
    const late = ready();
    late.reboot();
    endsRun(() => late.erase(flashAddress, sector), /after REBOOT/);
});
