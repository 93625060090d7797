"""Runs the image for a ready configuration of the Pico and compares what its display shows with the preview:

    pico_pictures_test.py <folder of kfast and kfast-panel> <folder of images> <configuration> <scene.kfast>...

Every picture that the board says is a whole frame must have the hash that `kfast hash` gives, and some must equal
those of `kfast render` in every pixel. What the emulator does not heed must be set in the registers all the same."""

import pathlib
import sys
import tempfile

from PIL import Image, ImageChops

from pico import Desk, TICKS, expect

FRAMES = 16
LEAST_WHOLE = 8
SPI, UART, I2C, SIO, PWM, PIO0 = 1, 2, 3, 5, 4, 6  # functions of pins
PULL_UP, INPUT_ENABLE, OUTPUT_DISABLE = 1 << 3, 1 << 6, 1 << 7  # of pads
FUNCTIONS = {"spi": {"clock": SPI, "data": SPI}, "i2c": {"clock": I2C, "data": I2C},
             "parallel": {"clock": PIO0} | {f"D{bit}": PIO0 for bit in range(8)}}
LINES = {"select": SIO, "dc": SIO, "reset": SIO, "backlight": PWM, "log": UART}
WRITE_CYCLE, WRITE_LOW, WRITE_HIGH = 66, 15, 15  # nanoseconds, the shortest that an ILI9341 takes


def check_pictures(run, hashes):
    """Returns the frames that are whole."""
    whole = [(i, shown.ticks // TICKS) for i, shown in enumerate(run.frames) if shown.ticks % TICKS == 0]
    expect(len(whole) >= LEAST_WHOLE, f"of {len(run.frames)} frames only {len(whole)} are whole")
    for i, frame in whole:
        shown = run.frames[i].hash
        expect(shown == hashes[frame], f"frame {frame}: hash {shown} on the display, {hashes[frame]} in the preview")
    return whole


def check_pixels(desk, scene, settings, whole):
    for i, frame in (whole[0], whole[len(whole) // 2], whole[-1]):
        preview = desk.folder / "preview.png"
        desk.kfast("render", scene, "--frame", frame, "--size", settings.size, "--format", settings.format,
                   "-o", preview)
        photo = desk.folder / "shown" / f"{i:04d}.png"
        shown, expected = (Image.open(path).convert("RGB") for path in (photo, preview))
        expect(shown.size == expected.size, f"frame {frame}: {shown.size} instead of {expected.size}")
        difference = ImageChops.difference(shown, expected).getbbox()
        expect(difference is None, f"frame {frame}: display and preview differ within {difference}")


def check_pins(pins, bus):
    for role, wanted in (LINES | FUNCTIONS[bus]).items():
        if role not in pins:
            continue
        pin = pins[role]
        expect(pin["functionSelect"] == wanted, f"{role} has function {pin['functionSelect']}, not {wanted}")
        expect(not pin["pad"] & OUTPUT_DISABLE, f"the pad of {role} drives nothing")


def check_spi(registers):
    spi = registers["spi"]
    expect(spi["SSPCR1"] & 1 << 1, "the SPI unit is not enabled (SSPCR1.SSE)")
    expect(not spi["SSPCR1"] & 1 << 2, "the SPI unit is no master (SSPCR1.MS)")
    expect(spi["SSPDMACR"] & 1 << 1, "the SPI unit does not ask for data (SSPDMACR.TXDMAE)")
    expect(spi["SSPCR0"] & 1 << 7, "the SPI unit leaves a gap after every word (SSPCR0.SPH = 0)")
    expect(bool(spi["SSPCR0"] & 1 << 6) == bool(spi["SSPCR0"] & 1 << 7), "displays know SPI modes 0 and 3 only")


def check_i2c(registers):
    i2c = registers["i2c"]
    expect(i2c["IC_ENABLE"] & 1, "the I2C unit is not enabled")
    expect(i2c["IC_CON"] & 1 << 6 and i2c["IC_CON"] & 1, "the I2C unit is no master alone (IC_CON)")
    for role in ("clock", "data"):
        pad = registers["pins"][role]["pad"]
        expect(pad & PULL_UP and pad & INPUT_ENABLE, f"the pad of {role} is {pad:#x}: pulled up and readable is needed")


def check_parallel(registers, shortest):
    expect(registers["pio"][0][0]["enabled"], "the state machine is not enabled")
    for what, least in (("cycle", WRITE_CYCLE), ("low", WRITE_LOW), ("high", WRITE_HIGH)):
        expect(shortest[what] >= least, f"WR: the {what} took {shortest[what]} ns, the display needs {least}")


def check_registers(report, bus):
    registers = report["registers"]
    expect(registers["clkSys"] == registers["clkPeri"] == 125_000_000, "the chip does not run at 125 MHz")
    expect(registers["watchdogEnabled"], "the watchdog does not watch")
    expect(report["starts"] == 1, f"the chip was started {report['starts']} times")
    check_pins(registers["pins"], bus)
    if bus == "spi":
        check_spi(registers)
    elif bus == "i2c":
        check_i2c(registers)
    else:
        check_parallel(registers, report["shortest"])


def check_scene(desk, settings, source):
    scene = desk.compile(source)
    run = desk.run(settings, scene, "--frames", FRAMES, "--for", 4000, pictures=desk.folder / "shown")
    expect(run.report["ending"] == "enough frames", f"{len(run.frames)} frames in 4 s; the board told {run.log[-5:]}")
    whole = check_pictures(run, desk.hashes(scene, settings))
    check_pixels(desk, scene, settings, whole)
    check_registers(run.report, settings.bus)
    return len(whole)


def main(programs, images, configuration, *scenes):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        desk = Desk(programs, images, folder)
        settings = desk.settings(configuration)
        compared = [check_scene(desk, settings, source) for source in scenes]
    names = ", ".join(pathlib.Path(source).stem for source in scenes)
    print(f"{configuration} shows {names} as the preview does: {sum(compared)} frames compared")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"the Pico's display is wrong: {failure}")
