"""Flash, RAM and stack of the boards' images, beside what is recorded in image_table.json:

    image_table.py <folder of builds> <kfast> [--record]

An image that takes more than 1 % more flash, 64 bytes more RAM or 64 bytes more stack fails; on a Pico, whose code runs in
RAM, it may take 1 % more of that, too. So does one that takes 5 %
less flash, since what is recorded would hide growth then. --record keeps the figures, and writes them into
docs/benchmarks.md.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "bench"))
import board_stack  # pylint: disable=wrong-import-position
import images  # pylint: disable=wrong-import-position

RECORDED = pathlib.Path(__file__).with_name("image_table.json")
DOCUMENT = ROOT / "docs" / "benchmarks.md"
BEGIN, END = "<!-- images: tests/sizes/image_table.py writes these -->\n", "<!-- end of images -->\n"
IMAGES = [f"lm3s6965evb/lm3s6965evb-{cpu}" for cpu in images.BOARD_CPUS]
IMAGES += [f"vexpress-a9/vexpress-a9-{size}" for size in ("240x240", "320x240")]
IMAGES += [f"pico/pico-{bus}" for bus in ("spi", "i2c", "parallel", "xy")]
# The stack is looked at where a machine can show it, with a scene of bones, for a second and a half.
STACK_SCENE, STACK_FRAMES = ROOT / "examples" / "stroller.kfast", 30
SLACK_BYTES = 64


def measured(builds, kfast):
    """What each image takes, by its name."""
    table = {}
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        scene = pathlib.Path(folder, "scene.kfb")
        subprocess.run([kfast, "compile", STACK_SCENE, "-o", scene], check=True, stdout=subprocess.DEVNULL, timeout=120)
        for name in IMAGES:
            image = builds / f"{name}.elf"
            figures = {"flash": images.flash_bytes(image), "ram": images.static_bytes(image)}
            if name.startswith("lm3s6965evb"):
                cpu = name.removeprefix("lm3s6965evb/lm3s6965evb-")
                figures["stack"] = board_stack.stack_used(image, cpu, scene, STACK_FRAMES)
            table[name.split("/")[1]] = figures
    return table


def complaints(recorded, found):
    """What differs too much, one line each."""
    lines = []
    for name in sorted(recorded.keys() | found.keys()):
        if name not in found or name not in recorded:
            lines.append(f"{name}: {'not recorded' if name in found else 'not measured'}")
            continue
        for what, bytes_before in recorded[name].items():
            now = found[name].get(what)
            has_code = what == "flash" or (what == "ram" and name.startswith("pico"))
            slack = bytes_before // 100 if has_code else SLACK_BYTES
            if now is None or now > bytes_before + slack:
                lines.append(f"{name}: {what}: {now} bytes instead of {bytes_before}")
            elif what == "flash" and now < bytes_before * 95 // 100:
                lines.append(f"{name}: flash: {now} bytes, much less than the {bytes_before} that are recorded")
    return lines


def markdown(table):
    rows = ["| image | flash | static RAM | stack with the stroller |", "| --- | ---: | ---: | ---: |"]
    for name, figures in table.items():
        stack = f"{figures['stack']:,}" if "stack" in figures else ""
        rows.append(f"| `{name}` | {figures['flash']:,} | {figures['ram']:,} | {stack} |")
    return "\n".join(rows) + "\n"


def with_table(document, table):
    before, rest = document.split(BEGIN)
    return before + BEGIN + "\n" + markdown(table) + "\n" + END + rest.split(END)[1]


def main(builds, kfast, *options):
    missing = [name for name in IMAGES if not (builds / f"{name}.elf").is_file()]
    if missing:
        print("Missing, build the boards first:", *missing)
        return 1
    found = measured(builds, kfast)
    if "--record" in options:
        RECORDED.write_text(json.dumps(found, indent=4) + "\n", encoding="utf-8")
        DOCUMENT.write_text(with_table(DOCUMENT.read_text(encoding="utf-8"), found), encoding="utf-8")
        return 0
    recorded = json.loads(RECORDED.read_text(encoding="utf-8"))
    lines = complaints(recorded, found)
    if DOCUMENT.read_text(encoding="utf-8") != with_table(DOCUMENT.read_text(encoding="utf-8"), recorded):
        lines.append("docs/benchmarks.md shows other figures than are recorded")
    for line in lines:
        print(line)
    if lines:
        print("Where that is meant: python3 tests/sizes/image_table.py build build/host/bin/kfast --record")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), *sys.argv[2:]))
