import { fail } from './emulation_error.mjs';

const ALARM0 = 0x10;
const ALARM3 = 0x1c;
const wholeRound = 2 ** 32;

/**
 * Makes the emulator's microsecond timer start with the chip and not with the power, stand without ticks (which come
 * from the watchdog), and raise an alarm at the very microsecond: rp2040js raises it up to one early, and at once if
 * it is past, for which the real one needs the whole round of 71 minutes.
 */
export function correctTimer(mcu, startedAt) {
    const timer = mcu.peripherals[0x40054];
    const watchdog = mcu.peripherals[0x40058];
    const { clock } = mcu;
    const now = () => clock.nanosCounter - startedAt;
    timer.clock = Object.defineProperty({}, 'nanos', { get: now });
    const read = timer.readUint32.bind(timer);
    const write = timer.writeUint32.bind(timer);
    const check = () => watchdog.tickEnable || fail('TIMER is used, but has no ticks');
    timer.readUint32 = (offset) => check() && read(offset);
    timer.writeUint32 = (offset, value) => {
        check();
        write(offset, value);
        if (offset < ALARM0 || offset > ALARM3)
            return;
        const passed = Math.floor(now() / 1000);
        const ahead = (value - passed) >>> 0 || wholeRound;
        timer.alarms[(offset - ALARM0) / 4].clockAlarm.schedule((passed + ahead) * 1000 - now());
    };
}
