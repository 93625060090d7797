"""Times the Pico's images in the emulator, in emulated time:

    pico_timing_test.py <folder of kfast and kfast-panel> <folder of images>

How full the bus is when every pixel changes, over SPI and in parallel; that the processor draws while DMA sends; that
frames begin when the display has shown the one before, or do not wait when nobody tells; that they keep their pace, and that
a scene of flat shapes plays at sixty frames a second."""

import pathlib
import sys
import tempfile

from pico import Desk, TICKS, expect
from pico_speed import scene_figures

HERE = pathlib.Path(__file__).resolve().parent
ALL_CHANGES = HERE / "all_changes.kfast"
DOT = HERE / "dot.kfast"
EYES = HERE.parents[1] / "examples" / "reference" / "eyes.kfast"
RATE = 30  # of the dot, frames a second
PIXELS = 240 * 240
LEAST_SHARE = 0.95
PARALLEL_GAIN = 1.75
WRITE_CYCLE = 66  # nanoseconds
DRAWING_PLACES = 60  # of code; in waiting there are a handful
MICROSECOND = 1e3
MILLISECOND = 1e6


def whole_frames(run):
    """Those in which every pixel was sent, the very first aside."""
    frames = [frame for frame in run.report["frames"][1:] if frame["bytes"] >= 2 * PIXELS]
    expect(len(frames) >= 8, f"of {len(run.report['frames'])} frames only {len(frames)} were sent whole")
    return frames


def duration(frame):
    return frame["end"] - frame["begin"]


def expect_full(frame, bus):
    share = frame["busy"] / duration(frame)
    expect(share >= LEAST_SHARE,
           f"{bus} is busy for {share:.1%} of {frame['note']}, the longest gap has {frame['gap'] / MICROSECOND:.1f} us")
    expect(frame["places"] >= DRAWING_PLACES, f"the processor waits while DMA sends: {frame['places']} places of code")


def first_frame(run):
    """The one that is sent without asking what has changed; and how many bytes a second it brings."""
    frame = run.report["frames"][0]
    return frame, frame["bytes"] / duration(frame) * 1e9


def check_buses(desk, scene):
    """A parallel bus is faster than pictures can be compared; its first frame is what it can do."""
    spi = desk.run(desk.settings("pico-st7789"), scene, "--frames", 12, "--for", 3000)
    for frame in whole_frames(spi):
        expect_full(frame, "SPI")
    expect(spi.frames[-1].skipped == 0, f"{spi.frames[-1].skipped} frames were late")
    parallel = desk.run(desk.settings("pico-ili9341-parallel"), scene, "--frames", 12, "--for", 3000)
    expect_full(first_frame(parallel)[0], "parallel")
    expect(parallel.frames[-1].skipped == 0, f"{parallel.frames[-1].skipped} frames were late")
    cycle = parallel.report["shortest"]["cycle"]
    expect(cycle >= WRITE_CYCLE, f"a write takes {cycle} ns, the display needs {WRITE_CYCLE}")
    slow, fast = first_frame(spi)[1], first_frame(parallel)[1]
    expect(fast >= PARALLEL_GAIN * slow, f"parallel sends {fast / slow:.2f} times what SPI does")
    return slow, fast


def check_tearing(desk, scene):
    settings = desk.settings("pico-st7789", lambda text: text.replace("pins ", "pins tearing=22 "))
    period = 16_900
    run = desk.run(settings, scene, "--frames", 12, "--for", 3000, "--te", period)
    rises = run.report["tearingRises"]
    for frame in whole_frames(run):
        late = min((frame["begin"] - rise for rise in rises if rise <= frame["begin"]), default=None)
        expect(late is not None and late < 200 * MICROSECOND,
               f"{frame['note']} begins {late} ns after the display is ready")
    expect(run.report["registers"]["pins"]["tearing"]["pad"] & 1 << 6, "the pad of the TE line cannot be read")


def check_missing_tearing(desk, scene):
    """The line is promised, but silent: one frame waits for it, no other."""
    settings = desk.settings("pico-st7789", lambda text: text.replace("pins ", "pins tearing=22 "))
    run = desk.run(settings, scene, "--frames", 20, "--for", 3000)
    frames = run.report["frames"]
    waits = [after["begin"] - before["end"] for before, after in zip(frames, frames[1:])]
    expect(sum(wait > 20 * MILLISECOND for wait in waits) <= 1, f"frames wait for a silent line: {waits}")
    steps = [after["at"] - before["at"] for before, after in zip(frames[5:], frames[6:])]
    expect(max(steps) < 18 * MILLISECOND, f"frames of 60 a second come {max(steps) / MILLISECOND:.1f} ms apart")


def check_pace(desk, seconds):
    """The same picture comes after exactly one turn of the scene, and the watchdog is content meanwhile."""
    scene = desk.compile(DOT)
    settings = desk.settings("pico-st7789")
    turn = len(desk.hashes(scene, settings))
    run = desk.run(settings, scene, "--for", 1000 * seconds)
    expect(run.frames[-1].skipped == 0, f"{run.frames[-1].skipped} frames were late")
    period = turn / RATE * 1e9
    pairs = list(zip(run.frames[1:], run.frames[1 + turn:]))
    expect(len(pairs) >= turn, f"{len(run.frames)} frames in {seconds} s are no two turns of {turn}")
    for first, again in pairs:
        expect(first.ticks == again.ticks and first.hash == again.hash, f"frame {first.ticks / TICKS} is another later")
        drift = abs(again.moment - first.moment - period)
        expect(drift < 50 * MICROSECOND, f"frame {first.ticks // TICKS} is {drift / MICROSECOND:.0f} us off its time")
    expect(run.report["starts"] == 1, "the watchdog has bitten")


def check_sixty(desk):
    figures = scene_figures(desk, EYES)
    expect(figures["late"] == 0, f"{EYES.name} at 60 frames a second: {figures['late']} late, {figures['shown']} shown")


def main(programs, images):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        desk = Desk(programs, images, folder)
        scene = desk.compile(ALL_CHANGES)
        spi, parallel = check_buses(desk, scene)
        check_tearing(desk, scene)
        check_missing_tearing(desk, scene)
        check_pace(desk, seconds=11)
        check_sixty(desk)
    print(f"the Pico keeps time: SPI {spi / 1e6:.2f} MB/s, parallel {parallel / 1e6:.2f} MB/s")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"the Pico does not keep time: {failure}")
