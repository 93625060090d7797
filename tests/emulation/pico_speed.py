"""How fast a Pico plays, counted in emulated time at 125 MHz with SPI at 62.5 MHz:

    pico_speed.py <folder of kfast and kfast-panel> <folder of images> <scene.kfast>...

Prints JSON: for each scene, at 60 frames a second on 240 x 240 pixels, how many frames were shown a second, how many
were left out, and the share of the time for which the bus was busy; beside it what the buses reach when a picture is
sent whole. Wrong pictures are an error, as in the tests."""

import json
import pathlib
import statistics
import sys
import tempfile

from pico import Desk, TICKS, expect

HERE = pathlib.Path(__file__).resolve().parent
RATE = 60
SETTLED = 3  # frames: the first one is sent whole
SECONDS = 1.0


def at_sixty(source, folder):
    """The scene, played twice as fast if it was made for 30."""
    text = pathlib.Path(source).read_text(encoding="utf-8")
    expect("fps=30" in text or "fps=60" in text, f"{source}: neither fps=30 nor fps=60")
    faster = folder / pathlib.Path(source).name
    faster.write_text(text.replace("fps=30", "fps=60"), encoding="utf-8")
    return faster


def settled(run):
    frames = run.report["frames"]
    expect(len(frames) > SETTLED + 2, f"only {len(frames)} frames were shown")
    return frames[SETTLED:]


def expect_right(run, hashes):
    for shown in run.frames:
        if shown.ticks % TICKS == 0:
            expect(shown.hash == hashes[shown.ticks // TICKS % len(hashes)], f"frame {shown.ticks // TICKS} is wrong")


def scene_figures(desk, source):
    settings = desk.settings("pico-st7789")
    scene = desk.compile(at_sixty(source, desk.folder))
    begun = desk.run(settings, scene, "--frames", 1).report["milliseconds"]
    run = desk.run(settings, scene, "--for", begun + 1000 * SECONDS)
    expect_right(run, desk.hashes(scene, settings))
    frames = settled(run)
    seconds = (frames[-1]["at"] - frames[0]["at"]) / 1e9
    skipped = [int(frame["note"].split()[2]) for frame in (frames[0], frames[-1])]
    late = skipped[1] - skipped[0]
    shown = len(frames) - 1
    return {"frames_per_second": round(RATE * shown / (shown + late), 1), "shown": shown, "late": late,
            "bus_share": round(sum(frame["busy"] for frame in frames[1:]) / seconds / 1e9, 3)}


def bus_figures(desk, configuration):
    scene = desk.compile(HERE / "all_changes.kfast")
    run = desk.run(desk.settings(configuration), scene, "--frames", 12, "--for", 3000)
    first = run.report["frames"][0]
    duration = first["end"] - first["begin"]
    redrawn = [frame for frame in settled(run) if frame["bytes"] > 0]
    return {"bytes_per_second": round(first["bytes"] / duration * 1e9),
            "bus_share": round(first["busy"] / duration, 3),
            "bus_share_when_all_changes":
                round(statistics.median(frame["busy"] / (frame["end"] - frame["begin"]) for frame in redrawn), 3)}


def figures(programs, images, sources):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        desk = Desk(programs, images, folder)
        return {"scenes": {pathlib.Path(source).stem: scene_figures(desk, source) for source in sources},
                "buses": {"SPI": bus_figures(desk, "pico-st7789"),
                          "parallel": bus_figures(desk, "pico-ili9341-parallel")}}


def main(programs, images, *sources):
    print(json.dumps(figures(programs, images, sources), indent=4))


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"the Pico cannot be measured: {failure}")
