"""Inputs of a scene, through the real command."""

import json
import unittest

from command_case import CommandTest

LABEL = """kfast 1
canvas 64 32 frames=3
input t kind=text glyphs="0-9:=A-Z-" max=5 default="12:30"
input n
object o stroke=white { text input=t at="2,24" size=16 font=hershey-sans; track x input=n { at 0 0; at 1 9 } }
"""

SCENE = """kfast 1
canvas 64 64 fps=30 frames=3 loop=once
input gaze min=-1 max=1
input open max=100 default=50
object ball fill=white { rect 30 0 4 4; track x law=constant input=gaze { at -1 -30; at 1 30 } }
object door fill=red input=open { key 0 { rect 0 20 8 8 }; key 100 { rect 50 20 8 8 } }
bones arm { bone a 10 50 30 50; pose -1 input=gaze { a turn=-22.5 }; pose 1 input=gaze { a turn=22.5 } }
object sleeve fill=lime skin=arm { rect 10 48 20 4 }
"""

# The same by hand, where the inputs stand.
STILL = """kfast 1
canvas 64 64 fps=30 frames=3 loop=once
object ball fill=white x={x} {{ rect 30 0 4 4 }}
object door fill=red {{ rect {door} 20 8 8 }}
bones arm {{ bone a 10 50 30 50; pose 0 {{ a turn={turn} }} }}
object sleeve fill=lime skin=arm {{ rect 10 48 20 4 }}
"""


class InputTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "knobs.kfast").write_text(SCENE)

    def hashes(self, *arguments):
        return [line.split()[1] for line in self.run_kfast("hash", *arguments).stdout.splitlines()]

    def put(self, gaze, opened):
        return ["--input", f"gaze={gaze}", "--input", f"open={opened}"]

    def expected(self, x, door, turn):
        (self.folder / "still.kfast").write_text(STILL.format(x=x, door=door, turn=turn))
        return self.hashes("still.kfast")

    def test_a_scene_looks_as_its_inputs_say(self):
        for gaze, opened, *still in ((-1, 0, -30, 0, -22.5), (1, 100, 30, 50, 22.5), (0.5, 50, 15, 25, 11.25)):
            self.assertEqual(self.hashes("knobs.kfast", *self.put(gaze, opened)), self.expected(*still))
        self.assertEqual(self.hashes("knobs.kfast", *self.put("+0.5", 50)), self.expected(15, 25, 11.25))
        self.assertEqual(self.hashes("knobs.kfast"), self.expected(0, 25, 0))

    def test_a_panel_on_a_simulated_board_shows_the_same(self):
        inputs = self.put(0.3, 71)
        self.assertEqual(self.hashes("knobs.kfast", *inputs, "--panel", "ssd0323"),
                         self.hashes("knobs.kfast", *inputs, "--size", "128x64", "--format", "grey4"))

    def test_all_that_draws_takes_inputs(self):
        for name, value in (("a.png", 0), ("b.png", 0), ("c.png", 1)):
            self.run_kfast("render", "knobs.kfast", "--frame", "1", "--input", f"gaze={value}", "-o", name)
        picture = {name: (self.folder / name).read_bytes() for name in ("a.png", "b.png", "c.png")}
        self.assertEqual(picture["a.png"], picture["b.png"])
        self.assertNotEqual(picture["a.png"], picture["c.png"])

    def test_keys_of_the_preview_turn_inputs(self):
        def lines(keys, *arguments):
            return self.run_kfast("preview", "knobs.kfast", "--headless", "--press", keys, *arguments).stdout.splitlines()

        told = [line.split("  ")[3] for line in lines("+ + - i + -", "--input", "gaze=0.9")[:-1]]
        self.assertEqual(told, ["gaze 1", "gaze 1", "gaze 0.9", "open 50", "open 55", "open 50"])
        turned = lines("+ + +")[-2].split()[-1]
        self.assertEqual(lines("h h i", "--input", "gaze=0.3")[-2].split()[-1], turned)

    def test_info_tells_inputs_and_what_goes_by_them(self):
        facts = json.loads(self.run_kfast("info", "knobs.kfast", "--json", "--tracks").stdout)
        self.assertEqual(facts["inputs"], [
            {"name": "gaze", "kind": "number", "min": -1, "max": 1, "default": 0, "keys": [-1, 1]},
            {"name": "open", "kind": "number", "min": 0, "max": 100, "default": 50, "keys": [0, 100]}])
        self.assertEqual(facts["keys"], [0])
        text = self.run_kfast("info", "knobs.kfast", "--tracks").stdout
        for line in ("  input       open: 0 to 100, usually 50; keys 2, at 0 100\n", "by gaze, constant: -1 -30, 1 30\n"):
            self.assertIn(line, text)

    def test_wrong_inputs(self):
        for argument, message in (("gase=1", "there is no input 'gase': did you mean \"gaze\"?"),
                                  ("gaze=1.1", "'1.1' is no value of gaze: it goes from -1 to 1"),
                                  ("gaze=nan", "'nan' is no value of gaze"), ("gaze=", "'' is no value of gaze"),
                                  ("gaze=1x", "'1x' is no value of gaze"),
                                  ("gaze", "'gaze' has no value: write it like gaze=0.5")):
            result = self.run_kfast("hash", "knobs.kfast", "--input", argument, status=2)
            self.assertIn(message, result.stderr)
        result = self.run_kfast("hash", "repeat.kfast", "--input", "gaze=1", status=2)
        self.assertIn("the scene has none: leave out --input", result.stderr)

    def write_labels(self):
        (self.folder / "label.kfast").write_text(LABEL)

    def test_a_text_is_told_on_the_command_line(self):
        self.write_labels()
        (self.folder / "written.kfast").write_text(
            'kfast 1\ncanvas 64 32 frames=3\nobject o stroke=white { text "A=B-7" at="2,24" size=16 font=hershey-sans }\n')
        self.assertEqual(self.hashes("label.kfast", "--input", "t=A=B-7"), self.hashes("written.kfast"))
        self.assertNotEqual(self.hashes("label.kfast"), self.hashes("written.kfast"))
        self.assertEqual(self.hashes("label.kfast"), self.hashes("label.kfast", "--input", "t=12:30"))
        self.assertEqual(self.hashes("label.kfast", "--input", "t="), self.hashes("label.kfast", "--input", "t=  "))
        inputs = ["--input", "t=99:59", "--input", "n=0.5"]
        self.assertEqual(self.hashes("label.kfast", *inputs, "--panel", "ssd0323"),
                         self.hashes("label.kfast", *inputs, "--size", "128x64", "--format", "grey4"))
        told = self.run_kfast("preview", "label.kfast", "--headless", "--press", "i +", "--input", "t=7").stdout
        self.assertIn("  n 0.05  ", told)

    def test_info_tells_texts(self):
        self.write_labels()
        facts = json.loads(self.run_kfast("info", "label.kfast", "--json").stdout)
        self.assertEqual(facts["inputs"][0],
                         {"name": "t", "kind": "text", "glyphs": "0-9:=A-Z-", "max": 5, "default": "12:30"})
        self.assertEqual(facts["objects"], 1)
        self.assertIn('  input       t: a text of up to 5 characters of "0-9:=A-Z-" and spaces, usually "12:30"\n',
                      self.run_kfast("info", "label.kfast").stdout)

    def test_wrong_texts(self):
        self.write_labels()
        for argument, message in (("t=1.2", 't has no ".": its characters are "0-9:=A-Z-" and the space'),
                                  ("t=123456", "'123456' has 6 characters: t has 5 at most"),
                                  ("t", "'t' has no value")):
            result = self.run_kfast("hash", "label.kfast", "--input", argument, status=2)
            self.assertIn(message, result.stderr)


if __name__ == "__main__":
    unittest.main()
