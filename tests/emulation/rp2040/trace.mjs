import fs from 'node:fs';

/** Kinds of records, as `kfast-panel` reads them. */
export const Kind = {
    command: 0, // bytes with D/C low
    data: 1, // bytes with D/C high
    resetLow: 2,
    resetHigh: 3,
    selected: 4,
    released: 5,
    note: 6, // a line of the log, without its end
};

const longestPause = 1e6; // nanoseconds within one record

/**
 * What happens at a display's pins: "KFTRACE1", then records, little-endian: kind u8, time u64 in nanoseconds since the
 * power came on, count u32, and as many bytes. Bytes of one level that follow each other closely are one record.
 */
export class Trace {
    #records = [];
    #latest = 0;
    #open; // the record that bytes may be added to
    #lastByte = 0;

    /** Bytes with D/C low (Kind.command) or high (Kind.data), the first at `nanos`, the last through at `end`. */
    bytes(kind, nanos, end, bytes) {
        if (this.#open?.kind !== kind || nanos - this.#lastByte > longestPause)
            this.#open = this.#add(kind, nanos);
        this.#open.append(bytes);
        this.#lastByte = end;
    }

    /** A change of a line. */
    line(kind, nanos) {
        this.#open = undefined;
        this.#add(kind, nanos);
    }

    /** Begins a note that stands here, however late its text is complete; returns what sets it. */
    note(nanos) {
        this.#open = undefined;
        const record = this.#add(Kind.note, nanos);
        return (text) => record.append(Buffer.from(text, 'latin1'));
    }

    write(path) {
        const file = fs.openSync(path, 'w');
        try {
            fs.writeSync(file, 'KFTRACE1');
            for (const record of this.#records)
                fs.writeSync(file, Buffer.concat([record.header(), record.bytes]));
        } finally {
            fs.closeSync(file);
        }
    }

    #add(kind, nanos) {
        const record = new Record(kind, Math.max(nanos, this.#latest)); // a byte that was on its way before a note
        this.#latest = record.nanos;
        this.#records.push(record);
        return record;
    }
}

class Record {
    #memory = new Uint8Array(16);
    #count = 0;

    constructor(kind, nanos) {
        this.kind = kind;
        this.nanos = nanos;
    }

    get bytes() {
        return this.#memory.subarray(0, this.#count);
    }

    append(bytes) {
        if (this.#count + bytes.length > this.#memory.length) {
            const larger = new Uint8Array(2 * (this.#count + bytes.length));
            larger.set(this.#memory);
            this.#memory = larger;
        }
        for (let i = 0; i < bytes.length; ++i)
            this.#memory[this.#count++] = bytes[i];
    }

    header() {
        const bytes = Buffer.alloc(13);
        bytes.writeUInt8(this.kind, 0);
        bytes.writeBigUInt64LE(BigInt(Math.round(this.nanos)), 1);
        bytes.writeUInt32LE(this.#count, 9);
        return bytes;
    }
}
