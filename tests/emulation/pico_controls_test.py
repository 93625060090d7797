"""Presses buttons and turns knobs of a Pico in the emulator:

    pico_controls_test.py <folder of kfast and kfast-panel> <folder of images> <robot-eyes.kfast>

What they do is seen in the frames that the board shows, each of which must still be the preview's."""

import sys
import tempfile

from pico import Desk, HERE, TICKS, expect

CONTROLS = """
    button 14 play "look"
    button 15 pause
    button 22 sleep
    knob 26 {action}
}}"""
INPUT_CONTROLS = """
    knob 26 input gaze
    button 14 input open
}"""
LOOK = range(18, 51)  # frames of the clip in the scene
FRAMES = 150  # of the scene
FULL = 4095
PULL_UP, PULL_DOWN, INPUT_ENABLE, OUTPUT_DISABLE = 1 << 3, 1 << 2, 1 << 6, 1 << 7
SIO, NO_FUNCTION = 5, 31
DISPLAY_OFF, SLEEP_IN, SLEEP_OUT, DISPLAY_ON = 0x28, 0x10, 0x11, 0x29


def settings(desk, controls):
    return desk.settings("pico-st7789", lambda text: text.rstrip().removesuffix("\n}") + controls)


def play(desk, scene, action, milliseconds, *stimuli):
    """Frames as (milliseconds, ticks), all of which must be the preview's, and the report."""
    chosen = settings(desk, CONTROLS.format(action=action))
    run = desk.run(chosen, scene, "--for", milliseconds, *stimuli)
    hashes = desk.hashes(scene, chosen)
    whole = [frame for frame in run.frames if frame.ticks % TICKS == 0]
    for frame in whole:
        number = frame.ticks // TICKS % len(hashes)
        expect(frame.hash == hashes[number], f"frame {number} is not the preview's after {' '.join(stimuli)}")
    expect(whole, f"after {' '.join(stimuli)} no frame is whole")
    return [(frame.moment / 1e6, frame.ticks) for frame in run.frames], run.report


def between(frames, begin, end):
    return [ticks for moment, ticks in frames if begin <= moment < end]


def check_play(desk, scene):
    """A clip, and after it what was played before: the knob at its end has it stand there."""
    frames, report = play(desk, scene, "speed", 2600, "--knob", f"26@0={FULL // 2 + 1}", "--press", "14@700-760")
    before, after = between(frames, 0, 700), between(frames, 2100, 2600)
    expect(before and set(before) == {0}, f"a knob in the middle does not hold the scene: {before}")
    clip = [ticks // TICKS for ticks in between(frames, 735, 1800)]
    expect(clip == list(range(clip[0], clip[0] + len(clip))) and len(clip) >= 30, f"the button's clip shows {clip}")
    expect(clip[0] in LOOK and clip[-1] in LOOK, f"the button plays frames {clip[0]} to {clip[-1]}")
    expect(set(after) == {0}, f"after its clip comes {after}")
    check_pads(report["registers"]["controls"])


def check_pads(controls):
    for control in controls:
        pad = control["pad"]
        if control["kind"] == "button":
            expect(control["functionSelect"] == SIO, f"the button's pin has function {control['functionSelect']}")
            expect(pad & PULL_UP and pad & INPUT_ENABLE and not pad & PULL_DOWN, f"the button's pad is {pad:#x}")
        else:
            expect(control["functionSelect"] == NO_FUNCTION, "the knob's pin has a digital function")
            expect(pad & OUTPUT_DISABLE and not pad & (PULL_UP | PULL_DOWN | INPUT_ENABLE),
                   f"the knob's pad is {pad:#x}")


def check_pause(desk, scene):
    bouncing = [word for begin in (700, 702, 704) for word in ("--press", f"15@{begin}-{begin + 1}")]
    frames, _ = play(desk, scene, "speed", 1500, "--knob", f"26@0={FULL}", *bouncing, "--press", "15@706-760",
                     "--press", "15@1100-1150")
    standing = set(between(frames, 750, 1100))
    expect(len(standing) == 1, f"a pause shows times {sorted(standing)}")
    going = between(frames, 1150, 1500)
    steps = {after - before for before, after in zip(going, going[1:])}
    expect(all(2 * TICKS - 8 <= step <= 2 * TICKS for step in steps), f"at twice the speed a frame is {steps} ticks")


def check_place(desk, scene):
    frames, _ = play(desk, scene, "place", 1300, "--knob", "26@0=3900", "--knob", "26@700=0",
                     "--knob", f"26@1000={FULL // 3}")
    for begin, end, level in ((440, 700, 3900), (740, 1000, 0), (1040, 1300, FULL // 3)):
        shown = set(between(frames, begin, end))
        expected = FRAMES * TICKS * level // FULL
        expect(len(shown) == 1 and abs(shown.pop() - expected) <= 1, f"at {level} of {FULL} the knob shows {shown}")


def check_sleep(desk, scene):
    frames, report = play(desk, scene, "speed", 1700, "--knob", f"26@0={FULL}", "--press", "22@700-760",
                          "--press", "22@1100-1160")
    expect(not between(frames, 800, 1100), "frames are shown while the display is off")
    expect(len(between(frames, 1350, 1700)) >= 8, "nothing is shown after the display was switched on")
    dark = [command for moment, command in report["commands"] if 700e6 < moment < 1400e6]
    order = [command for command in dark if command in (DISPLAY_OFF, SLEEP_IN, SLEEP_OUT, DISPLAY_ON)]
    expect(order == [DISPLAY_OFF, SLEEP_IN, SLEEP_OUT, DISPLAY_ON], f"the display is told {order}")


def check_brightness(desk, scene):
    def level(value):
        _, report = play(desk, scene, "brightness", 650, "--knob", f"26@0={value}")
        return report["registers"]["light"]
    dark, half, bright = level(0), level(FULL // 2), level(FULL)
    expect(dark == 0 and bright == 1 and 0.02 < half < 0.98,
           f"the backlight is lit for {dark}, {half}, {bright} of the time")


def check_inputs(desk):
    """A fifth of the knob's way is a fifth of the range of its input: both are rounded to the same place."""
    scene, chosen = desk.compile(HERE / "inputs.kfast"), settings(desk, INPUT_CONTROLS)
    run = desk.run(chosen, scene, "--for", 1800, "--knob", f"26@0={FULL // 5}", "--knob", f"26@700={FULL}",
                   "--press", "14@1000-1300", "--knob", f"26@1500={FULL // 5 * 3}")
    seen = set()
    for begin, end, gaze, opened in ((0, 700, -0.6, 0), (740, 1000, 1, 0), (1040, 1300, 1, 100), (1340, 1500, 1, 0),
                                     (1540, 1800, 0.2, 0)):
        hashes = desk.hashes(scene, chosen, "--input", f"gaze={gaze}", "--input", f"open={opened}")
        shown = [frame for frame in run.frames if begin <= frame.moment / 1e6 < end]
        expect(len(shown) >= 4, f"{len(shown)} frames are shown from {begin} to {end} ms")
        for frame in shown:
            expect(frame.hash == hashes[frame.ticks // TICKS % len(hashes)],
                   f"at {frame.moment / 1e6:.0f} ms it is not gaze={gaze} open={opened} that is shown")
        seen.add(hashes[0])
    expect(len(seen) == 4, "the inputs make no difference")


def main(programs, images, source):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        desk = Desk(programs, images, folder)
        scene = desk.compile(source)
        for check in (check_play, check_pause, check_place, check_sleep, check_brightness):
            check(desk, scene)
        check_inputs(desk)
    print("buttons and knobs do what the settings say")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"a control of the Pico does not work: {failure}")
