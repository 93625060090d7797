"""Compiles the scenes of examples/ and of tests/fuzz/scenes, which mutations begin with: compile_scenes.py KFAST FOLDER."""

import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = [scene for folder in ("examples", "tests/fuzz/scenes") for scene in sorted((ROOT / folder).rglob("*.kfast"))]

kfast, folder = sys.argv[1], pathlib.Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
for text in SCENES:
    compiled = folder / f"{text.parent.name}-{text.stem}.kfb"
    subprocess.run([kfast, "compile", "--quiet", text, "-o", compiled], check=True, timeout=120)
