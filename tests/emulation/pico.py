"""A Pico in the emulator: its settings, runs of its images, and what the display showed."""

import dataclasses
import functools
import json
import pathlib
import subprocess
import time

from panel_trace import Kind, record

HERE = pathlib.Path(__file__).resolve().parent
CONFIGURATIONS = HERE.parents[1] / "boards" / "pico" / "configurations"
RUNNER = HERE / "rp2040" / "run_pico.mjs"
TICKS = 1024  # of a frame
MONOCHROME = ("ssd1306",)


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


@dataclasses.dataclass(frozen=True)
class Settings:
    """A board record, and what a test must know of it."""
    record: pathlib.Path
    controller: str
    bus: str
    size: str  # of the picture, as in 320x240

    @property
    def format(self):
        return "mono1" if self.controller in MONOCHROME else "rgb565"


@dataclasses.dataclass(frozen=True)
class Shown:
    """A frame on the display when the board said that it is there."""
    ticks: int
    skipped: int  # frames since the beginning
    hash: str
    moment: float  # nanoseconds since the power came on


def expect_scene(frames, hashes, who):
    """That all frames are those of the scene which Desk.hashes() are of."""
    for shown in frames:
        expect(shown.hash == hashes[shown.ticks // TICKS % len(hashes)],
               f"{who} shows something else at {shown.ticks / TICKS:.0f}")


class Run:
    """What a run has brought: the runner's report, and what `kfast-panel` makes of the trace."""

    def __init__(self, report, told):
        self.report = report
        self.told = told

    @property
    def log(self):
        return [text for _, text in self.report["log"]]

    @functools.cached_property
    def frames(self):
        lines = [line.split() for line in self.told if line.startswith("F ")]
        return [Shown(int(ticks), int(skipped), value, sent["at"])
                for (_, ticks, skipped, value), sent in zip(lines, self.report["frames"], strict=True)]


class Desk:
    """`programs` holds kfast and kfast-panel, `images` the Pico's images; files go to `folder`."""

    def __init__(self, programs, images, folder):
        self._programs = pathlib.Path(programs)
        self._images = pathlib.Path(images)
        self.folder = pathlib.Path(folder)
        self._trace, self._report = self.folder / "trace.kft", self.folder / "report.json"

    def kfast(self, *arguments):
        return self._call(self._programs / "kfast", *arguments).stdout

    def settings(self, configuration, change=lambda text: text):
        """A ready configuration that tells its log, changed as text; the log's pin is one that nobody uses."""
        text = (CONFIGURATIONS / f"{configuration}.kdl").read_text(encoding="utf-8")
        pin = 28 if "bus parallel" in text else 0
        text = change(text.replace("\n    pins ", f"\n    pins log={pin} "))
        source, record = self.folder / f"{configuration}.kdl", self.folder / f"{configuration}.bin"
        source.write_text(text, encoding="utf-8")
        self.kfast("config", source, "-o", record)
        words = text.split("panel ")[1].split("\n")[0].split()
        width, height = words[1:3]
        across = "rotation=90" in words or "rotation=270" in words
        return Settings(record, words[0], text.split("bus ")[1].split()[0],
                        f"{height}x{width}" if across else f"{width}x{height}")

    def image(self, settings):
        """The one for the settings' bus."""
        image = self._images / f"pico-{settings.bus}.bin"
        expect(image.is_file(), f"{image} is missing: build the preset pico first")
        return image

    def compile(self, source):
        compiled = self.folder / f"{pathlib.Path(source).stem}.kfb"
        self.kfast("compile", source, "-o", compiled)
        return compiled

    def hashes(self, scene, settings, *options):
        """Of every frame of the scene as the board is to show it."""
        told = self.kfast("hash", scene, "--size", settings.size, "--format", settings.format, *options)
        return [line.split()[1] for line in told.splitlines()]

    def run(self, settings, scene=None, *options, image=None, pictures=None, look_at_end=False):
        """Boots the image for the settings' bus, or `image`. Whatever is wrong with it or on the wires is an
        AssertionError. Pictures of the frames go to the folder `pictures`; with `look_at_end` one more is what is shown
        at the end."""
        placed = [] if scene is None else ["--scene", scene]
        self._call("node", RUNNER, image or self.image(settings), *self.recorded(settings), *placed, *options)
        return self.look(settings, pictures, look_at_end)

    def recorded(self, settings):
        """The options of a board whose run look() can look at."""
        return ["--settings", settings.record, "--trace", self._trace, "--report", self._report]

    def look(self, settings, pictures=None, look_at_end=False):
        """What has been recorded, played into the model of the display; see run()."""
        found = json.loads(self._report.read_text(encoding="utf-8"))
        if look_at_end:
            with open(self._trace, "ab") as trace:
                trace.write(record(Kind.NOTE, round(found["milliseconds"] * 1e6), b"F 0 0"))
        wanted = [] if pictures is None else ["--pictures", pictures]
        told = self._call(self._programs / "kfast-panel", self._trace, settings.record, *wanted).stdout.splitlines()
        return Run(found, told[:-1] if look_at_end else told)

    def watch(self, board, settings, count):
        """The next `count` frames, or more, of a ServedPico that plays and was started with recorded(settings). The one
        that it draws at this moment is not among them."""
        board.command("record")
        since = json.loads(self._report.read_text(encoding="utf-8"))["milliseconds"] * 1e6
        frames = []
        while len(frames) < count:
            time.sleep(1)
            board.command("record")
            frames = [shown for shown in self.look(settings).frames if shown.moment > since][1:]
        return frames

    def _call(self, *command):
        done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, timeout=600, check=False)
        expect(done.returncode == 0, f"{pathlib.Path(command[0]).name}: {done.stderr.strip()}")
        return done
