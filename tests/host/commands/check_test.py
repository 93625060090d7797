"""`kfast check`: several files, standard input, and diagnostics for editors."""

import json
import shutil
import subprocess
import unittest

from command_case import KFAST, ROOT, CommandTest

WRONG = 'kfast 1\ncanvas 60 40\n// 🎈 ü\nobject dot fill=whit { text "🎈ü" at="1,1" size=9 }\n'


class CheckTest(CommandTest):
    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def json(self, *arguments, status=0, text=None):
        result = subprocess.run([KFAST, "check", "--json", *arguments], cwd=self.folder, input=text,
                                capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, status, result.stderr)
        return json.loads(result.stdout)["files"]

    def test_a_good_scene(self):
        (file,) = self.json("repeat.kfast")
        self.assertEqual((file["file"], file["good"], file["diagnostics"]), ("repeat.kfast", True, []))
        self.assertIn("1 object", file["summary"])

    def test_frames_are_those_of_the_text_everywhere(self):
        for loop, more in (("once", ", and then its end: 10 pictures"), ("repeat", "")):
            self.write("nine.kfast", f"kfast 1\ncanvas 64 64 fps=10 frames=9 loop={loop}\nobject a fill=red {{ rect 0 0 9 9; key 0 x=0; key 9 x=20 }}\n")
            self.assertIn(", 9 frames, ", self.run_kfast("check", "nine.kfast").stdout)
            self.assertIn(", 9 frames, ", self.run_kfast("compile", "nine.kfast").stdout)
            self.assertIn(f"  length      9 frames, 0.9 s{more}\n", self.run_kfast("info", "nine.kfast").stdout)
            facts = json.loads(self.run_kfast("info", "nine.kfast", "--json").stdout)
            self.assertEqual((facts["frames"], facts["pictures"]), (9, 10 if more else 9))
            self.run_kfast("render", "nine.kfast", "--all", "-o", f"{loop}")
            self.assertEqual(len(list((self.folder / loop).iterdir())), facts["pictures"])
        self.write("half.kfast", "kfast 1\ncanvas 64 64 frames=2.5\nobject a fill=red { rect 0 0 9 9 }\n")
        self.assertIn(", 2.5 frames, ", self.run_kfast("check", "half.kfast").stdout)

    def test_places_are_told_in_all_units(self):
        (file,) = self.json(self.write("wrong.kfast", WRONG), status=1)
        colour, letter = file["diagnostics"]
        self.assertFalse(file["good"])
        self.assertEqual(colour["severity"], "error")
        self.assertEqual(colour["message"], 'unknown colour "whit"')
        self.assertEqual(colour["remedy"], 'did you mean "white"?')
        self.assertEqual(colour["begin"], {"line": 4, "column": 17})
        self.assertEqual(colour["end"], {"line": 4, "column": 21})
        self.assertEqual(colour["range"], {"start": {"line": 3, "character": 16}, "end": {"line": 3, "character": 20}})
        content = WRONG.encode()
        for each in (colour, letter):
            begin = each["bytes"]["offset"]
            part = content[begin:begin + each["bytes"]["length"]].decode()
            line = WRONG.splitlines()[each["range"]["start"]["line"]].encode("utf-16-le")
            ends = each["range"]["start"]["character"], each["range"]["end"]["character"]
            self.assertEqual(line[2 * ends[0]:2 * ends[1]].decode("utf-16-le"), part)
        self.assertEqual(letter["end"]["column"] - letter["begin"]["column"], 1)
        self.assertEqual(letter["range"]["end"]["character"] - letter["range"]["start"]["character"], 2)

    def test_says_what_the_text_says(self):
        self.write("wrong.kfast", WRONG)
        text = self.run_kfast("check", "wrong.kfast", status=1).stderr
        (file,) = self.json("wrong.kfast", status=1)
        for each in file["diagnostics"]:
            self.assertIn(f"wrong.kfast:{each['begin']['line']}:{each['begin']['column']}: {each['severity']}: "
                          f"{each['message']}\n", text)
            self.assertIn(f"= help: {each['remedy']}\n", text)

    def test_a_text_that_is_not_saved(self):
        (file,) = self.json("-", "--stdin-filename", "eyes.kfast", status=1, text=WRONG)
        self.assertEqual((file["file"], len(file["diagnostics"])), ("eyes.kfast", 2))
        font = next((ROOT / "tests").rglob("*.ttf"), None)
        scene = 'kfast 1\ncanvas 60 40\nobject a fill=white { text "A" at="1,9" size=9 font="f.ttf" }\n'
        if font:
            (self.folder / "sub").mkdir()
            shutil.copy(font, self.folder / "sub/f.ttf")
            self.assertTrue(self.json("-", "--stdin-filename", "sub/new.kfast", text=scene)[0]["good"], "fonts lie beside the name")
        self.assertIn("f.ttf", self.json("-", status=1, text=scene)[0]["diagnostics"][0]["message"])
        result = subprocess.run([KFAST, "check", "-"], input=WRONG, capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, 1)
        self.assertIn("<stdin>:4:17: error: ", result.stderr)

    def test_what_nobody_sees(self):
        text = """kfast 1
canvas 60 40
object seen fill=white { rect 0 0 9 9 }
object outside fill=white { rect 60 0 9 9 }
"""
        (file,) = self.json(self.write("half.kfast", text))
        (warning,) = file["diagnostics"]
        self.assertTrue(file["good"])
        self.assertEqual((warning["severity"], warning["begin"]["line"]), ("warning", 4))
        self.assertIn("outside of the canvas", warning["remedy"])
        result = self.run_kfast("check", "half.kfast")
        self.assertIn("half.kfast:4:1: warning: on a panel, no frame shows anything of this\n", result.stderr)
        self.assertTrue(result.stdout.endswith(", 1 warning\n"), result.stdout)

    def test_of_many_warnings_a_hundred_are_shown(self):
        text = "kfast 1\ncanvas 60 40\n" + "".join(
            f"object o{number} fill=red opacity=0 {{ rect 1 1 9 9 }}\n" for number in range(3_000))
        self.write("hidden.kfast", text)
        result = self.run_kfast("check", "hidden.kfast")
        self.assertEqual(result.stderr.count(": warning: "), 100)
        self.assertIn("hidden.kfast:102:1: warning: ", result.stderr)
        self.assertTrue(result.stderr.endswith("\nhidden.kfast: ... and 2900 warnings more\n"), result.stderr[-200:])
        self.assertTrue(result.stdout.endswith(", 3000 warnings\n"), result.stdout)
        (file,) = self.json("hidden.kfast")
        self.assertEqual(len(file["diagnostics"]), 3_000)
        self.assertEqual(file["diagnostics"][-1]["begin"], {"line": 3_002, "column": 1})

    def test_errors_rather_than_warnings(self):
        scene = "kfast 1\ncanvas 60 40\n" + "object a fill=red { path \"\" }\n" * 150 + "what\n"
        self.write("wrong.kfast", scene)
        self.assertIn("wrong.kfast:153:1: error: ", self.run_kfast("check", "wrong.kfast", status=1).stderr)

    def test_several_files(self):
        self.write("wrong.kfast", WRONG)
        files = self.json("repeat.kfast", "wrong.kfast", "none.kfast", status=1)
        self.assertEqual([file["good"] for file in files], [True, False, False])
        self.assertIn("none.kfast", files[2]["failure"])
        result = self.run_kfast("check", "once.kfast", "wrong.kfast", "none.kfast", "repeat.kfast", status=1)
        self.assertIn("once.kfast: ok", result.stdout)
        self.assertIn("repeat.kfast: ok", result.stdout)
        self.assertIn("kfast: 2 of 4 files are wrong\n", result.stderr)

    def test_losses_of_other_programs(self):
        svg = self.write("a.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><rect width="5" height="5"'
                                  ' filter="url(#f)"/><image width="4" height="4" href="a.png"/></svg>')
        (file,) = self.json(svg)
        self.assertTrue(file["good"])
        self.assertTrue(any("image" in loss["feature"] for loss in file["losses"]), file["losses"])
        (strict,) = self.json(svg, "--strict", status=1)
        self.assertEqual(strict["losses"], file["losses"])
        self.assertIn("not carried over", strict["failure"])

    def test_wrong_usage(self):
        self.refuse("check", "repeat.kfast", "--format", "jsn", status=2, says="no option --format")
        self.refuse("check", "-", "-", status=2, says="once")
        self.refuse("check", "repeat.kfast", "--stdin-filename", "a", status=2, says="--stdin-filename")
        self.refuse("check", status=2, says="SCENE")


if __name__ == "__main__":
    unittest.main()
