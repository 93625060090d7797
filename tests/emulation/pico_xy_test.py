"""Boots the Pico's image for vector displays in the emulator, with an MCP4922 at its pins (rp2040/mcp4922.mjs):

    pico_xy_test.py <folder of kfast> <folder of images> <beam-words> <folder of examples>

The words that the converters are told are those that the host computes for the same frames, point by point; from point
to point there is always the same time, whatever else happens; and the beam is dark when it has to be."""

import dataclasses
import itertools
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

from beam_record import ARM, GALVO, Beam, beam_record
from pico import HERE, RUNNER, TICKS, Desk, expect

ROOM = 4096  # points of a picture
CYCLE = 8  # nanoseconds
POINT = struct.Struct("<dHHB3x")
BUTTON = 12
DISARMED, ARMED = 1, 2
NO_LASER = 37


@dataclasses.dataclass(frozen=True)
class Shown:
    """A run: its report, and what the beam has shown."""
    report: dict
    moments: list
    points: list  # of (x, y, shines)

    @property
    def frames(self):
        """That the log tells of."""
        return [int(text.split()[1]) // TICKS for _, text in self.report["log"] if text.startswith("F ")]


class Bench:
    def __init__(self, programs, images, words, folder):
        self.desk = Desk(programs, images, folder)
        self.image = pathlib.Path(images) / "pico-xy.bin"
        self.words = words
        self.record = self.desk.folder / "record.bin"

    def expected(self, scene):
        """The points of every frame."""
        told = subprocess.run([self.words, self.record, scene, str(ROOM)], check=True, capture_output=True, text=True,
                              timeout=600).stdout
        return [[point_of(int(word, 16)) for word in line.split()] for line in told.splitlines()]

    def run(self, record, scene, *options, opens_between=False):
        self.record.write_bytes(record)
        files = {name: self.desk.folder / name for name in ("trace", "report.json", "points")}
        placed = [] if scene is None else ["--scene", scene]
        done = subprocess.run(
            [str(word) for word in ("node", RUNNER, self.image, "--settings", self.record, "--trace", files["trace"],
                                    "--report", files["report.json"], "--points", files["points"], *placed, *options)],
            capture_output=True, text=True, timeout=900, check=False)
        expect(done.returncode == 0, done.stderr.strip())
        found = list(POINT.iter_unpack(files["points"].read_bytes()))
        shown = Shown(json.loads(files["report.json"].read_text(encoding="utf-8")), [moment for moment, *_ in found],
                      [tuple(point) for _, *point in found])
        check_times(shown, record)
        if not opens_between:
            check_lights(shown)
        return shown


def point_of(word):
    return word >> 12 & 0xFFF, word & 0xFFF, int(word >> 24 != 0)


def check_times(shown, record):
    """The clock of the points never stumbles, and there is a new point for each of its ticks but the first."""
    rate = struct.unpack_from("<I", record, 8 + 274 + 2)[0]
    wanted = -(-125_000_000 // rate) * CYCLE
    gaps = {round(after - before, 3) for before, after in itertools.pairwise(shown.moments)}
    expect(gaps == {wanted}, f"from point to point it takes {sorted(gaps)[:5]} ns, not {wanted}")
    expect(len(shown.report["stale"]) == 1 and shown.report["stale"][0] == shown.moments[0],
           f"no point had been told {len(shown.report['stale'])} times")


def check_lights(shown):
    """It goes on when the converters take over: else it would shine along the way."""
    ticks = set(shown.moments)
    between = [moment for moment, shines in shown.report["lights"] if shines and moment not in ticks]
    expect(not between, f"the light goes on between points, at {between[:3]} ns")


def longest_still_light(points):
    """The most points in a row at which the beam shines and stays."""
    runs = (len(list(group)) for (_, _, shines), group in itertools.groupby(points) if shines)
    return max(runs, default=0)


def check_pictures(shown, pictures, park):
    """Parked at first, then the pictures of the frames that the log tells of, one after another, each as often as it
    takes, and whole."""
    points = shown.points
    at = next((i for i, point in enumerate(points) if i > 0 and point != park), len(points))
    seen, before = [], []
    for frame, _ in itertools.groupby(shown.frames, key=lambda frame: pictures[frame]):
        rest = points[at:at + len(frame)]
        if len(points) - at < len(before) and points[at:] == before[:len(points) - at]:
            break  # the run ended within a picture
        expect(rest == frame[:len(rest)], f"picture {len(seen)} is another one at point {at}")
        before = frame
        repeats = 0
        while points[at:at + len(frame)] == frame:
            at += len(frame)
            repeats += 1
        seen.append(repeats)
    left = len(points) - at
    expect(left < max(map(len, pictures)), f"{left} points are none of a picture")
    return seen


def check_scenes(bench, examples):
    for name, beam, frames in (("first-light", Beam(), 12), ("spinner", Beam(brightness="level"), 12),
                               ("stick-figure", GALVO, 8), ("worm", Beam(rate=200_000), 8)):
        scene = bench.desk.compile(pathlib.Path(examples) / f"{name}.kfast")
        beam = dataclasses.replace(beam, is_laser=False)
        shown = bench.run(beam_record(beam), scene, "--frames", frames)
        park = tuple((place + 32768) // 16 for place in beam.park) + (0,)
        expect(shown.points[1] == park, f"{name}: the beam begins at {shown.points[1]}")
        seen = check_pictures(shown, bench.expected(scene), park)
        expect(len(seen) >= 3 and sum(seen) > len(seen), f"{name}: pictures were repeated {seen} times")
        expect(any(shines for _, _, shines in shown.points), f"{name}: the beam never shines")
    return shown


def check_rates(bench, scene):
    """As fast as the wires carry, and by slow wires at other pins."""
    fast = bench.run(beam_record(Beam(rate=500_000)), scene, "--frames", 3)
    check_pictures(fast, bench.expected(scene), (0, 0, 0))
    slow = bench.run(beam_record(dataclasses.replace(GALVO, is_laser=False), 1_200_000, clock=2, data=28, select=7,
                                 ldac=22, blank=3), scene, "--frames", 3)
    check_pictures(slow, bench.expected(scene), (2048, 2048, 0))
    expect(slow.report["shortest"]["clockPeriod"] >= 833, "the bus clock is faster than asked for")


def check_late(bench, scene):
    """Pictures that take longer than a frame."""
    beam = dataclasses.replace(Beam(), rate=5_000, least_refresh=5)
    shown = bench.run(beam_record(beam), scene, "--for", 900)
    seen = check_pictures(shown, bench.expected(scene), (0, 0, 0))
    skipped = [int(text.split()[2]) for _, text in shown.report["log"] if text.startswith("F ")]
    expect(len(seen) >= 2 and skipped[-1] > 0, f"no frame was left out: {skipped}")


def check_dark(bench, examples):
    """Nothing to play, and what cannot be played."""
    broken = bench.desk.folder / "broken.kfb"
    broken.write_bytes(b"no scene at all" * 20)
    for scene in (None, broken):
        shown = bench.run(beam_record(Beam()), scene, "--for", 300)
        expect(shown.report["lights"] == [], "the beam shines though nothing plays")
        expect(set(shown.points[1:]) == {(0, 0, 0)}, "the beam is not parked")
        expect(len(shown.report["ledTurns"]) >= 1, "the LED is dark")


def check_flash(bench, scene):
    """While flash is erased and written the beam goes on with its picture."""
    first = bench.desk.compile(HERE / "link_first.kfast")
    shown = bench.run(beam_record(Beam()), scene, "--link", "keeps", "--file", f"first={first}")
    expect(shown.report["flash"]["operations"], "nothing was written to flash")
    check_pictures(shown, bench.expected(scene), (0, 0, 0))
    still = max(longest_still_light(picture * 2) for picture in bench.expected(scene))
    expect(longest_still_light(shown.points) <= still, "the beam shines and stands still")


def shines_between(report, begin, end):
    """Whether the beam ever does, from one moment to another; nanoseconds."""
    lights = report["lights"] + [[float("inf"), False]]
    return any(shines and moment < end and until > begin
               for (moment, shines), (until, _) in itertools.pairwise(lights))


def check_button(bench, scene):
    record = beam_record(GALVO, buttons=[(BUTTON, ARM)])
    dark = bench.run(record, scene, "--for", 300)
    expect(dark.report["lights"] == [], "a laser shines though nobody has armed it")
    expect(len(dark.frames) > 3, "the scene does not run while the laser is dark")
    shown = bench.run(record, scene, "--for", 700, "--press", f"{BUTTON}@200-260", "--press", f"{BUTTON}@450-500",
                      opens_between=True)
    expect(not shines_between(shown.report, 0, 200e6), "the laser shines before it is armed")
    expect(shines_between(shown.report, 300e6, 440e6), "the laser is armed and does not shine")
    expect(not shines_between(shown.report, 540e6, 700e6), "the laser shines though it was disarmed")


def check_link(bench, scene):
    record = beam_record(GALVO)
    shown = bench.run(record, scene, "--link", "arming", opens_between=True)
    told = shown.report["usb"]
    armed, disarmed, armed_again = told["at"]
    expect(told["arming"] == [DISARMED, ARMED, DISARMED, ARMED, DISARMED], f"the laser says {told['arming']}")
    expect(not shines_between(shown.report, 0, armed - 2e6), "the laser shines before it is armed")
    expect(shines_between(shown.report, armed, disarmed - 2e6), "the laser is armed and does not shine")
    expect(not shines_between(shown.report, disarmed, armed_again - 2e6), "the laser shines though it was disarmed")
    expect(not shines_between(shown.report, armed_again + 150e6, armed_again + 290e6),
           "the laser shines though its computer is silent")
    refused = bench.run(beam_record(Beam()), scene, "--link", "armsNothing").report["usb"]
    expect(refused["errors"] == [NO_LASER, NO_LASER] and refused["arming"] == 0, f"a scope is armed: {refused}")


def main(programs, images, words, examples):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        bench = Bench(programs, images, words, folder)
        check_scenes(bench, examples)
        scene = bench.desk.compile(pathlib.Path(examples) / "spinner.kfast")
        check_rates(bench, scene)
        check_late(bench, scene)
        check_dark(bench, examples)
        check_flash(bench, scene)
        check_button(bench, scene)
        check_link(bench, scene)
    print("the beam shows what the host computes, point by point, and is dark when it has to be")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"the beam of the Pico does not do what it should: {failure}")
