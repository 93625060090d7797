"""What images take of flash and RAM."""

import subprocess

BOARD_CPUS = ("cortex-m0", "cortex-m3", "cortex-m4")


def sections(image):
    listing = subprocess.run(["arm-none-eabi-size", "-A", image], check=True, stdout=subprocess.PIPE, text=True,
                             timeout=60).stdout
    rows = [line.split() for line in listing.splitlines()]
    return {row[0]: int(row[1]) for row in rows if len(row) == 3 and row[0].startswith(".")}


def player_bytes(image):
    """Code and constants of a bench image without the measuring itself: the core and the firmware's loop."""
    return sections(image)[".text"]


def stored_segments(image):
    """(address where it runs, address where it is stored, bytes) of what a board's image stores."""
    listing = subprocess.run(["arm-none-eabi-readelf", "-lW", image], check=True, stdout=subprocess.PIPE, text=True,
                             timeout=60).stdout
    rows = [line.split() for line in listing.splitlines() if line.split()[:1] == ["LOAD"]]
    return [tuple(int(row[column], 16) for column in (2, 3, 4)) for row in rows]


def flash_bytes(image):
    """All that is stored of a board's image."""
    return sum(stored for _, _, stored in stored_segments(image))


def static_bytes(image):
    """RAM that is given away when the image is linked: what is copied there, code too, and what begins as zeros."""
    copied = sum(stored for runs_at, stored_at, stored in stored_segments(image) if runs_at != stored_at)
    return copied + sections(image).get(".bss", 0)


def symbol(image, name):
    listing = subprocess.run(["arm-none-eabi-nm", image], check=True, stdout=subprocess.PIPE, text=True, timeout=60)
    return next(int(line.split()[0], 16) for line in listing.stdout.splitlines() if line.split()[-1] == name)
