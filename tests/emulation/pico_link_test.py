"""A computer speaks the link with the Pico's images over USB (rp2040/link_host.mjs):

    pico_link_test.py <folder of kfast and kfast-panel> <folder of images> <scene.kfast>

The scene is the built-in one. What the computer does are the stories of link_stories.mjs; here it is compared what the
display shows, frame by frame: whatever happens, each is one of the scene that plays, whole."""

import pathlib
import sys
import tempfile
import zlib

from pico import HERE, TICKS, Desk, expect

SERIAL = "E4613852C71B9D0F"
BLOCK_BYTES = 60  # of a scene, in each data report but the last
FIRST_BYTES = 2048
SECOND_BYTES = 6000  # two sectors
SPARE_STACK = 2048
ERASE_ANYWHERE = 400  # ms, at worst


def padded(scene, size):
    """Bytes behind a scene belong to the file and not to it."""
    data = scene.read_bytes()
    expect(len(data) < size, f"{scene} has {len(data)} bytes")
    longer = scene.with_suffix(".long.kfb")
    longer.write_bytes(data + bytes((i * 37 + 11) & 255 for i in range(size - len(data))))
    return longer


class Bench:
    """A board with a display on SPI, and three scenes."""

    def __init__(self, desk, source):
        self.desk = desk
        self.settings = desk.settings("pico-st7789")
        self.built_in = desk.compile(source)
        self.scenes = {"first": desk.compile(HERE / "link_first.kfast"),
                       "second": desk.compile(HERE / "link_second.kfast")}
        sizes = {"first": FIRST_BYTES, "second": SECOND_BYTES}
        self.files = [f"{name}={padded(scene, sizes[name])}" for name, scene in self.scenes.items()]
        self.known = {self.line(scene): desk.hashes(scene, self.settings)
                      for scene in [self.built_in, *self.scenes.values()]}

    @staticmethod
    def line(scene):
        """What the log says when it begins."""
        data = scene.read_bytes()
        return f"SCENE {len(data)} {zlib.crc32(data):08x}"

    def tell(self, story, *options, scene=True, settings=None):
        files = [word for each in self.files for word in ("--file", each)]
        run = self.desk.run(settings or self.settings, self.built_in if scene else None, "--link", story, *files,
                            *options)
        expect(run.report["freeStack"] >= SPARE_STACK, f"{story}: {run.report['freeStack']} bytes of the stack are left")
        return run

    def check_frames(self, run, story, hashes_of=None):
        """Each frame is that of the scene that the log named last. Returns the names of the scenes."""
        frames = iter(run.frames)
        known = hashes_of or self.known
        played = []
        for line in run.log:
            if line.startswith("SCENE "):
                expect(line in known, f"{story}: {line} is none of the scenes")
                played.append(line)
            elif line.startswith("F "):
                shown, hashes = next(frames), known[played[-1]]
                expect(shown.ticks % TICKS == 0 and shown.hash == hashes[shown.ticks // TICKS % len(hashes)],
                       f"{story}: something else is shown at {shown.ticks / TICKS} of {played[-1]}")
        return played


def check_tells(bench):
    told = bench.tell("tells").report["usb"]
    expect(told["protocol"] == 2 and told["slots"] == 8 and told["panel"] == [240, 240], f"the board is {told}")
    expect(told["serial"] == SERIAL and told["names"][2] == SERIAL, f"its number is {told['serial']}")
    expect(told["board"] == "pico" and told["display"] == "st7789" and told["firmware"], f"it calls itself {told}")
    expect(told["ram"] >= 16 * 1024 and told["pool"] == told["room"] == 0x17C000, f"its memory is {told}")
    expect(told["playing"]["plays"] and told["playing"]["home"] == 0, f"it plays {told['playing']}")


def check_ram(bench):
    run = bench.tell("ram")
    told = run.report["usb"]
    first, second = (bench.line(scene) for scene in bench.scenes.values())
    played = bench.check_frames(run, "ram")
    expect(played == [bench.line(bench.built_in), first, second, first], f"RAM: it plays {played}")
    expect(run.report["flash"]["operations"] == [], "flash is written for a scene in RAM")
    expect(told["waits"] == 0, f"the computer waits {told['waits']} times")
    sizes = [FIRST_BYTES, SECOND_BYTES, FIRST_BYTES]
    blocks = sum(-(-size // BLOCK_BYTES) for size in sizes)
    expect((told["dataReports"], told["dataBytes"]) == (blocks, sum(sizes)),
           f"{told['dataReports']} reports carry {told['dataBytes']} bytes: not each of them {BLOCK_BYTES}, and once")
    expect(max(told["delays"]) < 100, f"scenes begin after {told['delays']} ms")
    expect(told["statistics"]["errors"] == 0 and told["statistics"]["late"] == 0, f"statistics: {told['statistics']}")
    return f"scenes in RAM begin after {max(told['delays']):.0f} ms"


def check_slot(bench, erase_time):
    flash = bench.desk.folder / "flash.bin"
    run = bench.tell("slot", "--keep-flash", flash, "--erase-time", erase_time)
    first, second = (bench.line(scene) for scene in bench.scenes.values())
    played = bench.check_frames(run, "slot")
    expect(played == [bench.line(bench.built_in), first], f"slot: it plays {played}")
    statistics = run.report["usb"]["statistics"]
    expect(statistics["late"] > 0 and statistics["errors"] == 0, f"frames that are late are not counted: {statistics}")
    if erase_time >= 100:
        expect(statistics["skipped"] > 0, f"no frame is left out: {statistics}")
    again = bench.tell("nothing", "--flash", flash)
    played = bench.check_frames(again, "slot, started again")
    expect(played == [second] and again.report["usb"]["playing"]["slot"] == 4, f"after a start it plays {played}")
    return statistics


def check_steers(bench):
    run = bench.tell("steers")
    looking = bench.desk.hashes(bench.scenes["first"], bench.settings, "--input", "gaze=1")
    frame = run.report["usb"]["seen"]
    last = run.frames[-1]
    expect(last.ticks == frame * TICKS and last.hash == looking[int(frame)], "the input is not seen")
    known = {name: None for name in bench.known}
    expect(set(line for line in run.log if line.startswith("SCENE")) <= set(known), "it plays something else")


def check_cuts(bench):
    run = bench.tell("cuts", "--for", 1_000_000)
    played = run.report["usb"]["played"]
    first, second = (bench.line(scene) for scene in bench.scenes.values())
    expect(len(played) > 3 * 30, f"power is cut {len(played)} times")
    expect(set(played) == {first, second} and played[0] == first and played[-1] == second, f"started again it plays {played}")
    whole = played[1:-1:3]
    switch = whole.index(first) if first in whole else 0
    expect(whole[switch:] == sorted(whole[switch:], key=[first, second].index), f"it changes to and fro: {whole}")
    return len(played)


def check_others(bench):
    for story in ("silence", "garbage"):
        played = bench.check_frames(bench.tell(story), story)
        expect(bench.line(bench.scenes["first"]) in played, f"{story}: it plays {played}")
    run = bench.tell("card", scene=False)
    played = bench.check_frames(run, "card")
    expect(played == [bench.line(bench.scenes["first"])], f"card: it plays {played}")
    turns = run.report["ledTurns"]
    expect(len(turns) >= 2 and len(turns) % 2 == 0, f"card: the light of the board turns at {turns} ms")
    told = bench.tell("bootLoader").report["usb"]
    expect(told["ending"] == "restarted as a USB drive" and 90 < told["after"] < 130, f"boot loader: {told}")
    expect(told["kept"] == 0, "what is kept for a restart by the watchdog is there after the boot loader")
    told = bench.tell("blind", "--patch", f"{0x3F000 + 22}=99").report["usb"]
    expect(not told["playing"]["plays"], f"a board without settings: {told}")


def check_other_buses(bench):
    for configuration in ("pico-ssd1306-i2c", "pico-ili9341-parallel"):
        settings = bench.desk.settings(configuration)
        known = {bench.line(scene): bench.desk.hashes(scene, settings)
                 for scene in [bench.built_in, *bench.scenes.values()]}
        run = bench.tell("ram", settings=settings)
        played = bench.check_frames(run, configuration, known)
        told = run.report["usb"]
        expect(len(played) == 4 and told["waits"] == 0, f"{configuration}: {played}, {told['waits']} waits")


def main(programs, images, source):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        bench = Bench(Desk(programs, pathlib.Path(images), folder), source)
        check_tells(bench)
        print(check_ram(bench))
        for erase_time in (50, ERASE_ANYWHERE):
            print(f"erasing takes {erase_time} ms: {check_slot(bench, erase_time)}")
        check_steers(bench)
        check_others(bench)
        check_other_buses(bench)
        print(f"power was cut {check_cuts(bench)} times")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AssertionError as failure:
        sys.exit(f"the link: {failure}")
