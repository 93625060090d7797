"""README.md shows figures of docs/benchmarks.md, and commands.md and the help of the command name the same commands.

Called like figures_test.py <kfast>.
"""

import pathlib
import re
import subprocess
import sys
import unittest

from page import ROOT

KFAST = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
FIGURE = re.compile(r"(?<![\w-])\d[\d,]*\d(?![\w-])")


class Figures(unittest.TestCase):
    def test_of_the_first_page_are_measured(self):
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        measured = (ROOT / "docs/benchmarks.md").read_text(encoding="utf-8")
        section = readme.split("\n## Sizes and speeds\n")[1].split("\n## ")[0]
        figures = [figure for figure in FIGURE.findall(section.split("\n|", 1)[1]) if len(figure) > 2]
        self.assertGreater(len(figures), 30)
        for figure in figures:
            with self.subTest(figure=figure):
                self.assertRegex(measured, rf"(?<![\d,]){figure}(?![\d,])")


class Commands(unittest.TestCase):
    def test_all_of_them_are_listed(self):
        told = subprocess.run([KFAST, "--help"], capture_output=True, text=True, check=True).stdout
        listed = (ROOT / "docs/commands.md").read_text(encoding="utf-8")
        words = set(re.findall(r"`(?:kfast )?([a-z][\w-]*)", listed))
        commands = re.findall(r"(?m)^  ([a-z][\w-]*)  +[A-Z]", told)
        self.assertGreater(len(commands), 25)
        self.assertEqual([command for command in commands if command not in words], [])


if __name__ == "__main__":
    unittest.main()
