import { fail } from './emulation_error.mjs';

const IC_TAR = 0x04;
const IC_INTR_MASK = 0x30;
const IC_SDA_HOLD = 0x7c;
const IC_DMA_CR = 0x88;
const IC_DMA_TDLR = 0x8c;
const IC_DMA_RDLR = 0x90;
const TX_EMPTY = 1 << 4; // interrupt
const IC_DMA_CR_TDMAE = 1 << 1;
const DREQ_I2C0_TX = 32; // that of I2C1 is two further on
const bitsOfByte = 9; // with the acknowledgement

/**
 * Makes one of the emulator's I2C units take the time of its bits, and gives it what rp2040js lacks: DMA requests,
 * interrupts that can be enabled, of which the one for more bytes stays while they are few, and a hold time. Only
 * writing is modelled.
 *
 * @param {{start(address: number): boolean, byte(value: number, nanos: number): void, stop(): void}} wire
 *     what is on the bus; start() tells whether somebody answers. byte() is called when the byte has arrived; `nanos`
 *     is how long it took
 */
export function timeI2c(mcu, index, wire) {
    const i2c = mcu.i2c[index];
    let then = () => {};
    const alarm = mcu.clock.createAlarm(() => then());
    const after = (bits, next) => {
        then = next;
        alarm.schedule(bits * bitNanos(i2c, 1e9 / mcu.clkSys));
    };
    i2c.onStart = () => after(1, () => i2c.completeStart());
    i2c.onConnect = (address) => after(bitsOfByte, () => i2c.completeConnect(wire.start(address)));
    i2c.onWriteByte = (value) => after(bitsOfByte, () => {
        wire.byte(value, bitsOfByte * bitNanos(i2c, 1e9 / mcu.clkSys));
        i2c.completeWrite(true);
    });
    i2c.onReadByte = () => fail(`${i2c.name} reads, which is not modelled`);
    i2c.onStop = () => after(1, () => {
        wire.stop();
        i2c.completeStop();
    });
    addRegisters(mcu, i2c, DREQ_I2C0_TX + 2 * index);
}

function bitNanos(i2c, clockNanos) {
    const high = i2c.sclHighPeriod + i2c.spikelen + 7;
    const low = i2c.sclLowPeriod + 1;
    return (high + low) * clockNanos;
}

function addRegisters(mcu, i2c, request) {
    const registers = new Map([[IC_SDA_HOLD, 1], [IC_DMA_CR, 0], [IC_DMA_TDLR, 0], [IC_DMA_RDLR, 0]]);
    const isLow = (level) => i2c.txFIFO.itemCount <= level;
    const settle = () => {
        if (registers.get(IC_DMA_CR) & IC_DMA_CR_TDMAE && isLow(registers.get(IC_DMA_TDLR)))
            mcu.dma.setDREQ(request);
        else
            mcu.dma.clearDREQ(request);
        i2c.intRaw = i2c.enable & 1 && isLow(i2c.txThreshold) ? i2c.intRaw | TX_EMPTY : i2c.intRaw & ~TX_EMPTY;
        i2c.checkInterrupts();
    };
    const { readUint32, writeUint32, nextCommand } = i2c;
    i2c.nextCommand = () => {
        nextCommand.call(i2c);
        settle();
    };
    i2c.readUint32 = (offset) => registers.get(offset) ?? readUint32.call(i2c, offset);
    i2c.writeUint32 = (offset, value) => {
        if (offset === IC_TAR && i2c.enable & 1)
            fail(`${i2c.name} is given another address while it is enabled`);
        if (offset === IC_INTR_MASK)
            i2c.intEnable = value;
        else if (registers.has(offset))
            registers.set(offset, value);
        else
            writeUint32.call(i2c, offset, value);
        settle();
    };
}
