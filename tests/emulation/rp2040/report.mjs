import { flashBytes } from './board.mjs';
import { PinFunction, noPin } from './pins.mjs';

// In RAM, as boards/pico/link.ld has it.
const stackTop = 264 * 1024;
const stackLimit = stackTop - 17 * 1024;

/**
 * What a run was like, for tests: see README.md for the fields.
 * @param wired what run_pico.mjs has built
 * @param {string | undefined} failure why it broke off
 */
export function report({ board, bus, busTime, display, led, log, settings, tearing, usb }, failure) {
    return {
        failure,
        ending: failure ? 'failure' : board.ending ?? 'the time was over',
        milliseconds: board.nanos / 1e6,
        cycles: board.cycles,
        starts: board.starts,
        watchdogResets: board.watchdogResets.map((nanos) => nanos / 1e6),
        bootBlock: board.bootBlock && { ...board.bootBlock, writes: board.flashInterface.writes },
        flash: { bytes: flashBytes, operations: board.rom?.flashOperations ?? [] },
        freeStack: freeStack(board.mcu),
        registers: registers(board.mcu, settings),
        connectedPins: connectedPins(board.mcu),
        ledTurns: led.turns.map((nanos) => nanos / 1e6),
        shortest: bus.shortest && rounded(bus.shortest),
        tearingRises: tearing?.rises ?? [],
        log: log.lines,
        commands: display.commands,
        ...(settings.bus === 'dac' && { lights: display.lights, stale: display.stale }),
        ...(usb && { usb: usb.told }),
        frames: busTime.frames,
    };
}

/** How many bytes of the stack nothing was ever written to; RAM begins as zeros here. */
function freeStack({ sramView }) {
    let at = stackLimit;
    while (at < stackTop && sramView.getUint32(at, true) === 0)
        at += 4;
    return at - stackLimit;
}

function rounded(times) {
    return Object.fromEntries(Object.entries(times).map(([name, nanos]) => [name, Math.round(nanos * 1000) / 1000]));
}

/** What is led to any unit of the chip: no other pin can be driven. */
function connectedPins({ gpio }) {
    return gpio.filter((pin) => pin.functionSelect !== PinFunction.null).map((pin) => pin.index);
}

/** Registers that the emulator does not heed, or that tell how fast the bus can be. */
function registers(mcu, { bus, pins, controls }) {
    return {
        clkSys: mcu.clkSys,
        clkPeri: mcu.clocks.periFreq,
        watchdogEnabled: mcu.peripherals[0x40058].enable,
        pins: Object.fromEntries(usedPins(bus, pins).map(([role, pin]) => [role, pinRegisters(mcu.gpio[pin])])),
        light: light(mcu, pins.backlight),
        controls: controls.map(({ kind, pin }) => ({ kind, ...pinRegisters(mcu.gpio[pin]) })),
        ...(bus === 'spi' && { spi: spiRegisters(mcu.spi[(pins.clock >>> 3) & 1]) }),
        ...(bus === 'i2c' && { i2c: i2cRegisters(mcu.i2c[(pins.clock >>> 1) & 1]) }),
        ...((bus === 'parallel' || bus === 'dac') && { pio: mcu.pio.map(pioRegisters) }),
    };
}

/** [role, pin]; of a parallel bus the data pins are D0 ... D7. */
function usedPins(bus, pins) {
    const used = Object.entries(pins).filter(([role, pin]) => pin !== noPin && (bus !== 'parallel' || role !== 'data'));
    const data = Array.from({ length: 8 }, (_, i) => [`D${i}`, pins.data + i]);
    return bus === 'parallel' ? [...used, ...data] : used;
}

/** The share of time for which the backlight is lit, as its PWM is set; nothing without one. */
export function light(mcu, pin) {
    if (pin === noPin)
        return undefined;
    const { cc, top } = mcu.pwm.channels[(pin >>> 1) & 7];
    return Math.min(((cc >>> (16 * (pin & 1))) & 0xffff) / (top + 1), 1);
}

function pinRegisters({ index, functionSelect, padValue }) {
    return { pin: index, functionSelect, pad: padValue };
}

function spiRegisters(spi) {
    return { SSPCR0: spi.control0, SSPCR1: spi.control1, SSPCPSR: spi.clockDivisor, SSPDMACR: spi.dmaControl,
        hertz: spi.clockFrequency };
}

function i2cRegisters(i2c) {
    return { IC_CON: i2c.control, IC_TAR: i2c.targetAddress, IC_FS_SCL_HCNT: i2c.fsClockHighPeriod,
        IC_FS_SCL_LCNT: i2c.fsClockLowPeriod, IC_ENABLE: i2c.enable };
}

function pioRegisters(pio) {
    return pio.machines.map(({ enabled, clockDivInt, clockDivFrac }) => ({ enabled,
        divider: (clockDivInt || 65536) + clockDivFrac / 256 }));
}
