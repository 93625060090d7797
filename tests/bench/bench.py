"""Measures how fast and how small KFAST is; scripts/bench builds what is measured and calls it.

Every figure but the frames per second of this computer is a count, the same in every run."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import sys

import board_stack
import guest
import host_side
import images
import pico_board
import report
import results
from hot_spots import print_profile
from scenes import ROOT, compile_scenes

RECORDED = pathlib.Path(__file__).with_name("recorded.json")
DOCUMENT = ROOT / "docs" / "benchmarks.md"


def options(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/bench", description="Counts instructions, memory and bytes sent. Without options: everything, "
        "into build/bench/results.json and docs/benchmarks.md.")
    parser.add_argument("--scene", action="append", default=[], metavar="NAME", help="only this one; may be repeated")
    parser.add_argument("--cpu", action="append", default=[], choices=guest.CPUS, help="only this one; may be repeated")
    parser.add_argument("--compare", action="store_true",
                        help="print what has grown by more than 2 %% since it was recorded, and exit with 1 then")
    parser.add_argument("--record", action="store_true", help="keep the figures, for --compare")
    parser.add_argument("--profile", metavar="SCENE", help="only tell where its instructions go")
    parser.add_argument("--instructions-only", action="store_true", help="neither boards nor this computer")
    parser.add_argument("--host", type=pathlib.Path, default=ROOT / "build/host/bin", help="kfast and bench_player")
    parser.add_argument("--images", type=pathlib.Path, default=ROOT / "build/lm3s6965evb",
                        help="the images to be measured, and those of that board")
    parser.add_argument("--pico", type=pathlib.Path, default=ROOT / "build/pico", help="the Pico's images")
    parser.add_argument("--recorded", type=pathlib.Path, default=RECORDED, help="what --compare and --record use")
    parser.add_argument("--check-options", action="store_true", help="measure nothing")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build/bench/results.json")
    chosen = parser.parse_args(arguments)
    if chosen.compare and not chosen.recorded.exists():
        sys.exit("nothing is recorded yet: scripts/bench --record")
    return chosen


def is_whole(chosen):
    return not (chosen.scene or chosen.cpu or chosen.instructions_only)


class Bench:
    """Measures; what cannot be measured is told and left out."""

    def __init__(self, chosen, scenes):
        self._chosen = chosen
        self._cpus = chosen.cpu or list(guest.CPUS)
        self._scenes = scenes
        self._frames = {}  # by scene, what the host sends
        self.refused = []

    def results(self):
        found = {"instructions": {cpu: {} for cpu in self._cpus}, "loading": {cpu: {} for cpu in self._cpus},
                 "flash_bytes": {}, "ram_bytes": {}, "stack_bytes": {},
                 "kfb_bytes": {scene.name: scene.size for scene in self._scenes}, "sent_bytes": {}, "host": {}}
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            self._measure_traffic(pool, found)
            self._measure_guests(pool, found)
            self._measure_images(found)
            if not self._chosen.instructions_only:
                self._measure_boards(pool, found)
                self._measure_host(pool, found)
        if is_whole(self._chosen):
            found["pico"] = pico_board.figures(self._chosen.host, self._chosen.pico)
        return found

    def _measure_traffic(self, pool, found):
        player = self._chosen.host / "bench_player"
        for scene, frames in zip(self._scenes, pool.map(lambda scene: host_side.frames(player, scene.compiled),
                                                        self._scenes)):
            self._frames[scene.name] = frames
            found["sent_bytes"][scene.name] = results.sent_figures(frames)

    def _measure_guests(self, pool, found):
        jobs = [(cpu, scene) for cpu in self._cpus for scene in self._scenes]
        for (cpu, scene), run in zip(jobs, pool.map(lambda job: self._play(*job), jobs)):
            if run is None:
                continue
            self._expect_same_pixels(cpu, scene, run)
            found["instructions"][cpu][scene.name] = results.instruction_figures(run.frames)
            found["loading"][cpu][scene.name] = {"check": run.check, "load": run.load}
            found["ram_bytes"][scene.name] = run.needed
            found["stack_bytes"][cpu] = max(run.stack, found["stack_bytes"].get(cpu, 0))

    def _play(self, cpu, scene):
        try:
            return guest.play(self._chosen.images, cpu, scene.compiled)
        except guest.GuestError as error:
            self.refused.append(f"{scene.name} on {cpu}: {error}")
            return None

    def _expect_same_pixels(self, cpu, scene, run):
        for shown, expected in zip(run.frames, self._frames[scene.name], strict=True):
            if any(shown[name] != expected[name] for name in ("windows", "bytes", "pixels")):
                self.refused.append(f"{scene.name} on {cpu}: frame {shown['frame']} is not what this computer draws")
                return

    def _measure_images(self, found):
        for cpu in self._cpus:
            image = guest.image_for(self._chosen.images, cpu)
            found["flash_bytes"][cpu] = images.player_bytes(image)
            found["ram_bytes"][cpu] = images.static_bytes(image)

    def _measure_boards(self, pool, found):
        for cpu in images.BOARD_CPUS:
            name = f"lm3s6965evb-{cpu}"
            image = self._chosen.images / f"{name}.elf"
            found["flash_bytes"][name] = images.flash_bytes(image)
            found["ram_bytes"][name] = images.static_bytes(image)
            depths = pool.map(lambda scene, image=image, cpu=cpu: board_stack.stack_used(
                image, cpu, scene.compiled, len(self._frames[scene.name])), self._scenes)
            found["stack_bytes"][name] = max((depth for depth in depths if depth is not None), default=None)

    def _measure_host(self, pool, found):
        player = self._chosen.host / "bench_player"
        counts = pool.map(lambda scene: host_side.instructions(player, scene.compiled), self._scenes)
        for scene, frames in zip(self._scenes, counts):
            found["host"][scene.name] = {"instructions": results.spread(frames)}
        for scene in self._scenes:  # one by one: the others would slow it down
            found["host"][scene.name]["frames_per_second"] = host_side.frames_per_second(player, scene.compiled)


def print_figures(found):
    for cpu, scenes in found["instructions"].items():
        for name, figures in scenes.items():
            parts = ", ".join(f"{part} {report.pair(figures[part])}" for part in results.PARTS)
            print(f"{cpu} {name}: {report.pair(figures)} instructions in a frame ({parts})")
    for name, figures in found["host"].items():
        print(f"this computer, {name}: {figures['frames_per_second']:,} frames per second")
    for name, figures in found.get("pico", {"scenes": {}})["scenes"].items():
        print(f"Pico, {name}: {figures['frames_per_second']} of 60 frames a second")


def write_json(path, figures):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(figures, indent=4) + "\n", encoding="utf-8")


def print_growth(recorded, found):
    grown = results.growth(json.loads(recorded.read_text(encoding="utf-8")), found)
    print("\n".join(["Grown by more than 2 %:"] + grown if grown else ["Nothing has grown by more than 2 %."]))
    return bool(grown)


def main(arguments):
    chosen = options(arguments)
    if chosen.check_options:
        return 0
    wanted = [chosen.profile] if chosen.profile else chosen.scene
    chosen.output.parent.mkdir(parents=True, exist_ok=True)
    scenes = compile_scenes(chosen.host / "kfast", wanted, chosen.output.parent)
    if chosen.profile:
        print_profile(chosen.images, (chosen.cpu or guest.CPUS)[0], scenes[0])
        return 0
    bench = Bench(chosen, scenes)
    found = bench.results()
    write_json(chosen.output, found)
    print_figures(found)
    has_grown = chosen.compare and print_growth(chosen.recorded, found)
    if chosen.record:
        write_json(chosen.recorded, {section: found[section] for section in results.COMPARED})
    if is_whole(chosen) and not bench.refused:
        report.write_into(DOCUMENT, found)
    print("".join(f"bench: {refusal}\n" for refusal in bench.refused), end="", file=sys.stderr)
    return 1 if has_grown or bench.refused else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
