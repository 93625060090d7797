// What the boot loader of the RP2040 says it is: usb_boot_device.c of raspberrypi/pico-bootrom-rp2040, tag b2.

const word = (value) => [value & 0xff, value >>> 8];

const endpoint = (address) => [7, 5, address, 2, ...word(64), 0]; // bulk
const massStorage = [9, 4, 0, 0, 2, 0x08, 0x06, 0x50, 0, ...endpoint(0x81), ...endpoint(0x02)];
const picoboot = [9, 4, 1, 0, 2, 0xff, 0x00, 0x00, 0, ...endpoint(0x03), ...endpoint(0x84)];
const configuration = [9, 2, ...word(9 + massStorage.length + picoboot.length), 2, 1, 0, 0x80, 250, ...massStorage,
    ...picoboot];

/** The last is its serial number: of the ROM, so that all boards have the same. */
const texts = ['', 'Raspberry Pi', 'RP2 Boot', 'E0C9125B0D9B'];
const languages = [4, 3, ...word(0x0409)];

/** Of boot loaders that this knows, by their chips. */
export const products = { rp2040: 0x0003, rp2350: 0x000f };

function device(product) {
    return [18, 1, ...word(0x0110), 0, 0, 0, 64, ...word(0x2e8a), ...word(product), ...word(0x0100), 1, 2, 3, 1];
}

function text(index) {
    const characters = [...Buffer.from(texts[index] ?? texts[0], 'utf16le')];
    return [2 + characters.length, 3, ...characters];
}

/** @returns {number[] | undefined} nothing if there is no such descriptor */
export function descriptor(product, kind, index) {
    switch (kind) {
    case 1:
        return device(product);
    case 2:
        return index === 0 ? configuration : undefined;
    case 3:
        return index === 0 ? languages : text(index);
    default:
        return undefined;
    }
}
