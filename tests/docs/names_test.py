"""What the documents call by its name is there: commands, keys, errors, scripts with their options, presets, files.

Called like names_test.py <kfast>.
"""

import functools
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

import not_run
from benchmark_tables import cells, is_row
from page import ROOT, all_pages, pages

KFAST = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
FOLDERS = "boards|cmake|core|docs|editors|examples|firmware|host|library|packages|scripts|tests"
PATH = re.compile(rf"(?<![\w/.-])(?:{FOLDERS})/[\w./-]*\w")
# By the reader, by npm, by scripts/assemble; or a folder of another project.
MADE = re.compile(r"boards/my-board|firmware/panel/ili9163|tests/emulation/node_modules|examples/robot_eyes|tests/test_cases")
SCRIPT = re.compile(r"(?<![\w/.-])scripts/[\w.-]+\w(?:[ \t]+[\w=./-]+)*")
ROOMS = [path for path in all_pages() if path.name == "README.md" and path not in pages()]
DOCUMENTS = [*pages(), *ROOMS, ROOT / "CONTRIBUTING.md"]


def told(*arguments):
    return subprocess.run([KFAST, *arguments], capture_output=True, text=True, check=True).stdout


def section(page, heading):
    return (ROOT / "docs" / page).read_text(encoding="utf-8").split(f"\n## {heading}\n")[1].split("\n## ")[0]


@functools.lru_cache(maxsize=None)
def sources_of(script):
    """The text of a script, and of the Python files that it starts."""
    text = (ROOT / script).read_text(encoding="utf-8")
    return text + "".join((ROOT / name).read_text(encoding="utf-8") for name in re.findall(r"tests/[\w/]+\.py", text))


def files_in_tables(readme):
    """What stands in the column for files of its tables "file" and "you look for"."""
    column = None
    for line in readme.read_text(encoding="utf-8").splitlines():
        row = cells(line) if is_row(line) else []
        column = {"file": 0, "you look for": 1}.get(row[0], column) if row else column if line.startswith("|") else None
        if row and column is not None:
            yield from (name for name in re.findall(r"`([\w./-]+)`", row[column]) if "NAME" not in name)


def each_text():
    """Of every document the place and the text of its lines, those of blocks included; of READMEs of rooms without the targets
    of links, which are not relative to the root."""
    for path in DOCUMENTS:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            yield path, f"{path.relative_to(ROOT)}:{number}", re.sub(r"\]\([^)]*\)", "]", line) if path in ROOMS else line


class Program(unittest.TestCase):
    def test_all_commands_are_listed_and_no_others(self):
        table = [cells(line)[0] for line in (ROOT / "docs/commands.md").read_text(encoding="utf-8").splitlines() if is_row(line)]
        listed = {word for cell in table for span in re.findall(r"`([^`]*)`", cell)
                  for word in re.findall(r"^(?:kfast )?([a-z][\w-]*)", span)}
        commands = re.findall(r"(?m)^  ([a-z][\w-]*)  +[A-Z]", told("--help"))
        self.assertGreater(len(commands), 25)
        self.assertEqual(sorted(listed - {"unpack"}), sorted(commands)) # unpack: of "kfast uf2"

    def test_keys_of_the_preview(self):
        keys = re.findall(r"(?m)^  (\S+)  +\S", re.split(r"(?m)^Keys of .*:\n", told("preview", "--help"))[1])
        page = section("preview.md", "Keys")
        rows = [cells(line)[0] for line in page.splitlines() if is_row(line)][1:]
        in_table = [name.strip("`") for cell in rows for name in re.split(r",? ", cell)]
        beside = set(re.findall(r"`(\S)`", page)) - set(in_table)
        self.assertEqual([key for key in keys if key not in beside], in_table, "in the order of the program")
        self.assertEqual(beside, {"h", "?", "+", "-"})

    def test_errors_of_displays(self):
        every = re.findall(r"(?m)^    (\w+)(?: = \d+)?,", (ROOT / "core/bytes/result.hpp").read_text(encoding="utf-8"))
        names = [name for name in every if not name.startswith("needs_")]
        features = [name.removeprefix("needs_") for name in every if name.startswith("needs_")]
        rows = [cells(line)[:2] for line in section("troubleshooting.md", "The display shows E and a number").splitlines()
                if re.match(r"\| E\d", line)]
        self.assertEqual(rows[:-1], [[f"E{number}", f"`{name}`"] for number, name in enumerate(names, 1)])
        self.assertEqual(rows[-1], [f"E64 … E{63 + len(features)}", "`needs_strokes` …"])
        self.assertIn(f"built without: {', '.join(features)} |", section("troubleshooting.md", "The display shows E and a number"))
        table = section("library.md", "Only what a scene needs")
        self.assertEqual(re.findall(r"(?m)^\| `(\w+)` \| .* KB \|$", table), features)
        costs = (ROOT / "host/fit/cost_table.cpp").read_text(encoding="utf-8").split("// cortex-m3")[0]
        weighed = re.findall(r"bare_code = (\d+),\s+\.feature_code = \{([\d, ]+)\}", costs)[0]
        self.assertEqual(re.findall(r"(?m) ([\d.]+) KB \|$", table),
                         [f"{int(size) / 1000:.1f}" for size in [weighed[0], *weighed[1].split(", ")]])
        link = (ROOT / "docs/link.md").read_text(encoding="utf-8")
        words = [name.replace("_", " ") for name in names]
        self.assertIn(f"| 1 … {len(names)} |", link)
        self.assertEqual(re.findall(r"(?<=[:,] )(\d) ([a-z ]+?)(?= \(|[,|]| \|)", re.search(r"as E1 … .*", link).group()),
                         [(str(number), word) for number, word in enumerate(words, 1)])
        self.assertEqual(len(names), 7, "E1 … E7 is written in several places")


    def test_controllers_of_displays(self):
        known = re.search(r"A known panel: ((?:\w+, )*\w+)", told("panel", "--help")).group(1).split(", ")
        table = section("config.md", "The text").split("| controller | memory |")[1].split("\n\n")[0]
        self.assertEqual(re.findall(r"(?m)^\| `(\w+)`", table), known)
        first_page = (ROOT / "README.md").read_text(encoding="utf-8")
        self.assertEqual([name for name in known if name.upper() not in first_page], [])
        self.assertEqual("the same seven controllers" in first_page, len(known) == 7)

    def test_boards_and_panels_of_fit(self):
        boards = re.search(r"A known board \(([^)]*)\)", told("fit", "--help")).group(1).split(", ")
        page = section("fit.md", "A board of your own")
        listed = re.search(r"The boards that kfast knows.*?\. Those", page, re.DOTALL).group()
        self.assertEqual(re.findall(r"`([\w-]+)`", listed), boards)
        scene = str(ROOT / "examples/spinner.kfast")
        refused = subprocess.run([KFAST, "fit", scene, "--board", "pico", "--panel", "-"], capture_output=True, text=True).stderr
        rows = [cells(line)[:3] for line in page.split("| panel | size |")[1].splitlines() if is_row(line) and "`" in line]
        self.assertEqual([name.strip("`") for name, *_ in rows], re.search(r"allowed: ([^;]*)", refused).group(1).split(", "))
        for name, size, kind in rows:
            report = subprocess.run([KFAST, "fit", scene, "--board", "pico", "--panel", name.strip("`"), "--json"],
                                    capture_output=True, text=True).stdout
            panel = json.loads(report)["panel"]
            self.assertEqual([size, kind.split(",")[0]], [f"{panel['width']}x{panel['height']}", panel["format"]], name)


class Project(unittest.TestCase):
    def test_files_that_are_named(self):
        for path, place, line in each_text():
            for name in PATH.findall(line):
                with self.subTest(place=place, name=name):
                    self.assertTrue(MADE.match(name) or (ROOT / name).exists() or list(ROOT.glob(name + "*")))

    def test_folders_of_the_design_are_those_that_there_are(self):
        folders = section("design.md", "The way of the data").partition("### Rooms")[0]
        named = {name for line in folders.splitlines() if is_row(line) for name in re.findall(r"`([\w.]+)/`", cells(line)[0])}
        self.assertEqual(named - {".ci"}, set(FOLDERS.split("|")))

    def test_glossary_names_what_the_code_has(self):
        code = "".join(path.read_text(encoding="utf-8") for folder in ("core", "firmware", "host")
                       for path in (ROOT / folder).rglob("*.hpp"))
        known = set(re.findall(r"\w+", re.sub(r"//.*", "", code)))
        rows = [cells(line) for line in (ROOT / "docs/glossary.md").read_text(encoding="utf-8").splitlines() if is_row(line)]
        named = [name for row in rows for name in re.findall(r"`([^`]+)`", row[2])]
        self.assertGreater(len(named), 60)
        for name in named:
            with self.subTest(name=name):
                self.assertLessEqual(set(re.findall(r"\w+", name)), known)

    def test_readmes_of_rooms_name_files_that_there_are(self):
        named = [(readme, name) for readme in ROOMS for name in files_in_tables(readme)]
        self.assertGreater(len(named), 100)
        for readme, name in named:
            folder = readme.parent
            with self.subTest(readme=readme, name=name):
                self.assertTrue((folder / name).exists() or (ROOT / name).exists() or list(folder.rglob(f"{name}.?pp")))

    def test_scripts_have_the_options_that_are_given(self):
        presets = {preset["name"] for preset in json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]}
        for path, place, line in each_text():
            for call in SCRIPT.findall(line.split("  #")[0]):
                script, *words = call.split()
                with self.subTest(place=place, call=call):
                    self.assertTrue(os.access(ROOT / script, os.X_OK) or script.endswith(".py"), "no such script")
                    for option in [word for word in words if word.startswith("--")]:
                        self.assertIn(option, sources_of(script))
                    if script == "scripts/build" and line.startswith("    "):
                        made = set(re.findall(r'"name": "([\w-]+)"', path.read_text(encoding="utf-8")))
                        self.assertLessEqual({word for word in words if word != "&&"}, presets | made)

    def test_cmake_is_given_what_it_knows(self):
        presets = re.findall(r'"name": "([\w-]+)"', (ROOT / "CMakePresets.json").read_text())
        files = [path for folder in FOLDERS.split("|") for name in ("CMakeLists.txt", "*.cmake")
                 for path in (ROOT / folder).rglob(name)]
        known = {name for path in (ROOT / "CMakeLists.txt", *files)
                 for name in re.findall(r"\bKFAST_\w+", path.read_text(encoding="utf-8"))}
        for path, place, line in each_text():
            with self.subTest(place=place):
                for preset in re.findall(r"cmake (?:--build )?--preset ([\w-]+)", line):
                    self.assertIn(preset, presets)
                for variable in re.findall(r"-D(KFAST_\w+)", line):
                    self.assertIn(variable, known)

    def test_packages_are_those_that_the_build_needs(self):
        sysroot = (ROOT / "scripts/make_sysroot.py").read_text(encoding="utf-8")
        libraries = {name for name in re.findall(r'"([^"]+)"', re.search(r"LIBRARIES = \(([^)]*)", sysroot).group(1))}
        page = (ROOT / "docs/raspberry-pi.md").read_text(encoding="utf-8").replace("\\\n", " ")
        to_build, to_run = (set(found.split()) for found in re.findall(r"sudo apt install ([^.].*)", page))
        self.assertEqual(to_build - {"g++", "cmake", "ninja-build", "pkg-config", "hershey-fonts-data", "fonts-dejavu-core"},
                         libraries - {"libstdc++6"})
        headers_alone = {"libcli11-dev", "nlohmann-json3-dev"}
        self.assertEqual(len(to_run), len(libraries - {"libstdc++6"} - headers_alone))

    def test_reasons_name_tests_that_there_are(self):
        for reason in (*(row.why for row in not_run.KFAST), *(why for _, why in not_run.OTHERS)):
            for name in PATH.findall(reason):
                self.assertTrue((ROOT / name).exists(), name)


if __name__ == "__main__":
    unittest.main()
