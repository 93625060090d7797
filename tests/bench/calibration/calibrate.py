"""Finds what each kind of work costs on each processor, and writes host/fit/cost_table.cpp.

The images of tests/bench play the golden scenes and random ones and count instructions; kfast-work tells what the core did
for the same frames. The examples are not among the scenes: a test compares with them what the table predicts."""

import argparse
import concurrent.futures
import dataclasses
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/bench"))
import cycles  # noqa: E402
import guest  # noqa: E402
import images  # noqa: E402
from cost_table import write_table  # noqa: E402
from least_squares import fitted  # noqa: E402
from random_scenes import scene_texts  # noqa: E402

FIRST_DRAWN = "step"  # kinds of work before it are part of the update (core/bytes/op_counter.hpp)
# As core/features.hpp has them, after an image without any.
FEATURES = ("none", "strokes", "tweens", "bones", "backbones", "depth", "wires", "paths", "smooth", "texts", "drawings", "trims", "springs")
PROFILED = ("golden-split_and_merge", "golden-bones_and_skins", "random-3", "random-8")


@dataclasses.dataclass
class Work:
    """What the core did for a scene, as this computer counts it, frame by frame."""
    names: list
    areas: numpy.ndarray
    bytes: numpy.ndarray
    counts: numpy.ndarray

    @classmethod
    def of(cls, host, scene):
        told = subprocess.run([host / "kfast-work", scene], check=True, stdout=subprocess.PIPE, text=True, timeout=600).stdout
        head, *rows = (line.split() for line in told.splitlines())
        table = numpy.array([[int(cell) for cell in row] for row in rows], float)
        own = 2 + len(guest.CPUS)  # columns before the counts
        return cls(head[own:], table[:, :1], table[:, 1:2], table[:, own:])


@dataclasses.dataclass
class Play:
    """A scene on a processor."""
    name: str
    work: Work
    run: guest.Run

    def measured(self, *phases):
        return numpy.array([sum(frame[phase] for phase in phases) for frame in self.run.frames], float)

    def is_the_same(self):
        sent = [(frame["windows"], frame["bytes"]) for frame in self.run.frames]
        return sent == list(zip(self.work.areas[:, 0], self.work.bytes[:, 0]))


@dataclasses.dataclass
class Costs:
    """What the table holds of a processor."""
    code: int
    bare_code: int
    feature_code: list
    fixed_ram: int
    stack: int
    cycles: float
    frame: float
    area: float
    work: list

    def estimate(self, work):
        return work.counts @ numpy.array(self.work) + self.area * work.areas[:, 0] + self.frame


def scenes(host, folder):
    """Name and compiled file of each."""
    texts = {f"golden-{path.parent.name}": path for path in sorted((ROOT / "tests/golden").glob("*/scene.kfast"))}
    for name, text in scene_texts().items():
        texts[name] = pathlib.Path(folder, f"{name}.kfast")
        texts[name].write_text(text, encoding="utf-8")
    compiled = {name: pathlib.Path(folder, f"{name}.kfb") for name in texts}
    for name, text in texts.items():
        subprocess.run([host / "kfast", "compile", text, "-o", compiled[name]], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, timeout=300)
    return compiled


class Calibration:
    def __init__(self, chosen, compiled, pool):
        self.chosen = chosen
        self.scenes = compiled
        self.pool = pool
        self.work = dict(zip(compiled, pool.map(lambda scene: Work.of(chosen.host, scene), compiled.values())))
        self.names = next(iter(self.work.values())).names

    def plays(self, cpu):
        """Without the scenes that the image cannot play."""
        return [each for each in self.pool.map(lambda name: self.play(cpu, name), self.scenes) if each]

    def play(self, cpu, name):
        try:
            found = Play(name, self.work[name], guest.play(self.chosen.images, cpu, self.scenes[name]))
        except guest.GuestError as error:
            print(f"{cpu} {name}: left out: {error}", file=sys.stderr)
            return None
        if not found.is_the_same():
            print(f"{cpu} {name}: left out: this computer sends something else", file=sys.stderr)
            return None
        return found

    def profiled(self, cpu):
        """Sampling takes memory from the block: not all of them need find room."""
        for name in PROFILED:
            try:
                yield guest.play(self.chosen.images, cpu, self.scenes[name], profile=True)
            except guest.GuestError as error:
                print(f"{cpu} {name}: not sampled: {error}", file=sys.stderr)

    def cycles(self, cpu):
        runs = list(self.profiled(cpu))
        addresses = [address for run in runs for frame in run.samples for address in frame]
        return cycles.average(cpu, guest.image_for(self.chosen.images, cpu), addresses)

    def costs(self, cpu, plays):
        counts = numpy.concatenate([each.work.counts for each in plays])
        areas = numpy.concatenate([each.work.areas for each in plays])
        one = numpy.ones_like(areas)
        border = self.names.index(FIRST_DRAWN)

        def fit(columns, phase):
            return fitted(numpy.hstack(columns), numpy.concatenate([each.measured(phase) for each in plays]))

        update = fit([counts[:, :border], one], "update")
        draw = fit([counts[:, border:], areas, one], "draw")
        send = fit([areas, one], "send")
        image = guest.image_for(self.chosen.images, cpu)
        bare, *with_one = (images.player_bytes(self.chosen.images / f"feature-{name}-{cpu}.elf") for name in FEATURES)
        return Costs(code=images.player_bytes(image), bare_code=bare, feature_code=[max(each - bare, 0) for each in with_one],
                     fixed_ram=max(images.static_bytes(image) - self.chosen.bands, 0),
                     stack=max(each.run.stack for each in plays), cycles=self.cycles(cpu),
                     frame=update[-1] + draw[-1] + send[-1], area=draw[-2] + send[-2], work=[*update[:-1], *draw[:-2]])


def print_errors(cpu, costs, plays):
    for each in plays:
        estimate, measured = costs.estimate(each.work), each.measured("update", "draw", "send")
        print(f"{cpu} {each.name:26} median {numpy.median(estimate) / numpy.median(measured) - 1:+6.1%}"
              f" worst {estimate.max() / measured.max() - 1:+6.1%}")


def options():
    parser = argparse.ArgumentParser(prog="scripts/calibrate", description=__doc__)
    parser.add_argument("--host", type=pathlib.Path, default=ROOT / "build/host/bin")
    parser.add_argument("--images", type=pathlib.Path, default=ROOT / "build/lm3s6965evb")
    parser.add_argument("--bands", type=int, default=8192, help="bytes of the bands in the images")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "host/fit/cost_table.cpp")
    return parser.parse_args()


def main():
    chosen = options()
    table = {}
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        calibration = Calibration(chosen, scenes(chosen.host, folder), pool)
        for cpu in guest.CPUS:
            plays = calibration.plays(cpu)
            table[cpu] = calibration.costs(cpu, plays)
            print_errors(cpu, table[cpu], plays)
    write_table(chosen.output, calibration.names, table)


if __name__ == "__main__":
    main()
