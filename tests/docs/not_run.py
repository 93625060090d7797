"""What the documents tell to do and the tests do not do, each with the reason.

Rows of KFAST are looked for in a call such as "kfast flash --list"; options of such calls must still be known to the command.
Rows of OTHERS are looked for in the whole line.
"""

import re

KFAST = (
    (r"^kfast flash", "writes to a board in its boot loader: tests/host/commands/flash_test.py"),
    (r"^kfast render .*\.webm", "is encoded for seconds: tests/host/commands/render_test.py"),
    (r"^kfast panel ", "needs pins of a Linux board: tests/emulation/linux_panel_test.py"),
    (r"^kfast install-udev", "writes to /etc as root: tests/host/commands/install_udev_test.py"),
    (r"^kfast preview .*--audio", "needs a sound card: tests/host/commands/sound_test.py"),
    (r"^kfast (dis)?arm", "the simulated board has no laser: tests/host/commands/device_test.py"),
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


def reason(rows, text):
    return next((why for pattern, why in rows if re.search(pattern, text)), None)
