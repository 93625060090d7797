"""Runs an image of tests/bench/image in QEMU, where every instruction lasts 256 ns."""

import dataclasses
import pathlib
import subprocess

CPUS = ("cortex-m0", "cortex-m3", "cortex-m4", "cortex-m7", "cortex-m33")
SCENE_ADDRESS = 0x20000
PROFILE_WANTED = 0x2000FFF8
TIMEOUT = 600


class GuestError(Exception):
    """The image did not play the scene to its end."""


@dataclasses.dataclass
class Run:
    """What an image has told."""
    frames: list = dataclasses.field(default_factory=list)  # of the steady loop: numbers by name
    samples: list = dataclasses.field(default_factory=list)  # of each of these frames: addresses in the program
    lent: int = 0
    needed: int = 0
    stack: int = 0
    check: int = 0  # instructions: of SceneView::parse
    load: int = 0  # with it, until the first picture can be drawn


def image_for(folder, cpu, program="bench"):
    return pathlib.Path(folder, f"{program}-{cpu}.elf")


def command(image, cpu, scene, profile):
    return ["qemu-system-arm", "-M", "lm3s6965evb", "-cpu", cpu, "-kernel", str(image),
            "-display", "none", "-monitor", "none", "-serial", "none", "-nodefaults", "-nic", "none",
            "-icount", "shift=8,sleep=off",
            "-chardev", "stdio,id=told", "-semihosting-config", "enable=on,target=native,chardev=told",
            "-device", f"loader,file={scene},addr={SCENE_ADDRESS:#x},force-raw=on",
            "-device", f"loader,addr={PROFILE_WANTED:#x},data={int(profile)},data-len=4"]


def play(folder, cpu, scene, profile=False, program="bench"):
    """Plays a compiled scene for two turns."""
    done = subprocess.run(command(image_for(folder, cpu, program), cpu, scene, profile), stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=TIMEOUT)
    run = parse(done.stdout)
    if done.returncode != 0 or not done.stdout.endswith("end\n"):
        raise refusal(run, done)
    return run


def refusal(run, done):
    if run.needed > run.lent:
        return GuestError(f"it needs a block of {run.needed} bytes, the image lends {run.lent}")
    return GuestError(f"QEMU ended with status {done.returncode}: {done.stdout[-200:]}{done.stderr[-200:]}")


def parse(told):
    run = Run()
    samples = [[]]
    for line in told.splitlines():
        words = line.split()
        if words[0] == "p":
            samples[-1].append(int(words[1]))
        elif words[0] == "shown":
            samples.append([])
        elif words[0] == "frame":
            run.frames.append(fields(words))
        elif words[0] in ("lent", "check", "stack"):
            vars(run).update(fields(words))
    run.samples = samples[len(run.frames):-1]
    return run


def fields(words):
    """Names and numbers in turn."""
    return {name: int(number) for name, number in zip(words[::2], words[1::2])}
