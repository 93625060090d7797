"""Stands as `kfast` in the shell of commands_test.py: opens no window, and takes a simulated board for the attached one.

What cannot run in a test (not_run.py) has its options compared with the command's own help and ends as if it had run.
"""

import os
import re
import signal
import subprocess
import sys

import not_run

REAL = os.environ["KFAST_REAL"]
SIMULATED = os.environ["KFAST_SIMULATED"]
ON_DEVICES = ("devices", "play", "live", "pause", "resume", "arm", "disarm", "seek", "speed", "brightness", "upload", "slots",
              "choose", "erase", "boot")


def unknown_options(arguments):
    words = [REAL]
    for argument in arguments[:2]:  # some commands have commands of their own
        if argument.startswith("-") or subprocess.run([*words, argument, "--help"], capture_output=True).returncode:
            break
        words.append(argument)
    told = subprocess.run([*words, "--help"], capture_output=True, text=True).stdout
    known = set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", told))
    options = [argument.split("=")[0] for argument in arguments if re.match(r"--?[a-z]", argument)]
    return [option for option in options if option not in known]


def without(arguments, option, values=0):
    if option not in arguments:
        return arguments
    at = arguments.index(option)
    return arguments[:at] + arguments[at + 1 + values:]


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
    return [*arguments, "--keys", "n q"] if "--beam" in arguments else arguments  # all frames of a beam take seconds


def simulate(arguments):
    """Until the board listens."""
    arguments = without(unseen(arguments), "--socket", 1)
    board = subprocess.Popen([REAL, *arguments, "--socket", "other.sock", "--flash", "other.bin"],
                             stdout=subprocess.PIPE, text=True)
    line = board.stdout.readline()
    board.send_signal(signal.SIGTERM)
    print(line, end="")
    return 0 if line.startswith("listening") else board.wait() or 1


def main(arguments):
    why = not_run.reason(not_run.KFAST, " ".join(["kfast", *arguments]))
    if why:
        unknown = unknown_options(arguments)
        print(f"kfast has no {', '.join(unknown)}" if unknown else f"not run: {why}")
        return 1 if unknown else 0
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
