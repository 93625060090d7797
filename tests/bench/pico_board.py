"""What the firmware does on a Pico, in emulated time (tests/emulation/pico_speed.py)."""

import json
import subprocess
import sys

from scenes import REFERENCES, ROOT, scene_texts

SPEED = ROOT / "tests" / "emulation" / "pico_speed.py"
TIMEOUT = 1200


def figures(programs, images):
    """Of the references alone: a second of any other scene takes a minute, too."""
    texts = scene_texts()
    done = subprocess.run([sys.executable, SPEED, programs, images, *(texts[name] for name in REFERENCES)],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=TIMEOUT, check=False)
    if done.returncode != 0:
        raise SystemExit(f"bench: {done.stderr.strip()}")
    return json.loads(done.stdout)
