"""Plugs the Pico's images into a computer that is as strict as USB (rp2040/usb_host.mjs):

    pico_usb_test.py <folder of kfast and kfast-panel> <folder of images> <scene>

A trial image answers whatever a computer may ask (pico_usb_test.mjs). The real ones play a scene as if nothing was there
while reports come that mean nothing, and never let the computer wait."""

import pathlib
import subprocess
import sys
import tempfile

from pico import HERE, Desk, expect, expect_scene

CONFIGURATIONS = ("pico-st7789", "pico-ssd1306-i2c", "pico-ili9341-parallel")
FRAMES = 25
# The strings of the device; the number is that of the emulated flash chip (rp2040/flash_chip.mjs).
NAMES = ["KFAST", "KFAST Pico", "E4613852C71B9D0F"]


def check_trial(images):
    done = subprocess.run(["node", HERE / "pico_usb_test.mjs", images / "pico-usb-trial.bin"], stdout=subprocess.PIPE,
                          text=True, timeout=300, check=False)
    expect(done.returncode == 0, f"the trial image:\n{done.stdout}")


def check_image(desk, configuration, source):
    settings = desk.settings(configuration)
    scene = desk.compile(source)
    hashes = desk.hashes(scene, settings)
    run = desk.run(settings, scene, "--frames", FRAMES, "--for", 3000, "--usb")
    usb = run.report["usb"]
    expect(usb["names"] == NAMES, f"{configuration} calls itself {usb['names']}")
    expect(len(run.frames) == FRAMES, f"{configuration} shows {len(run.frames)} frames")
    expect_scene(run.frames, hashes, f"{configuration}, while reports come,")
    expect(usb["sent"] > 100, f"{configuration} takes {usb['sent']} reports")
    expect(usb["naks"] == 0, f"{configuration} lets the computer wait {usb['naks']} times")
    return usb


def check_blinking(desk, scene):
    """Without settings that can be read nothing is shown, but a computer finds the board."""
    settings = desk.settings("pico-st7789")
    usb = desk.run(settings, scene, "--for", 300, "--usb", "--patch", f"{0x3F000 + 22}=99").report["usb"]
    expect(usb["names"] == NAMES and usb["naks"] == 0 and usb["sent"] > 200, f"a board without settings: {usb}")


def main(programs, images, source):
    images = pathlib.Path(images)
    check_trial(images)
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        desk = Desk(programs, images, folder)
        for configuration in CONFIGURATIONS:
            usb = check_image(desk, configuration, source)
            print(f"{configuration}: {usb['sent']} reports while {FRAMES} frames were shown")
        check_blinking(desk, desk.compile(source))


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"USB: {failure}")
