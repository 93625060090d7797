import { UsbHost, request, textOf } from './usb_host.mjs';

const attachNanos = 100e6;
const address = 9;
const reportBytes = 64;

/** A computer that sets the device up as Linux does, and then sends it a report in every frame. */
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
            this.#setUp();
            while (this.board.nanos < nanos)
                this.#sendReport();
        } catch (problem) {
            if (this.board.ending === undefined)
                throw problem;
        }
    }

    #setUp() {
        const { host } = this;
        host.awaitDevice(attachNanos);
        host.reset();
        host.control(request(0x80, 6, 0x0100, 0, 64));
        host.reset();
        host.setAddress(address);
        host.control(request(0x80, 6, 0x0100, 0, 18));
        host.control(request(0x80, 6, 0x0200, 0, 9));
        host.control(request(0x80, 6, 0x0200, 0, 41));
        this.told.names = [1, 2, 3].map((index) => textOf(host.control(request(0x80, 6, 0x0300 | index, 0x0409, 255))));
        host.control(request(0x00, 9, 1));
        host.control(request(0x21, 0x0a));
        host.control(request(0x81, 6, 0x2200, 0, 25));
    }

    #sendReport() {
        const { host, told } = this;
        host.nextFrame();
        const before = host.naks;
        if (host.sendOnce(1, new Uint8Array(reportBytes).fill(told.sent)) === 'ack')
            ++told.sent;
        told.naks += host.naks - before;
    }
}
