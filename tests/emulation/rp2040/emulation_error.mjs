/** What would not work on hardware, or what the emulator cannot do. It ends the run. */
export class EmulationError extends Error {}

/** @returns {never} */
export function fail(message) {
    throw new EmulationError(message);
}

/** `value` as the data sheets write it. */
export function hex(value, digits = 1) {
    return `0x${(value >>> 0).toString(16).padStart(digits, '0')}`;
}
