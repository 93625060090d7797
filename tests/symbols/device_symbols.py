"""Checks what device images are made of: device_symbols.py <nm> <image>...

No heap, no floating point in software, no exceptions, and no constants copied to RAM."""

import pathlib
import re
import subprocess
import sys

FORBIDDEN = [
    ("heap", r"_?(malloc|free|calloc|realloc|sbrk)(_r)?|_Zn[wa].*|_Zd[la].*"),
    ("software floating point", r"__aeabi_([fd][a-z0-9]+|c[fd]\w+|\w+2[fd])|__\w+[sd]f[23]?"),
    ("exceptions", r"__cxa_.*|_Unwind_.*|__gxx_personality.*|_ZSt9terminatev|_ZSt\d+__throw_.*"),
]


def check(nm, image):
    """All violations in `image`, one line each."""
    listing = subprocess.run([nm, "--format=sysv", image], check=True, capture_output=True, text=True, timeout=60)
    rows = [[cell.strip() for cell in line.split("|")] for line in listing.stdout.splitlines() if "|" in line]
    symbols = [(row[0], row[3], row[6]) for row in rows if row[0] != "Name"]
    if not symbols:
        return [f"{image}: no symbols to check"]
    mistakes = []
    for name, kind, section in symbols:
        mistakes += [f"{image}: {name}: {what}" for what, pattern in FORBIDDEN if re.fullmatch(pattern, name)]
        if kind == "OBJECT" and section.startswith(".data"):
            mistakes.append(f"{image}: {name}: data that must be copied to RAM")
    return mistakes


if __name__ == "__main__":
    images = sys.argv[2:]
    missing = [image for image in images if not pathlib.Path(image).is_file()]
    found = [f"{image}: missing; build the board first" for image in missing]
    for image in images:
        found += check(sys.argv[1], image) if image not in missing else []
    print("\n".join(found) or f"{len(images)} images: no heap, no soft-float, no exceptions")
    sys.exit(1 if found or not images else 0)
