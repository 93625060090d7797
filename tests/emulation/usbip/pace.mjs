/**
 * Keeps emulated time from running ahead of the world's. What an emulator that is too slow has missed it need not catch
 * up, or a device would lose its patience while it does.
 */
export class Pace {
    #begin;

    /** @param now milliseconds of the world */
    constructor(now = () => performance.now()) {
        this.now = now;
    }

    /** @returns for how many milliseconds a board must wait that has come to `nanos`; 0 when it is not ahead */
    wait(nanos) {
        const now = this.now();
        this.#begin = Math.max(this.#begin ?? -Infinity, now - nanos / 1e6);
        return this.#begin + nanos / 1e6 - now;
    }
}
