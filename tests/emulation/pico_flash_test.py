"""Lets the Pico change its flash in the emulator, where flash is NOR flash and the boot ROM's functions ask for what
the real ones need (rp2040/boot_rom.mjs):

    pico_flash_test.py <folder of kfast and kfast-panel> <folder of images>

Two sectors are erased, two pages across their border programmed, one sector erased again; what the program reads after
each step is what must be there, and nothing else was touched."""

import pathlib
import sys
import tempfile
import zlib

from pico import Desk, expect

PLACE = 0x100000
SECTOR = 4096
PAGE = 256
ERASE_TIME = 45  # ms, for a sector


def checksum(flash):
    return f"{zlib.crc32(flash):08x}"


def main(programs, images):
    with tempfile.TemporaryDirectory(prefix="kfast") as name:
        desk = Desk(programs, images, name)
        settings = desk.settings("pico-st7789")
        image = pathlib.Path(images) / "pico-flash-trial.bin"
        run = desk.run(settings, None, "--patch", f"{PLACE + 5}=0", "--patch", f"{PLACE + SECTOR + 9}=17", "--for", 400,
                       image=image)

    flash = bytearray(b"\xff" * 2 * SECTOR)
    flash[5], flash[SECTOR + 9] = 0, 17
    expected = [f"BEFORE {checksum(flash)}"]
    flash = bytearray(b"\xff" * 2 * SECTOR)
    expected.append(f"ERASED {checksum(flash)}")
    flash[SECTOR - PAGE:SECTOR + PAGE] = bytes(7 * i & 255 for i in range(2 * PAGE))
    expected.append(f"PROGRAMMED {checksum(flash)}")
    flash[:SECTOR] = b"\xff" * SECTOR
    expected.append(f"HALF {checksum(flash)}")
    expect(run.log == expected, f"the board reads {run.log}, there must be {expected}")

    times = {text.split()[0]: moment / 1e6 for moment, text in run.report["log"]}
    expect(times["ERASED"] - times["BEFORE"] > 2 * ERASE_TIME, f"two sectors are erased within {times} ms")

    operations = run.report["flash"]["operations"]
    expect(operations == [["erase", PLACE, SECTOR], ["erase", PLACE + SECTOR, SECTOR],
                          ["program", PLACE + SECTOR - PAGE, 2 * PAGE], ["erase", PLACE, SECTOR]], f"{operations}")
    print("flash is erased and programmed as it was to be")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"flash: {failure}")
