import { fail } from './emulation_error.mjs';
import { noPin } from './pins.mjs';

export const settingsOffset = 0x3f000;
export const sceneOffset = 0x40000;

const controllers = ['st7789', 'ili9341', 'st7735', 'gc9a01', 'ssd1306', 'ssd1351', 'ssd0323'];
const buses = ['spi', 'i2c', 'parallel', 'dac'];
const controlKinds = ['none', 'button', 'knob'];
const mostControls = 8;
const beamRoles = ['ldac', 'blank'];
const beamFields = 8 + 274;
const roles = ['clock', 'data', 'select', 'dc', 'reset', 'backlight', 'tearing', 'log'];

/**
 * How the display is wired, read from a board record (firmware/settings/board_record.hpp).
 * @param {Uint8Array} bytes that begin with the record
 */
export function readSettings(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const version = view.getUint16(4, true);
    if (String.fromCharCode(...bytes.subarray(0, 4)) !== 'KFBS' || version < 1 || version > 2)
        fail('no board record of version 1 or 2: kfast config makes one');
    const pins = Object.fromEntries(roles.map((role, i) => [role, bytes[22 + i]]));
    beamRoles.forEach((role, i) => (pins[role] = version === 2 ? bytes[beamFields + i] : noPin));
    return {
        controller: controllers[bytes[8]],
        bus: buses[bytes[20]],
        address: bytes[21],
        pins,
        clock: view.getUint32(30, true),
        controls: Array.from({ length: mostControls }, (_, i) => 58 + 28 * i)
            .map((at) => ({ kind: controlKinds[bytes[at]], pin: bytes[at + 2] }))
            .filter(({ kind }) => kind !== 'none'),
    };
}
