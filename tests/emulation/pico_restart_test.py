"""Scenes that hang, on the Pico's images: its watchdog restarts it, and the second time it plays something else.

    pico_restart_test.py <folder of kfast and kfast-panel> <folder of images> <scene.kfast>

The stories are in link_stories.mjs; what hangs is the firmware at the moment when a scene begins (rp2040/hang.mjs)."""

import pathlib
import sys
import tempfile

from PIL import Image

from card_text import lines_on
from pico import HERE, Desk, expect

BUILT_IN, SLOT, RAM = 0, 1, 2
NO_SLOT = 255


def tell(desk, settings, scene, story, **look):
    first = desk.compile(HERE / "link_first.kfast")
    run = desk.run(settings, scene, "--link", story, "--file", f"first={first}", **look)
    return run, run.report["usb"]


def restarts_told(run):
    return [line for line in run.log if line.startswith("RESTARTED")]


def check_slot(desk, configuration, scene):
    run, told = tell(desk, desk.settings(configuration), scene, "hangs")
    expect(told["before"]["count"] == 0, f"{configuration}: it tells of restarts before there were any: {told}")
    expect(told["hangs"] == 2 and told["starts"] == 3, f"{configuration}: {told['hangs']} hangs, {told['starts']} starts")
    expect(restarts_told(run) == ["RESTARTED 1", "RESTARTED 2"], f"{configuration}: the log has {run.log}")
    for moment in ("atStart", "playing", "afterwards"):
        playing = told[moment]
        expect(playing["plays"] and playing["home"] == BUILT_IN, f"{configuration}: {moment} it plays {playing}")
        expect(playing["restarts"] == {"count": 2, "home": SLOT, "slot": 2}, f"{configuration}: {moment} it says {playing}")
    expect(told["powered"] == 0, f"{configuration}: it remembers restarts when the power comes on")


def check_built_in(desk, scene):
    settings = desk.settings("pico-st7789")
    shown = desk.folder / "shown"
    run, told = tell(desk, settings, scene, "hangsBuiltIn", pictures=shown, look_at_end=True)
    expect(told["hangs"] == 2 and told["starts"] == 3, f"{told['hangs']} hangs, {told['starts']} starts")
    expect(not told["playing"]["plays"], f"in safe mode it plays {told['playing']}")
    expect(told["playing"]["restarts"] == {"count": 2, "home": BUILT_IN, "slot": NO_SLOT}, f"it says {told['playing']}")
    expect(told["fromRam"]["home"] == RAM, f"from RAM it plays {told['fromRam']}")
    title, *words = lines_on(Image.open(sorted(shown.iterdir())[-1]).convert("RGB"))
    expect(title == "SAFE MODE", f"the display shows {title}")
    words = " ".join(word for word in words if word)
    expect(words == "THE BUILT-IN SCENE HUNG: NOTHING PLAYS", f"the display says {words}")


def main(programs, images, source):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        desk = Desk(programs, pathlib.Path(images), folder)
        scene = desk.compile(source)
        check_slot(desk, "pico-st7789", scene)
        check_slot(desk, "pico-ssd1306-i2c", scene)
        check_built_in(desk, scene)
    print("a scene that hangs is left out after two restarts")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"restarts: {failure}")
