"""What the documents tell to do and the tests do not do, each with the reason, or do as far as they can.

Rows of KFAST are looked for in a call such as "kfast flash --list". Rows of OTHERS are looked for in the whole line;
names_test.py looks whether the scripts, options and files are there.
"""

import dataclasses
import re
from collections.abc import Callable


@dataclasses.dataclass
class Instead:
    """What is done in the place of a call: `arguments` makes those for it of those that the page has."""

    pattern: str
    arguments: Callable[[list[str]], list[str]]
    why: str
    statuses: tuple[int, ...] = (0,)


NO_DEVICE = 3


def without(arguments, option, values=0):
    if option not in arguments:
        return arguments
    at = arguments.index(option)
    return arguments[:at] + arguments[at + 1 + values:]


def dry(arguments):
    return [*arguments, "--dry-run"]


def dry_flash(arguments):
    """For settings that a board would have been asked for, those of an ST7789."""
    has_settings = "--pin" not in arguments or {"--panel", "--config", "--beam"} & set(arguments)
    return dry(arguments if has_settings else [*arguments, "--panel", "st7789"])


def as_gif(arguments):
    return [argument.replace(".webm", ".gif") for argument in arguments]


def on_no_display(arguments):
    return [*without(arguments, "--spi", 1), *([] if "parallel" in arguments else ["--spi", "/nowhere/spidev0.0"])]


def on_no_board(arguments):
    return [*arguments, "--device", "sim:/nowhere/board.sock"]


def silent(arguments):
    return [*without(arguments, "--audio"), "--headless", "--press", "n q"]


def as_snapshot(arguments):
    return [*arguments, "--headless", "--snapshot", "beside.png"]


KFAST = (
    Instead(r"^kfast flash", dry_flash, "writes to a board in its boot loader: tests/host/commands/flash_test.py", (0, NO_DEVICE)),
    Instead(r"^kfast render .*\.webm", as_gif, "is encoded for seconds: tests/host/commands/render_video_test.py"),
    Instead(r"^kfast panel ", on_no_display, "needs pins of a Linux board: tests/emulation/linux_panel_test.py", (NO_DEVICE,)),
    Instead(r"^kfast install-udev", dry, "writes to /etc as root: tests/host/commands/install_udev_test.py"),
    Instead(r"^kfast preview .*--audio( |$)", silent, "needs a sound card: tests/host/commands/sound_test.py"),
    Instead(r"^kfast preview .*--beside ", as_snapshot, "is to be seen: tests/host/commands/beside_test.py"),
    Instead(r"^kfast (dis)?arm", on_no_board, "the simulated board has no laser: tests/host/commands/device_test.py", (NO_DEVICE,)),
)

OTHERS = (
    (r"^scripts/", "installs, builds or measures for minutes"),
    (r"^(sudo )?(cmake|ctest|git|npm) |^sudo apt ", "builds or installs"),
    (r"^(ssh|scp) ", "needs another computer"),
    (r"^export ", "only prepares what follows it"),
    (r"build/editors", "needs what scripts/make_editor_files.py makes: tests/host/commands/editor_test.py"),
    (r"^while :", "runs until somebody stops it"),
    (r"^build/library/", "is built by others: the test library_example"),
    (r"^(find_package|target_link|c\+\+ |lib_deps|compiler\.)", "belongs into the reader's project: tests/packages"),
    (r"^(valgrind|cp -r boards|sed -i)", "needs a board that is being ported, or minutes"),
)


def instead(call):
    return next((row for row in KFAST if re.search(row.pattern, call)), None)


def is_other(command):
    return any(re.search(pattern, command) for pattern, _ in OTHERS)
