"""Small files of Synfig, one for each feature, drawn by kfast and by Synfig itself:

    synfig_pictures_test.py KFAST SYNFIG [NAME…]"""

import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import compare_pictures  # noqa: E402

FRAMES = (0, 5, 13, 20)

# Files of which less is carried over, for which the notices are tested elsewhere.
NOT_COMPARED = {"losses"}

# Synfig deforms pictures of pixels, with rough edges and a pixel too low: those are drawn larger, and made smaller again.
ENLARGED = {"bones_deformation": 6, "bones_stretch": 6, "waving_figure": 3}

# How far those may be away that differ by more than edges.
LIMITS = {
    "bones_deformation": {"near": 0.97, "worst": 32},
    "bones_stretch": {"near": 0.97, "worst": 32},
    "checker": {"near": 0.9, "worst": 48},  # Synfig's boards are half a pixel off
    "move_layers": {"worst": 24},
    "outline_loop": {"worst": 24},  # corners that Synfig blunts are sharp
    "waving_figure": {"near": 0.97, "worst": 40},
}


def run(*command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=120)
    if result.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {result.stderr.strip()[-500:]}")


def size_of(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    return int(root.get("width")), int(root.get("height"))


def draw(synfig, path, folder):
    """All frames up to the last of FRAMES as Synfig draws them: one by one would take four times as long."""
    factor = ENLARGED.get(path.stem, 1)
    width, height = size_of(path)
    run(synfig, "-t", "png", path, "-o", folder / f"{path.stem}.png", "--begin-time", "0f", "--end-time",
        f"{FRAMES[-1]}f", "-w", factor * width, "-h", factor * height)
    for frame in FRAMES:
        with Image.open(folder / f"{path.stem}.{frame:04}.png") as file:
            yield frame, file.convert("RGBA").resize((width, height), Image.BOX)


def problems_of(path, kfast, synfig, folder):
    scene = folder / f"{path.stem}.kfast"
    run(kfast, "import", path, "-o", scene)
    for frame, reference in draw(synfig, path, folder):
        own = folder / f"{path.stem}-{frame}-kfast.png"
        run(kfast, "render", scene, "--frame", frame, "-o", own)
        difference = compare_pictures.compare(own, reference)
        for problem in difference.problems(**LIMITS.get(path.stem, {})):
            yield f"{path.name} at frame {frame}: {problem}"


def main(kfast, synfig, *names):
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        for path in sorted(HERE.glob("*.sif")):
            if path.stem in NOT_COMPARED or (names and path.stem not in names):
                continue
            for problem in problems_of(path, kfast, synfig, pathlib.Path(folder)):
                print(problem)
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
