import { fail } from './emulation_error.mjs';

const SSPCR1 = 0x04;
const SSPDMACR = 0x24;
const SSPCR1_MS = 1 << 2; // set: slave
const SSPDMACR_TXDMAE = 1 << 1;
const SSPCR0_SPH = 1 << 7;
const SSPCR0_FRF = 3 << 4;

/**
 * Bit times between frames with SPH = 0, where the unit releases its own select line: users of the chip measured
 * "about 2". With SPH = 1 frames follow without a gap.
 */
export const gapBits = 2;

/**
 * Makes one of the emulator's SPI units take the time of its bits, stand while it is disabled, and ask for DMA only
 * when it is told to.
 *
 * @param {{begin(word: number, bits: number): void, end(nanos: number): void}} wire is told of each frame when it
 *     begins and when its last bit is through; `nanos` is how long its bits took
 */
export function timeSpi(mcu, spi, wire) {
    let bitNanos = 0;
    const frame = mcu.clock.createAlarm(() => {
        wire.end(bitNanos * spi.dataBits);
        spi.completeTransmit(0);
    });
    spi.onTransmit = (word) => {
        checkSettings(spi);
        bitNanos = 1e9 / spi.clockFrequency;
        wire.begin(word, spi.dataBits);
        frame.schedule(bitNanos * (spi.dataBits + (spi.control0 & SSPCR0_SPH ? 0 : gapBits)));
    };
    const doTX = spi.doTX.bind(spi);
    spi.doTX = () => spi.enabled && doTX();
    const updateDMATx = spi.updateDMATx.bind(spi);
    spi.updateDMATx = () => (spi.dmaControl & SSPDMACR_TXDMAE && spi.enabled ? updateDMATx()
        : mcu.dma.clearDREQ(spi.dreq.tx));
    spi.updateDMATx();
    const write = spi.writeUint32.bind(spi);
    spi.writeUint32 = (offset, value) => {
        write(offset, value);
        if (offset === SSPCR1 || offset === SSPDMACR) {
            spi.doTX();
            spi.updateDMATx();
        }
    };
}

function checkSettings(spi) {
    if (spi.control1 & SSPCR1_MS)
        fail(`${spi.name} sends as a slave`);
    if (spi.control0 & SSPCR0_FRF)
        fail(`${spi.name} sends in a format that no display understands`);
    if (!spi.clockFrequency || !spi.rp2040.clocks.periFreq)
        fail(`${spi.name} sends without a clock`);
}
