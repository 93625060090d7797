/**
 * How the bus is used, frame by frame. A frame is what is sent between the log's lines "F …", the first what is sent
 * after the line "SCENE …"; it is complete when its line comes. `places` counts the different places (16 bytes of
 * code) that the processor was at while bytes arrived: few when it waits, many when it draws meanwhile.
 */
export class BusTime {
    /** Complete frames: {note, at, begin, end, bytes, commandBytes, busy, gap, places}, times in
     * nanoseconds. */
    frames = [];
    /** Where the processor is; set by whoever knows it. */
    programCounter = () => 0;
    #frame = emptyFrame();

    /** @param {boolean} isData D/C */
    bytes(isData, begin, end, count) {
        const frame = this.#frame;
        frame.gap = frame.begin === undefined ? 0 : Math.max(frame.gap, begin - frame.end);
        frame.begin ??= begin;
        frame.end = end;
        frame.busy += end - begin;
        frame.places.add(this.programCounter() >>> 4);
        frame[isData ? 'bytes' : 'commandBytes'] += count;
    }

    note(text, nanos) {
        if (text.startsWith('F '))
            this.frames.push({ note: text, at: nanos, ...this.#frame, places: this.#frame.places.size });
        if (text.startsWith('F ') || text.startsWith('SCENE'))
            this.#frame = emptyFrame();
    }
}

function emptyFrame() {
    return { begin: undefined, end: undefined, bytes: 0, commandBytes: 0, busy: 0, gap: 0,
        places: new Set() };
}
