"""Every block of KDL in the documents is good: a whole scene compiles without a warning, a part of one within a scene.

Called like scenes_test.py <kfast>. A whole scene begins with `kfast 1` and has a canvas. Anything else is a part: the test puts
around it what it needs, and what it names is looked for in the parts above it on its page.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from page import ROOT, blocks, pages, shown_status

KFAST = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
OUTERMOST = {"kfast", "canvas", "palette", "object", "group", "use", "symbol", "clip", "event", "input", "bones", "let"}
SETTINGS = {"board", "panel", "bus", "pins", "knob", "button", "beam", "core", "memory", "bands", "reserved"}
LANGUAGES = {"", "indented", "kdl", "sh", "text", "json", "c", "cpp", "cmake"}
PALETTE = 'palette { ink "#f2f2f2"; glow "#4cc9f0"; arm "#c98a5e"; hand "#e0ac7d" }\n'
WHOLE = "kfast 1"
BEAM_SETTINGS = """board pico {{
    beam galvo
    bus dac
    pins clock=18 data=19 select=17 ldac=16 blank=20
    {}
}}
"""


def nodes(text):
    """Names of the outermost nodes, each with its text."""
    depth, begin = 0, None
    bare = re.sub(r'"(?:\\.|[^"\\])*"|//[^\n]*', lambda found: " " * len(found.group()), text)
    for at, sign in enumerate(bare):
        if begin is None and not sign.isspace() and sign != ";":
            begin = at
        depth += {"{": 1, "}": -1}.get(sign, 0)
        if begin is not None and depth == 0 and sign in "\n;" and not bare[:at].endswith("\\"):
            yield re.match(r"[\w-]+", bare[begin:]).group(), text[begin:at]
            begin = None


def looks_like_kdl(text, names):
    lines = [line.strip() for line in text.splitlines() if line.strip() and not line.strip().startswith("//")]
    return bool(lines) and re.split(r"[\s;{]", lines[0])[0] in names


def is_checked_by_a_command(block, page):
    """Mistakes, for a command that is to find them."""
    return block.file_name and any(block.file_name in command and shown_status(command) for other in page if other.is_commands
                                   for _, command in other.commands())


def is_whole(text):
    return {"kfast", "canvas"} <= {name for name, _ in nodes(text)}


def names_of(kind, text):
    return re.findall(rf"(?m)^{kind} ([\w-]+)", text)


def wrapped(text, above):
    """The part of a scene as a scene, with what earlier parts of the page call by the names that it uses."""
    found = list(nodes(text))
    if not all(name in OUTERMOST for name, _ in found):
        return f"{WHOLE}\ncanvas 240 240\nobject shapes fill=white {{\n{text}}}\n"
    scene = WHOLE + "\n"
    kinds = [name for name, _ in found]
    if "canvas" not in kinds:
        scene += "canvas 240 240 frames=1000\n"
    if "palette" not in kinds and "kfast" not in kinds:
        scene += PALETTE
    needed = [("bones", name) for name in re.findall(r"skin=([\w-]+)", text)]
    scene += "".join(node + "\n" for kind, name in dict.fromkeys(needed) if name not in names_of(kind, text)
                     for part in above for node_kind, node in nodes(part)
                     if node_kind == kind and node.startswith(f"{kind} {name} "))
    scene += "".join(node + "\n" for name, node in found if name != "kfast")
    return scene if {"object", "group", "use"} & set(kinds) else scene + "object dot fill=white { circle 9 9 r=4 }\n"


def kind_of(text):
    if is_whole(text):
        return "scene"
    first = next(nodes(text))[0]
    if first in ("button", "knob"):
        return "control"
    if first == "board":
        return "board" if re.search(r"(?m)^ +core ", text) else "settings"
    return "beam" if first == "beam" else "part"


class DocumentedScenes(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "fonts").mkdir()
        (self.folder / "fonts/Sans.ttf").symlink_to("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")

    def told(self, text, *command):
        (self.folder / "text.kfast").write_text(text, encoding="utf-8")
        result = subprocess.run([KFAST, *command], cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return result.returncode, result.stdout

    def look_at(self, text, above):
        kind = kind_of(text)
        if kind == "control":
            kind, text = "settings", BEAM_SETTINGS.format(text)
        if kind == "settings":
            status, told = self.told(text, "config", "text.kfast", "-o", "out.kdl")
        elif kind == "board":
            status, told = self.told(text, "fit", ROOT / "examples/spinner.kfast", "--board", "text.kfast")
        elif kind == "beam":
            status, told = self.told(text, "hash", ROOT / "examples/spinner.kfast", "--beam", "text.kfast")
        else:
            status, told = self.told(text if kind == "scene" else wrapped(text, above), "check", "text.kfast")
        self.assertEqual(status, 0, told)
        if kind == "scene":
            self.assertIn(", 0 warnings\n", told)

    def test_every_block_is_good(self):
        looked_at = 0
        for path in pages():
            above = []
            for block in blocks(path.read_text(encoding="utf-8")):
                if block.language == "kdl":
                    with self.subTest(place=f"{path.relative_to(ROOT)}:{block.line}"):
                        self.look_at(block.text, above)
                    above.append(block.text)
                    looked_at += 1
        self.assertGreater(looked_at, 30)

    def test_no_block_hides_from_that(self):
        nodes_of_scenes = json.loads(subprocess.run([KFAST, "schema", "--json"], capture_output=True, check=True).stdout)["nodes"]
        names = {node["name"] for node in nodes_of_scenes if not node.get("any_name")} | SETTINGS
        self.assertLessEqual(OUTERMOST, names)
        for path in pages():
            page = list(blocks(path.read_text(encoding="utf-8")))
            for block in page:
                with self.subTest(place=f"{path.relative_to(ROOT)}:{block.line}"):
                    self.assertIn(block.language, LANGUAGES)
                    if block.language != "kdl" and not block.is_commands and looks_like_kdl(block.text, names):
                        self.assertTrue(is_checked_by_a_command(block, page), "to be fenced as kdl")

    def test_mistakes_are_noticed(self):
        for text in ("kfast 1\ncanvas 9 9\nobject dot fill=white wide=2 { circle 4 4 r=3 }\n",  # an unknown property
                     "kfast 1\ncanvas 9 9\nobject dot fill=white width=2 { circle 4 4 r=3 }\n",  # a warning
                     "object dot fill=white { circle 4 4 }\n", "circle 4 4\n", "board pico { panel st7798 }\n"):
            with self.subTest(text=text), self.assertRaises(AssertionError):
                self.look_at(text, [])


if __name__ == "__main__":
    unittest.main()
