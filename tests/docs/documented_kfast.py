"""Stands as `kfast` in the shell of commands_test.py: opens no window, and takes a simulated board for the attached one.

What cannot run in a test is run as far as it can (not_run.py), and its options are compared with the command's own help.
"""

import functools
import os
import re
import signal
import subprocess
import sys

import not_run
from not_run import without

REAL = os.environ["KFAST_REAL"]
SIMULATED = os.environ["KFAST_SIMULATED"]
ON_DEVICES = ("devices", "play", "live", "pause", "resume", "arm", "disarm", "seek", "speed", "brightness", "upload", "slots",
              "choose", "erase", "boot")


@functools.lru_cache(maxsize=None)
def help_of(*command):
    return subprocess.run([REAL, *command, "--help"], capture_output=True, text=True, check=True).stdout


def commands_of(*command):
    return re.findall(r"(?m)^  ([a-z][\w-]*)  +[A-Z]", help_of(*command)) if "[OPTIONS] COMMAND" in help_of(*command) else []


def unknown_words(arguments):
    """Commands, commands of these, and options that there are not."""
    command = []
    for argument in arguments:
        known = commands_of(*command)
        if not known or argument.startswith("-"):
            break
        if argument not in known:
            return [argument]
        command.append(argument)
    known = set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", help_of(*command)))
    options = [argument.split("=")[0] for argument in arguments if re.match(r"--?[a-z]", argument)]
    return [option for option in options if option not in known]


def on_simulated_board(arguments):
    if any(argument.startswith("sim:") for argument in arguments):
        return arguments
    if "--device" not in arguments:
        return arguments if "--udev-rule" in arguments or "--help" in arguments else [*arguments, "--device", SIMULATED]
    first = arguments.index("--device")
    others = arguments
    while "--device" in others:
        others = without(others, "--device", 1)
    return [*others[:first], "--device", SIMULATED, *others[first:]]


def unseen(arguments):
    arguments = without(without(arguments, "--terminal"), "--loops", 1)
    arguments = arguments if "--headless" in arguments else [*arguments, "--headless"]
    return [*arguments, "--press", "n q"] if "--beam" in arguments else arguments  # all frames of a beam take seconds


def simulate(arguments):
    """Until the board listens."""
    arguments = without(unseen(arguments), "--socket", 1)
    board = subprocess.Popen([REAL, *arguments, "--socket", "other.sock", "--flash-file", "other.bin"],
                             stdout=subprocess.PIPE, text=True)
    line = board.stdout.readline()
    board.send_signal(signal.SIGTERM)
    print(line, end="")
    return 0 if line.startswith("listening") else board.wait() or 1


def run_instead(arguments, row):
    unknown = unknown_words(arguments)
    if unknown:
        print(f"kfast has no {', '.join(unknown)}")
        return 1
    if "…" not in arguments:  # some of it is left out
        done = subprocess.run([REAL, *row.arguments(arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode not in row.statuses:
            print(done.stdout)
            return done.returncode or 1
    print(f"not run: {row.why}")
    return 0


def main(arguments):
    row = not_run.instead(" ".join(["kfast", *arguments]))
    if row:
        return run_instead(arguments, row)
    command = arguments[0] if arguments else ""
    if command == "simulate":
        return simulate(arguments)
    if command == "preview" and "--audio-devices" not in arguments:
        arguments = unseen(arguments)
    if command in ON_DEVICES:
        arguments = on_simulated_board(arguments)
    sys.stdout.flush()
    os.execv(REAL, [REAL, *arguments])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
