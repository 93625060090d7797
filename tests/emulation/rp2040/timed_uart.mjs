import { fail } from './emulation_error.mjs';

const UARTFR = 0x18;
const UARTICR = 0x44;
const UARTDMACR = 0x48;
const UARTFR_BUSY = 1 << 3;
const UARTFR_TXFF = 1 << 5;
const UARTFR_TXFE = 1 << 7;
const TXIM = 1 << 5;
const fifoBytes = 32;
const interruptLevel = fifoBytes / 2; // UARTIFLS after reset
const bitsPerByte = 10;

/**
 * Makes one of the emulator's UARTs take the time of its bits: bytes wait in the FIFO, one that finds it full ends the
 * run, and the interrupt for more comes when the FIFO has become half empty.
 * @param {(byte: number) => void} sent told of each byte when it is written
 */
export function timeUart(mcu, uart, sent) {
    new TimedUart(mcu, uart, sent);
}

class TimedUart {
    #waiting = 0; // with the byte that is on its way

    constructor(mcu, uart, sent) {
        Object.assign(this, { mcu, uart, sent });
        this.alarm = mcu.clock.createAlarm(() => this.#byteSent());
        uart.onByte = (byte) => this.#take(byte);
        uart.checkInterrupts = () => mcu.setInterrupt(uart.irq, !!(uart.interruptStatus & uart.interruptMask));
        const read = uart.readUint32.bind(uart);
        const write = uart.writeUint32.bind(uart);
        uart.readUint32 = (offset) => (offset === UARTFR ? (read(offset) & ~UARTFR_TXFE) | this.#flags()
            : read(offset));
        uart.writeUint32 = (offset, value) => {
            if (offset === UARTDMACR || offset === UARTICR)
                fail(`${uart.name}: DMA and clearing interrupts are not modelled`);
            write(offset, value);
        };
    }

    #take(byte) {
        const { uart } = this;
        if (!uart.enabled || !uart.txEnabled || !uart.fifosEnabled || !uart.baudDivider || !this.mcu.clocks.periFreq)
            fail(`${uart.name} is given a byte, but is not set up`);
        if (this.#waiting > fifoBytes)
            fail(`${uart.name} is given a byte that its FIFO has no room for`);
        this.sent(byte);
        if (this.#waiting++ === 0)
            this.#sendNext();
        if (this.#waiting - 1 > interruptLevel)
            this.#interrupt(false);
    }

    #sendNext() {
        this.alarm.schedule((bitsPerByte * 1e9) / this.uart.baudRate);
    }

    #byteSent() {
        if (--this.#waiting > 0)
            this.#sendNext();
        if (this.#waiting - 1 === interruptLevel)
            this.#interrupt(true);
    }

    #interrupt(raised) {
        const { uart } = this;
        uart.interruptStatus = raised ? uart.interruptStatus | TXIM
            : uart.interruptStatus & ~TXIM;
        uart.checkInterrupts();
    }

    #flags() {
        return (this.#waiting > 0 ? UARTFR_BUSY : 0) | (this.#waiting > fifoBytes ? UARTFR_TXFF : 0)
            | (this.#waiting <= 1 ? UARTFR_TXFE : 0);
    }
}
