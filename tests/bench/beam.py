"""Counts the instructions that the points of a beam take, on the CPU of the Pico: scripts/bench_beam --help."""

import argparse
import statistics
import tempfile

from guest import play
from hot_spots import print_profile
from scenes import REFERENCES, ROOT, compile_scenes

CPU = "cortex-m0"


def options(arguments):
    parser = argparse.ArgumentParser(prog="scripts/bench_beam", description=__doc__)
    parser.add_argument("--scene", action="append", metavar="NAME", help="only this one; may be repeated")
    parser.add_argument("--all", action="store_true", help="every example, not the references alone")
    parser.add_argument("--profile", action="store_true", help="which functions and lines take the instructions")
    parser.add_argument("--build", default=str(ROOT / "build" / "lm3s6965evb"), help=argparse.SUPPRESS)
    parser.add_argument("--kfast", default=str(ROOT / "build" / "host" / "bin" / "kfast"), help=argparse.SUPPRESS)
    return parser.parse_args(arguments)


def row(scene, run):
    points = [frame["points"] for frame in run.frames]
    show = [frame["update"] for frame in run.frames]
    plot = [frame["draw"] for frame in run.frames]
    each = [(a + b) / c for a, b, c in zip(show, plot, points)]
    return (f"| {scene.name} | {statistics.median_low(points):,} / {max(points):,} | "
            f"{statistics.median_low(show):,} / {max(show):,} | {statistics.median_low(plot):,} / {max(plot):,} | "
            f"{statistics.median(each):,.0f} / {max(each):,.0f} | {run.needed:,} | {run.stack:,} |")


def main(arguments):
    chosen = options(arguments)
    with tempfile.TemporaryDirectory() as folder:
        scenes = compile_scenes(chosen.kfast, chosen.scene or ([] if chosen.all else list(REFERENCES)), folder)
        if chosen.profile:
            for scene in scenes:
                print_profile(chosen.build, CPU, scene, program="beam")
            return
        print("| scene | points | to compute it | to plot it | in all, for a point | block | stack |")
        print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
        for scene in scenes:
            print(row(scene, play(chosen.build, CPU, scene.compiled, program="beam")), flush=True)


if __name__ == "__main__":
    import sys
    main(sys.argv[1:])
