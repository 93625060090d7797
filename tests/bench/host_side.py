"""The same loop on this computer."""

import pathlib
import re
import subprocess
import tempfile

from guest import fields

TIMEOUT = 600


def told(player, wish, scene):
    return subprocess.run([player, wish, scene], check=True, stdout=subprocess.PIPE, text=True, timeout=TIMEOUT).stdout


def frames(player, scene):
    """Bytes that each frame of the steady loop sends, and how little it could be."""
    return [fields(line.split()) for line in told(player, "frames", scene).splitlines()]


def frames_per_second(player, scene):
    return fields(told(player, "speed", scene).split())["frames_per_second"]


def instructions(player, scene):
    """Of each frame of the steady loop, counted by valgrind."""
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        counts = pathlib.Path(folder, "counts")
        subprocess.run(["valgrind", "--tool=callgrind", "--dump-before=frame_shown",
                        f"--callgrind-out-file={counts}", player, "once", scene],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=TIMEOUT)
        shown = sorted(pathlib.Path(folder).glob("counts.*"), key=lambda path: int(path.suffix[1:]))
        return [total(path) for path in shown[len(shown) // 2:]]


def total(counts):
    return int(re.search(r"^totals: (\d+)", counts.read_text(), re.MULTILINE)[1])
