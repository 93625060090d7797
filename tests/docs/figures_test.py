"""Figures of README.md and of what docs/benchmarks.md says about its tables are those of the tables.

Called like figures_test.py <kfast>.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from benchmark_tables import cells, is_row, number, tables
from page import ROOT, blocks, prose

KFAST = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
README = (ROOT / "README.md").read_text(encoding="utf-8")
BENCHMARKS = (ROOT / "docs/benchmarks.md").read_text(encoding="utf-8")
MEASURED = tables(BENCHMARKS)
SCENES = ("eyes", "walker", "morph")
FIGURE = re.compile(r"(?<![\w.,-])\d[\d,.]*\d(?![\w-])")

FILES = "Files: bytes"
RAM = "RAM for a scene at its own size, without stack and bands: bytes"
IMAGES = "Images: bytes"
M0, M4 = (f"Beside others on Cortex-M{number}, instructions in a frame, median / worst" for number in (0, 4))
UNCONVERTED, CONVERTED = "ThorVG, to ARGB8888", "ThorVG, whole picture then converted to RGB565"

# The rows of README's table, and what each of their cells tells.
ROWS = [
    ("**file, KFAST**, bytes", [(FILES, "**KFAST**, `.kfb`")]),
    ("Lottie; gzipped", [(FILES, "Lottie"), (FILES, "Lottie, gzipped")]),
    ("GIF", [(FILES, "GIF")]),
    ("**RAM, KFAST**, bytes, without stack (6,288) and bands", [(RAM, "**KFAST**, the block that is lent")]),
    ("ThorVG, heap and canvas", [(RAM, "ThorVG, software engine and Lottie, -Os, heap and canvas")]),
    ("AnimatedGIF, raw", [(RAM, "AnimatedGIF, raw, heap and canvas")]),
    ("**instructions in a frame, KFAST**, Cortex-M0, median", [(M0, "**KFAST**")]),
    ("ThorVG; with the picture converted to RGB565", [(M0, UNCONVERTED), (M0, CONVERTED)]),
    ("AnimatedGIF, raw", [(M0, "AnimatedGIF, raw, by lines")]),
    ("**KFAST**, Cortex-M4, median", [(M4, "**KFAST**")]),
    ("ThorVG; converted to RGB565", [(M4, UNCONVERTED), (M4, CONVERTED)]),
]
PICO = "**frames a second on a Pico, KFAST**, of 60 that are asked for"
ON_A_PICO = "On a Pico"

# Sentences around the table, and what their figures are.
KFAST_CODE, THORVG_CODE, GIF_CODE = ("**KFAST**, core and loop, Cortex-M0", "ThorVG, software engine and Lottie, -Os, Cortex-M0",
                                     "AnimatedGIF, raw, Cortex-M0")
CODE, STACK, STATIC = "code and constants", "stack, deepest", "static RAM"
SENTENCES = {
    r"without stack \(([\d,]+)\)": [(IMAGES, KFAST_CODE, STACK)],
    r"KFAST ([\d,]+) bytes on a Cortex-M0, ThorVG ([\d,]+), AnimatedGIF ([\d,]+)\.":
        [(IMAGES, name, CODE) for name in (KFAST_CODE, THORVG_CODE, GIF_CODE)],
    r"with bands \(([\d,]+)\)": [(IMAGES, KFAST_CODE, STATIC)],
}

# And those of the first screen, above the commands.
EYES = "eyes"
FIRST_SCREEN = {
    r"seconds are ([\d,]+) bytes; as a GIF, ([\d,]+)\.": [(FILES, "**KFAST**, `.kfb`", EYES), (FILES, "GIF", EYES)],
    r"takes ([\d,]+) bytes, besides stack and bands of pixels; with ThorVG, ([\d,]+)\.":
        [(RAM, "**KFAST**, the block that is lent", EYES), (RAM, "ThorVG, software engine and Lottie, -Os, heap and canvas", EYES)],
    r"at ([\d.]+) frames a second": [(ON_A_PICO, EYES, "frames a second")],
}


def section_of_sizes():
    return README.split("\n## Sizes and speeds\n")[1].split("\n## ")[0]


def figure(table, row, column):
    return MEASURED[table][row][column].split(" / ")[0]


class FirstPage(unittest.TestCase):
    def test_each_row_is_that_of_the_benchmarks(self):
        expected = [[name, *("; ".join(figure(*source, scene) for source in sources) for scene in SCENES)]
                    for name, sources in ROWS]
        on_a_pico = [PICO, *(MEASURED[ON_A_PICO][scene]["frames a second"] for scene in SCENES)]
        rows = list(map(cells, filter(is_row, section_of_sizes().splitlines())))
        self.assertEqual(rows, [["", *SCENES], on_a_pico, *expected])

    def test_each_figure_of_its_sentences_is_that_of_the_benchmarks(self):
        lines = [cells(line)[0] if line.startswith("|") else line for line in prose(section_of_sizes())]
        text = re.sub(r"\s+", " ", "\n".join(lines))
        self.assertIn("ST7789 240 x 240 on SPI at 62.5 MHz), asked for 60 frames a second", BENCHMARKS)
        text = re.sub("ST7789 on SPI at 62.5 MHz|of 60 that are asked for|for 30 frames a second", "", text)
        self.look_at(SENTENCES, text)

    def test_each_figure_of_the_first_screen_is_that_of_the_benchmarks(self):
        reasons = re.sub(r"\s+", " ", README.split("![")[1].split("\n    scripts/demo")[0])
        self.assertEqual(reasons.count(" - **"), 3)
        self.look_at(FIRST_SCREEN, reasons.replace("On a fresh Debian 12", ""))

    def look_at(self, sentences, text):
        for pattern, sources in sentences.items():
            [told] = re.finditer(pattern, text)
            self.assertEqual(list(told.groups()), [figure(*source) for source in sources])
            text = text.replace(told.group(), "")
        self.assertEqual(FIGURE.findall(text), [], "no sentence above says where these come from")

    def test_scenes_of_the_first_picture_are_as_short_as_it_says(self):
        tutorial = (ROOT / "docs/tutorial.md").read_text(encoding="utf-8")
        robot = [block.text for block in blocks(tutorial) if block.file_name == "robot.kfast"][-1]
        texts = [robot, *((ROOT / f"examples/{name}.kfast").read_text(encoding="utf-8")
                          for name in ("robot-eyes", "stroller", "logo"))]
        lines = [text.count("\n") for text in texts]
        sizes = list(map(self.compiled_bytes, texts))
        told = re.search(r"texts of (\d+) to (\d+)\s+lines, and (\d+) to (\d+)\s+bytes when compiled", README)
        self.assertEqual(list(map(int, told.groups())), [min(lines), max(lines), min(sizes), max(sizes)])

    @staticmethod
    def compiled_bytes(text):
        with tempfile.TemporaryDirectory(prefix="kfast") as name:
            folder = pathlib.Path(name)
            (folder / "scene.kfast").write_text(text, encoding="utf-8")
            subprocess.run([KFAST, "compile", "scene.kfast"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
            return (folder / "scene.kfb").stat().st_size


class Fit(unittest.TestCase):
    def test_what_a_beam_is_estimated_by(self):
        source = (ROOT / "host/fit/beam_fit.cpp").read_text(encoding="utf-8")
        costs = {name: int(cost) for name, cost in re.findall(r"constexpr double per_(\w+) = (\d+);", source)}
        page = re.sub(r"\s+", " ", (ROOT / "docs/fit.md").read_text(encoding="utf-8"))
        self.assertIn("For the beam, {plotted_corner} instructions are added for each corner of a line and {plotted_point} for each "
                      "point; and where the picture is not the one before, {new_corner} for each corner, {further_line:,} for each "
                      "line but one, and {compared_travel} for each travel".format(**costs), page)


class Packages(unittest.TestCase):
    def test_the_stack_is_that_of_the_deepest_scene_of_the_calibration(self):
        table = (ROOT / "host/fit/cost_table.cpp").read_text(encoding="utf-8")
        deepest = int(re.search(r"\.stack = (\d+)", table)[1])
        page = re.sub(r"\s+", " ", (ROOT / "docs/packages.md").read_text(encoding="utf-8"))
        self.assertIn(f"needs {deepest:,} bytes of it on a Cortex-M0", page)


class Benchmarks(unittest.TestCase):
    """What docs/benchmarks.md says of its own tables."""

    def row_of_goals(self, goal, values):
        row = next(row for name, row in MEASURED["Goals and figures"].items() if name.startswith(goal))
        for scene, value in zip(SCENES, values):
            shown = re.search(r"[\d.]+(?= times)", row[scene])
            with self.subTest(goal=goal, scene=scene):
                if row[scene] == "met" or row[scene].startswith("met:"):
                    self.assertLessEqual(value, 3 if shown else 1)
                if shown:
                    decimals = len(shown.group().partition(".")[2])
                    self.assertEqual(shown.group(), f"{value:.{decimals}f}")

    def test_goals_are_missed_by_as_much_as_it_says(self):
        def of(table, row):
            return [number(MEASURED[table][row][scene]) for scene in SCENES]

        sent = [MEASURED["Bytes sent in a frame, median / mean / worst"][scene] for scene in SCENES]
        image = MEASURED[IMAGES][KFAST_CODE]
        self.row_of_goals("45 k", [value / goal for value, goal in zip(of(M0, "**KFAST**"), of(M0, "goal for the median"))])
        self.row_of_goals("a block of 8 KB", [value / 8192 for value in of(RAM, "**KFAST**, the block that is lent")])
        self.row_of_goals("a `.kfb`", [value / goal for value, goal in zip(of(FILES, "**KFAST**, `.kfb`"), (412, 1434, 1741))])
        self.row_of_goals("16 KB of code", [number(image[CODE]) / 16384] * 3)
        self.row_of_goals("3 times the changed", [number(row["sent"]) / number(row["changed pixels alone"]) for row in sent])

    def test_beams_keep_up_as_it_says(self):
        text = re.sub(r"\s+", " ", BENCHMARKS)
        beams = MEASURED["Beams"]
        instructions_a_second = 125_000_000 / 1.4

        def pictures_a_second(scene, place):
            computed, plotted = beams[scene]["to compute it"], beams[scene]["to plot it"]
            return instructions_a_second / (number(computed, place) + number(plotted, place))

        self.assertIn(f"that is {pictures_a_second('walker', 0):.0f} times a second for `walker` in the median and "
                      f"{pictures_a_second('walker', 1):.0f} at worst, and more for all others", text)
        self.assertTrue(all(pictures_a_second(scene, 1) >= pictures_a_second("walker", 1) for scene in beams))
        budget = instructions_a_second / 100_000
        self.assertIn(f"with {budget:.0f} instructions for each of 100,000 points, `eyes`, `jitterbug`, `lissajous` and `marcher` would",
                      text)
        self.assertEqual([scene for scene in beams if number(beams[scene]["in all, for a point"], 1) < budget],
                         ["eyes", "jitterbug", "lissajous", "marcher"])


if __name__ == "__main__":
    unittest.main()
