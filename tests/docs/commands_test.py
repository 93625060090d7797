"""Every command of README.md, docs/*.md and the READMEs of examples/ does what the page says, in a folder with the files that the
page makes.

Called like commands_test.py <kfast>. README.md beside it has the rules by which pages are written.
"""

import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import textwrap
import unittest

import not_run
from page import CLOSING_COMMENT, ROOT, blocks, pages, prose, shown_figures, shown_status

sys.path.insert(0, str(ROOT / "tests/host/commands"))
from pretend_firmware import firmware

HERE = pathlib.Path(__file__).resolve().parent
KFAST = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
SPAN = re.compile(r"`(kfast [a-z][^`]*)`")

# Files that a reader of these pages has, beside those in the folder readers_files.
FILES = {
    "eyes.json": "tests/accuracy/lottie/eyes.json",
    "scene.kfast": "examples/robot-eyes.kfast",
    **{f"{name}.kfast": f"examples/{name}.kfast" for name in ("clock-face", "logo", "robot-eyes")},
    **{f"wink-{number}.svg": f"examples/import/wink-{number}.svg" for number in range(5)},
    **{f"{name}.svg": f"examples/import/{name}.svg" for name in ("day", "night")},
    **{path.name: path.relative_to(ROOT) for path in (HERE / "readers_files").iterdir()},
}
FIRMWARE_BYTES = 134504
BUSES = ("spi", "parallel", "i2c", "xy") # in the order of firmware/settings/image_mark.hpp


def matches(shown, told):
    """Whether the lines shown are told in their order; an ellipsis stands for anything, alone for any number of lines."""
    parts = [".*?".join(re.escape(part) for part in line.rstrip().split("…")) for line in shown.strip("\n").split("\n")]
    pattern = ""
    for part in parts:
        pattern += r"(?:[^\n]*\n)*?" if part == ".*?" else part.replace(".*?", "[^\n]*?") + r"[ ]*\n"
    return re.search("(?:^|\n)" + pattern, told.strip("\n") + "\n") is not None


class Reader:
    """Somebody who follows a page from its top, in a folder like the project's."""

    def __init__(self, folder):
        self.folder = folder
        self.simulator = None
        self.environment = {**os.environ, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder), "XDG_DATA_HOME": str(folder),
                            "XDG_STATE_HOME": str(folder), "XDG_RUNTIME_DIR": str(folder),
                            "PATH": f"{folder}/build/host/bin:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1",
                            "KFAST_REAL": str(KFAST), "KFAST_SIMULATED": f"sim:{folder}/board.sock",
                            "KFAST_FIRMWARE": f"{folder}/build/pico"}
        shutil.copytree(ROOT / "examples", folder / "examples")
        (folder / "tests").symlink_to(ROOT / "tests")
        stand_in = folder / "build/host/bin/kfast"
        stand_in.parent.mkdir(parents=True)
        stand_in.write_text(f'#!/bin/sh\nexec {sys.executable} {HERE}/documented_kfast.py "$@"\n')
        stand_in.chmod(stand_in.stat().st_mode | stat.S_IXUSR)
        images = folder / "build/pico"
        images.mkdir(parents=True)
        for number, bus in enumerate(BUSES):
            (images / f"pico-{bus}.bin").write_bytes(firmware(FIRMWARE_BYTES, mark=b"KFPI" + bytes([number, 0, 0, 0])))

    def save(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def needs(self, command):
        for name, source in FILES.items():
            if re.search(rf"(?<![\w/-]){re.escape(name)}\b", command) and not (self.folder / name).exists():
                if not re.search(rf"-o {re.escape(name)}\b", command):
                    shutil.copy(ROOT / source, self.folder / name)
        if not self.simulator:
            self.simulator = subprocess.Popen(
                [KFAST, "simulate", "--headless", "--socket", "board.sock", "--flash-file", "board.bin"], cwd=self.folder,
                env=self.environment, stdout=subprocess.PIPE, text=True)
            self.simulator.stdout.readline()

    def run(self, command):
        self.needs(CLOSING_COMMENT.sub("", command))
        return subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=self.folder, env=self.environment, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)

    def leave(self):
        if self.simulator:
            self.simulator.terminate()
            self.simulator.wait()
            self.simulator.stdout.close()


class PageTest(unittest.TestCase):
    def follow(self, path):
        with tempfile.TemporaryDirectory(prefix="kfast") as name:
            reader = Reader(pathlib.Path(name))
            self.addCleanup(reader.leave)
            told = None
            page = list(blocks(path.read_text(encoding="utf-8")))
            for block in reversed(page): # commands at the top of a page may use what it shows below
                if block.file_name and not block.is_commands:
                    reader.save(block.file_name, block.text)
            for block in page:
                place = f"{path.relative_to(ROOT)}:{block.line}"
                if block.file_name and not block.is_commands:
                    reader.save(block.file_name, block.text)
                elif block.is_commands:
                    told = self.run_all(reader, path, block)
                elif block.language == "text" and told is not None and not told.startswith("not run: "):
                    with self.subTest(place=place):
                        self.assertTrue(matches(block.text, told), f"shows another output than this:\n{told}")
            reader.leave()

    def run_all(self, reader, path, block):
        told = ""
        for line, command in block.commands():
            if not_run.is_other(command):
                told = "not run: "
                continue
            with self.subTest(place=f"{path.relative_to(ROOT)}:{line}", command=command):
                result = reader.run(re.sub(r"^sudo ", "", command))
                told = result.stdout
                self.assertEqual(result.returncode, shown_status(command), told)
                if not told.startswith("not run: "):
                    for figure in shown_figures(command):
                        self.assertRegex(told, rf"(?<![\d.]){re.escape(figure)}(?![\d.]\d)", "the comment tells another figure")
        return told


def one_page(path):
    return lambda test: test.follow(path)


for document in pages():
    name = re.sub(r"\W", "_", str(document.relative_to(ROOT).with_suffix("")).removeprefix("docs/")).lower()
    setattr(PageTest, f"test_{name}", one_page(document))


class SpanTest(unittest.TestCase):
    def test_commands_within_sentences_name_what_there_is(self):
        environment = {**os.environ, "KFAST_REAL": str(KFAST), "KFAST_SIMULATED": ""}
        sys.path.insert(0, str(HERE))
        os.environ.update(environment)
        import documented_kfast
        for path in pages():
            for number, line in enumerate(prose(path.read_text(encoding="utf-8")), 1):
                for span in SPAN.findall(line):
                    for call in re.split(r" / (?=kfast)", span):
                        with self.subTest(place=f"{path.relative_to(ROOT)}:{number}", span=span):
                            self.assertEqual(documented_kfast.unknown_words(self.words(call)), [])

    @staticmethod
    def words(call):
        return [word.strip("[],") for word in call.split()[1:] if word.strip("[]|/,…")]


class RulesTest(unittest.TestCase):
    def test_each_row_of_what_is_not_run_is_needed(self):
        commands = [command for path in pages() for block in blocks(path.read_text(encoding="utf-8")) if block.is_commands
                    for _, command in block.commands()]
        calls = [call for command in commands for call in re.findall(r"\bkfast .*", command)]
        for row in not_run.KFAST:
            self.assertTrue(any(re.search(row.pattern, call) for call in calls), row.pattern)
        for pattern, _ in not_run.OTHERS:
            self.assertTrue(any(re.search(pattern, command) for command in commands), pattern)

    def test_output_is_compared(self):
        told = "eyes.uf2: 3 blocks\n  for RP2040: 3 blocks\n  0x10 firmware\n"
        self.assertTrue(matches("eyes.uf2: 3 blocks\n", told))
        self.assertTrue(matches("eyes.uf2: … blocks\n…\n  0x10 firmware\n", told))
        self.assertFalse(matches("eyes.uf2: 4 blocks\n", told))
        self.assertFalse(matches("eyes.uf2: 3 blocks\n  0x10 firmware\n", told))
        self.assertFalse(matches("  0x10 firmware\n…\neyes.uf2: 3 blocks\n", told))

    def test_commands_are_found(self):
        text = textwrap.dedent("""\
            Words.

                kfast check a.kfast   # exit status 1
                python3 -c 'for n in range(3):
                  print(n)' | kfast live a.kfast
                kfast panel a.kfast --pin dc=1 \\
                      --pin reset=2

                void code();
            """)
        [block] = blocks(text)
        self.assertEqual([line for line, _ in block.commands()][:3], [3, 4, 6])
        self.assertEqual([shown_status(command) for _, command in block.commands()][:2], [1, 0])

    def test_figures_of_comments_are_found(self):
        self.assertEqual(shown_figures("kfast compile a.kfast --fps 25   # a.kfb, 310 bytes, at 31.6 fps, 480x480"),
                         ["310", "31.6", "480x480"])


if __name__ == "__main__":
    unittest.main()
