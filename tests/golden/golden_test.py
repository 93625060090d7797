"""Compares what kfast draws with what was once looked at and found good:

    golden_test.py <kfast> <folder> [--bless]

A folder below <folder> is a case: scene.kfast, the hashes of all its frames for several panels (hashes.txt) and a
picture of some frames (NNNN.png). --bless writes hashes and pictures anew: look at the difference before you commit it.
"""

import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

PANELS = [[], ["--size", "50x70"], ["--size", "40x24", "--scaling", "cover", "--format", "grey4"],
          ["--size", "64x32", "--scaling", "none", "--format", "mono1"]]
PICTURES = 3


def kfast(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.PIPE, text=True,
                          timeout=120).stdout


def hashes(program, scene):
    """By panel, what is told of all frames."""
    return {" ".join(panel) or "canvas": kfast(program, "hash", scene, *panel) for panel in PANELS}


def as_file(told):
    return "".join(f"# {panel}\n{lines}" for panel, lines in told.items())


def picture_frames(told):
    frames = len(told["canvas"].splitlines())
    return sorted({index * (frames - 1) // (PICTURES - 1) for index in range(PICTURES)})


def draw(program, scene, frame, picture):
    kfast(program, "render", scene, "--frame", frame, "-o", picture)


def same(one, other):
    with Image.open(one) as first, Image.open(other) as second:
        return first.size == second.size and first.convert("RGB").tobytes() == second.convert("RGB").tobytes()


def bless(program, case):
    scene = case / "scene.kfast"
    told = hashes(program, scene)
    (case / "hashes.txt").write_text(as_file(told), encoding="utf-8")
    for frame in picture_frames(told):
        draw(program, scene, frame, case / f"{frame:04}.png")


def differences(program, case):
    scene = case / "scene.kfast"
    told = hashes(program, scene)
    if as_file(told) != (case / "hashes.txt").read_text(encoding="utf-8"):
        yield f"{case.name}: hashes.txt differs"
    with tempfile.TemporaryDirectory() as folder:
        for frame in picture_frames(told):
            drawn = pathlib.Path(folder) / "drawn.png"
            draw(program, scene, frame, drawn)
            if not same(drawn, case / f"{frame:04}.png"):
                yield f"{case.name}: frame {frame} differs from its picture"


def main(program, folder, *options):
    cases = sorted(path.parent for path in pathlib.Path(folder).glob("*/scene.kfast"))
    if options == ("--bless",):
        for case in cases:
            bless(program, case)
        return 0
    failures = [line for case in cases for line in differences(program, case)]
    print("\n".join(failures) if failures else f"{len(cases)} golden scenes are as they were")
    return 1 if failures or not cases else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
