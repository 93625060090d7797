"""Boots the Pico's images in the emulator, in order and not:

    pico_boot_test.py <folder of kfast and kfast-panel> <folder of images> <scene.kfast>

The boot block runs where the boot ROM puts it and sets up the flash interface; a damaged one is refused. Without a
scene, with a damaged one and with settings for another image, the board says so. With settings that it cannot read it
touches no pin. A display on I2C that was interrupted is set free, and one that does not answer
is told of."""

import struct
import sys
import tempfile
import zlib

from PIL import Image

from card_text import lines_on
from pico import Desk, expect

FLASH_HERTZ = 50_000_000  # that any chip bears with command 03h
VECTORS = 0x10000100
SETTINGS = 0x3F000  # offset in flash
RECORD_BYTES = 286
LED = 25


def check_boot_block(desk, settings, scene):
    report = desk.run(settings, scene, "--frames", 1).report
    block = report["bootBlock"]
    writes = block["writes"]
    expect(block["cycles"] > 0 and block["vectors"] == VECTORS, f"the boot block ends with VTOR {block['vectors']:#x}")
    expect(writes[0] == ["SSIENR", 0] and writes[-1] == ["SSIENR", 1], f"the flash interface is not switched: {writes}")
    final = {"BAUDR": 2, "CTRLR0": None, "SPI_CTRLR0": None} | dict(map(tuple, writes))
    expect(125_000_000 / final["BAUDR"] <= FLASH_HERTZ, f"flash is clocked by 1/{final['BAUDR']} of 125 MHz")
    expect(final["CTRLR0"] == 31 << 16 | 3 << 8 and final["SPI_CTRLR0"] == 0x03000218, f"flash is read oddly: {writes}")
    expect(report["flash"]["operations"] == [], "the board wrote to flash")


def check_damaged_boot_block(desk, settings, scene):
    image = desk.image(settings)
    for offset in (0, 100, 255):
        flipped = image.read_bytes()[offset] ^ 0x10
        run = desk.run(settings, scene, "--patch", f"{offset}={flipped}")
        expect(run.report["ending"] == "the boot block was refused", f"byte {offset} is wrong: {run.report['ending']}")
        expect(run.report["cycles"] == 0 and run.log == [], "the board ran all the same")


def last_picture(desk, settings, scene=None, *options):
    """What is on the display when nothing happens any more, and the log."""
    shown = desk.folder / "shown"
    run = desk.run(settings, scene, "--for", 900, *options, pictures=shown, look_at_end=True)
    return Image.open(sorted(shown.iterdir())[-1]).convert("RGB"), run.log


def check_test_card(desk, configuration, rotation):
    settings = desk.settings(configuration, lambda text: text.replace("240 240", f"240 240 rotation={rotation}"))
    picture, log = last_picture(desk, settings)
    width, height = picture.size
    border = [(x, y) for x in range(width) for y in (0, height - 1)]
    border += [(x, y) for y in range(height) for x in (0, width - 1)]
    expect(all(picture.getpixel(place) == (255, 255, 255) for place in border), "the frame at the border is not whole")
    text = lines_on(picture)
    for words in ("^ TOP ^", "PICO", settings.controller.upper(), settings.size.upper(), "NO SCENE"):
        expect(words in text, f"the test card says {text}, not {words}; the board told {log}")
    check_bars(picture)


def check_bars(picture):
    """From left to right red, green, blue, somewhere below the middle."""
    wanted = [(255, 0, 0), (0, 255, 0), (0, 0, 255)]
    width, height = picture.size
    rows = ([colour for colour in (picture.getpixel((x, y)) for x in range(width)) if colour in wanted]
            for y in range(height // 2, height))
    found = next((row for row in rows if row), [])
    order = [colour for i, colour in enumerate(found) if i == 0 or found[i - 1] != colour]
    expect(order == wanted, f"the bars are {order}")


def check_damaged_scene(desk, settings, scene):
    damaged = bytearray(scene.read_bytes())
    damaged[len(damaged) // 2] ^= 0x10
    (desk.folder / "damaged.kfb").write_bytes(damaged)
    picture, log = last_picture(desk, settings, desk.folder / "damaged.kfb")
    errors = [line.removeprefix("ERROR ") for line in log if line.startswith("ERROR ")]
    expect(len(errors) == 1 and "checksum" in errors[0], f"the board told {log}")
    number, *words = lines_on(picture)
    expect(number == "E4", f"the display shows the number {number}")
    shown = " ".join(word or "?" for word in words)
    expect(shown == errors[0].upper().replace("_", " "), f"the display says {shown!r}, the log {errors[0]!r}")


def check_other_bus(desk):
    settings = desk.settings("pico-ssd1306-i2c")
    run = desk.run(settings, None, "--for", 200, image=desk.image(desk.settings("pico-st7789")))
    expect(any("i2c" in line and "spi" in line for line in run.log if line.startswith("ERROR")), f"it told {run.log}")
    expect(run.report["frames"] == [], "it sent something all the same")


def patches(offset, data):
    return [word for i, byte in enumerate(data) for word in ("--patch", f"{SETTINGS + offset + i}={byte}")]


def changed_record(record, offset, byte):
    """Patches that change a byte of the record, which stays whole."""
    changed = bytearray(record[:-4])
    expect(struct.unpack("<I", record[-4:]) == (zlib.crc32(changed),), "the record ends elsewhere")
    changed[offset] = byte
    return patches(offset, [byte]) + patches(len(changed), struct.pack("<I", zlib.crc32(changed)))


def check_wrong_settings(desk, settings):
    record = settings.record.read_bytes()[:RECORD_BYTES]
    select, dc = 24, 25
    run = desk.run(settings, None, "--for", 200, *changed_record(record, dc, record[select]))
    errors = [line for line in run.log if line.startswith("ERROR")]
    expect(len(errors) == 1 and "a pin is taken twice" in errors[0], f"with two roles on a pin it told {run.log}")
    expect(run.report["commands"] == [], "it sent something all the same")


def check_unreadable_settings(desk, settings, scene):
    record = settings.record.read_bytes()[:RECORD_BYTES]
    cases = {"damaged": patches(22, [record[22] ^ 1]), "of a newer version": changed_record(record, 4, 2),
             "all but blank": ["--wired-only", *patches(len(record) - 1, [0xFE])]}
    for name, options in cases.items():
        report = desk.run(settings, scene, "--for", 1800, *options).report
        pins, turns = report["connectedPins"], report["ledTurns"]
        expect(pins == [LED], f"settings {name}: the pins {pins} are driven")
        expect(report["log"] == [] and report["commands"] == [], f"settings {name}: something was sent all the same")
        expect(len(turns) > 3 and all(abs(b - a - 500) < 1 for a, b in zip(turns[-3:], turns[-2:])),
               f"settings {name}: the light turns at {turns} ms")


def check_blank_settings(desk, settings):
    """The default ones count, which are those of the configuration but for its log."""
    picture, log = last_picture(desk, settings, None, "--wired-only")
    expect("NO SCENE" in lines_on(picture) and log == [], f"the display says {lines_on(picture)}")


def check_interrupted_display(desk, scene):
    settings = desk.settings("pico-ssd1306-i2c")
    first, *_ = desk.hashes(scene, settings)
    for clocks in (1, 9):
        run = desk.run(settings, scene, "--frames", 1, "--hold-data", clocks)
        expect([shown.hash for shown in run.frames] == [first], f"SDA held for {clocks} clocks: the board told {run.log}")


def check_absent_display(desk, scene):
    """What nobody sees goes on all the same."""
    elsewhere = desk.settings("pico-ssd1306-i2c", lambda text: text.replace("0x3C", "0x3D"))
    run = desk.run(elsewhere, scene, "--frames", 20, "--address", 0x3C)
    expect(len(run.report["frames"]) == 20 and run.report["starts"] == 1, f"it stops without a display: {run.log}")
    errors = [line for line in run.log if line.startswith("ERROR")]
    expect(errors == ["ERROR no display answers at 0x3D"], f"without a display the board tells {errors}")
    settings = desk.settings("pico-ssd1306-i2c")
    report = desk.run(settings, scene, "--for", 900, "--absent", "300-400", "--absent", "600-700").report
    times = [at for at, line in report["log"] if line == "ERROR no display answers at 0x3C"]
    expect(len(times) == 2, f"a display that goes twice is told of at {times}")
    expect(len(report["frames"]) > 20, f"only {len(report['frames'])} frames")


def main(programs, images, source):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        desk = Desk(programs, images, folder)
        settings = desk.settings("pico-st7789")
        scene = desk.compile(source)
        check_boot_block(desk, settings, scene)
        check_damaged_boot_block(desk, settings, scene)
        check_damaged_scene(desk, settings, scene)
        check_test_card(desk, "pico-gc9a01", 0)
        for rotation in (90, 180, 270):
            check_test_card(desk, "pico-st7789", rotation)
        check_other_bus(desk)
        check_wrong_settings(desk, settings)
        check_unreadable_settings(desk, settings, scene)
        check_blank_settings(desk, settings)
        check_interrupted_display(desk, scene)
        check_absent_display(desk, scene)
    print("the Pico boots, and says what is wrong")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"the Pico does not start rightly: {failure}")
