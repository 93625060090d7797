"""Has a user of a Linux computer for arm64 play scenes on displays that are wired to its GPIO lines:

    arm64_panel_test.py <folder of programs> <kfast for arm64> <folder of its libraries> <folder of the guest>

What arrives at the lines is what the preview shows."""

import pathlib
import re
import subprocess
import sys
import tempfile

from PIL import Image, ImageChops

from gpio_machine import CHIP_LABEL, GpioMachine
from linux_guest import LinuxGuest, quoted
from pico import HERE, expect
from spi_display import LOOK, sections

SPI_GROUP, GPIO_GROUP = 2001, 2002
STILL_SECONDS = 5

OLED = {"panel": ["--panel", "ssd1306"], "board": "panel ssd1306 128 64", "picture": ["--panel", "ssd1306"]}
SMALL_TFT = {"panel": ["--panel", "st7735", "--glass", "80x160", "--column", "26", "--row", "1", "--inverted"],
             "board": "panel st7735 80 160 column=26 row=1 colours=bgr inverted=#true",
             "picture": ["--size", "80x160", "--format", "rgb565"]}

OLED_FRAMES, TFT_FRAMES = 12, 4

TASK = f"""
set -e
mount -t debugfs debug /sys/kernel/debug
cp /task/kfast /task/*.kfb /computer/run
cd /sys/class/gpio
mark=$(($(cat gpiochip*/base) + 7))
echo $mark > export
echo out > gpio$mark/direction
section() {{
    echo 0 > /sys/class/gpio/gpio$mark/value
    echo 1 > /sys/class/gpio/gpio$mark/value
}}
panel() {{ as_user kfast panel "$@"; }}
tell_status() {{
    status=0
    "$@" 2>&1 || status=$?
    echo "STATUS $status"
}}
on_oled="{quoted('--spi', '/dev/spidev0.0', *OLED['panel'], '--pin', 'dc=0', '--pin', 'reset=1')}"
is_lit() {{ grep -q 'BACKLIGHT.*kfast.*out hi' /sys/kernel/debug/gpio; }}
has_lines() {{ grep -q kfast /sys/kernel/debug/gpio; }}

user_groups=1000
tell_status panel steps.kfb $on_oled
chgrp {SPI_GROUP} /dev/spidev0.0
chgrp {GPIO_GROUP} /dev/gpiochip0
chmod 660 /dev/spidev0.0 /dev/gpiochip0
user_groups={SPI_GROUP}
tell_status panel steps.kfb $on_oled
user_groups={SPI_GROUP},{GPIO_GROUP}

section
panel steps.kfb $on_oled --gpio-chip {CHIP_LABEL} --frames {OLED_FRAMES}
section
panel steps.kfb --spi /dev/spidev0.0 {quoted(*SMALL_TFT['panel'])} --gpio-chip /dev/gpiochip0 \\
    --pin dc=DC --pin reset=RESET --pin backlight=BACKLIGHT --frames {TFT_FRAMES}

as_user kfast preview still.kfb --loops 1 2>&1 >/dev/null

section
tell_status panel still.kfb $on_oled --pin backlight=BACKLIGHT &
eventually is_lit
cpu_time() {{ cut -d' ' -f1 /proc/$(pidof kfast)/schedstat; }}
begin=$(cpu_time)
sleep {STILL_SECONDS}
echo "CPU $(($(cpu_time) - begin))"
kill -TERM $(pidof kfast)
wait
! has_lines
"""


class Bench:
    """What was at the pins in the sections of a run, and what is expected there."""

    def __init__(self, programs, folder):
        self._programs = pathlib.Path(programs)
        self._folder = pathlib.Path(folder)

    def call(self, program, *arguments):
        done = subprocess.run([str(self._programs / program), *map(str, arguments)], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=600, check=False)
        expect(done.returncode == 0, f"{program}: {done.stderr.strip()}")
        return done.stdout

    def compile(self, name):
        compiled = self._folder / f"{name}.kfb"
        self.call("kfast", "compile", HERE / f"{name}.kfast", "-o", compiled)
        return compiled

    def hashes(self, scene, display):
        told = self.call("kfast", "hash", scene, *display["picture"])
        return [line.split()[1] for line in told.splitlines()]

    def rendered(self, scene, display, frame):
        path = self._folder / "expected.png"
        self.call("kfast", "render", scene, *display["picture"], "--frame", frame, "-o", path)
        return Image.open(path).convert("RGB")

    def looks(self, section, display):
        """What the display showed: hashes, and the folder of the pictures."""
        settings, record = self._folder / "board.kdl", self._folder / "record.bin"
        settings.write_text(f"board pico {{\n    {display['board']}\n    bus spi\n"
                            "    pins clock=18 data=19 select=17 dc=16 reset=20\n}\n", encoding="utf-8")
        self.call("kfast", "config", settings, "-o", record)
        trace, pictures = self._folder / "trace.kft", self._folder / "pictures"
        trace.write_bytes(section.trace)
        told = self.call("kfast-panel", trace, record, "--pictures", pictures)
        return [line.split()[-1] for line in told.splitlines() if line.startswith(LOOK.decode())], pictures


def shown_frames(console):
    """How many frames kfast says that it has shown, and left out, for each time that it was run."""
    found = [re.search(r"(\d+) frames shown, (\d+) left out", line) for line in console]
    return [(int(match[1]), int(match[2])) for match in found if match]


def expect_frames(looks, hashes, shown, left_out):
    """That `looks` has so many frames of the scene, one after the other; the looks at which they were complete. Between
    them the display has parts of two."""
    expect(len(set(hashes)) == len(hashes) >= shown + left_out, "the scene is too short to tell its frames apart")
    number_of = {value: number for number, value in enumerate(hashes)}
    complete, frame = [], -1
    for place, look in enumerate(looks):
        if number_of.get(look, -1) > frame:
            complete.append(place)
            frame = number_of[look]
    expect(len(complete) == shown and frame == shown + left_out - 1,
           f"{len(complete)} frames arrive, up to {frame}, but {shown} were shown and {left_out} left out")
    return complete


def picture(folder, number):
    return Image.open(folder / f"{number:04}.png").convert("RGB")


def expect_dark(folder, looks):
    expect(picture(folder, len(looks) - 1).getbbox() is None, "the display is not dark at the end")


def check_playing(bench, section, scene, display, told):
    shown, left_out = told
    looks, pictures = bench.looks(section, display)
    hashes = bench.hashes(scene, display)
    complete = expect_frames(looks, hashes, shown, left_out)
    expected = bench.rendered(scene, display, shown + left_out - 1)
    expect(ImageChops.difference(picture(pictures, complete[-1]), expected).getbbox() is None,
           "the last frame is another picture than kfast render draws")
    expect_dark(pictures, looks)
    expect(section.resets == 1, f"the display was reset {section.resets} times")
    return section.looks[complete[0]]


def check_backlight(section, first_picture):
    levels = [level for _, level in section.backlight]
    expect(levels == [True, False], f"the backlight goes {levels}")
    expect(section.backlight[0][0] >= first_picture, "the backlight is on before there is a picture")


def check_still(bench, section, scene, display):
    """One picture, and nothing more until the display goes to sleep."""
    looks, pictures = bench.looks(section, display)
    (hash_of_all,) = set(bench.hashes(scene, display))
    first = looks.index(hash_of_all)
    check_backlight(section, section.looks[first])
    expect(section.last_data < section.looks[first], "the display is sent what it shows already")
    expect_dark(pictures, looks)


def expect_refused(linux, device):
    expect(device in linux.wait_for("you may not open"), f"the missing permission is not that for {device}")
    expect_status(linux, 4)


def expect_status(linux, status):
    told = linux.wait_for("STATUS")
    expect(told == f"STATUS {status}", f"kfast ends with {told}, not {status}")


def main(programs, kfast, root, guest):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder, GpioMachine(root) as board:
        bench = Bench(programs, folder)
        steps, still = bench.compile("steps"), bench.compile("still")
        with LinuxGuest(guest, TASK, board.machine(), [kfast, steps, still]) as linux:
            board.watch()
            expect_refused(linux, "/dev/spidev0.0")
            expect_refused(linux, "/dev/gpiochip0")
            linux.wait_for("this kfast was built without windows, so this plays in the terminal")
            used = int(linux.wait_for("CPU").split()[1]) / 1e9
            expect_status(linux, 0)
        on_oled, on_tft, at_rest = sections(board.edges())
        told = shown_frames(linux.console)
        check_playing(bench, on_oled, steps, OLED, told[0])
        check_backlight(on_tft, check_playing(bench, on_tft, steps, SMALL_TFT, told[1]))
        check_still(bench, at_rest, still, OLED)
        print(f"frames shown and left out: {told}; CPU for a still scene: {used / STILL_SECONDS:.1%}")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"Linux: {failure}")
