"""Small files of Synfig, one for each feature, drawn by kfast and by Synfig itself:

    synfig_pictures_test.py KFAST SYNFIG [NAME…]"""

import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import compare_pictures  # noqa: E402

FRAMES = (0, 5, 13, 20)

# Files of which less is carried over, for which the notices are tested elsewhere.
NOT_COMPARED = {"losses"}

# Limits for those that differ by what Synfig itself rounds: its grid of deformation, and how it blunts corners.
LIMITS = {}


def run(*command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=120)
    if result.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {result.stderr.strip()[-500:]}")


def problems_of(path, kfast, synfig, folder):
    scene = folder / f"{path.stem}.kfast"
    run(kfast, "import", path, "-o", scene)
    for frame in FRAMES:
        own, reference = folder / f"{path.stem}-{frame}.png", folder / f"{path.stem}-{frame}-synfig.png"
        run(kfast, "render", scene, "--frame", frame, "-o", own)
        run(synfig, "-t", "png", path, "-o", reference, "--time", f"{frame}f")
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
