import { UsbHost, request, textOf } from './usb_host.mjs';

const attachNanos = 100e6;
const address = 9;
const reportBytes = 64;
const unknownKind = 0x6e; // of the link

/**
 * Sets a device up as Linux does.
 * @returns {string[]} its names
 */
export function setUp(host) {
    host.awaitDevice(attachNanos);
    host.reset();
    host.control(request(0x80, 6, 0x0100, 0, 64));
    host.reset();
    host.setAddress(address);
    host.control(request(0x80, 6, 0x0100, 0, 18));
    host.control(request(0x80, 6, 0x0200, 0, 9));
    host.control(request(0x80, 6, 0x0200, 0, 41));
    const names = [1, 2, 3].map((index) => textOf(host.control(request(0x80, 6, 0x0300 | index, 0x0409, 255))));
    host.control(request(0x00, 9, 1));
    host.control(request(0x21, 0x0a));
    host.control(request(0x81, 6, 0x2200, 0, 25));
    return names;
}

/** A computer that sends the device a report in every frame, which mean nothing, and never asks for an answer. */
export class UsbTraffic {
    /** For the report of the run: what the device says of itself, and what became of the reports. */
    told = { names: [], sent: 0, naks: 0 };

    constructor(board) {
        this.board = board;
        this.host = new UsbHost(board);
    }

    /** Goes on until `nanos` since the power came on, or until the board's run ends by itself. */
    run(nanos) {
        try {
            this.told.names = setUp(this.host);
            while (this.board.nanos < nanos)
                this.#sendReport();
        } catch (problem) {
            if (this.board.ending === undefined)
                throw problem;
        }
    }

    #sendReport() {
        const { host, told } = this;
        host.nextFrame();
        const before = host.naks;
        const report = new Uint8Array(reportBytes).fill(told.sent);
        report[0] = unknownKind;
        if (host.sendOnce(1, report) === 'ack')
            ++told.sent;
        told.naks += host.naks - before;
    }
}
