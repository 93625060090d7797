"""Live drawings of a scene, through the real command."""

import json
import unittest

from command_case import CommandTest

SCENE = """kfast 1
canvas 64 64 fps=30 frames=3 loop=once
input level
input plot kind=drawing points=30 strokes=2 { line 4 32 60 32 }
object trace stroke=lime width=2 join=round live=plot { track y input=level { at 0 0; at 1 9 } }
object area fill="#ff000080" live=plot
"""

STILL = """kfast 1
canvas 64 64 fps=30 frames=3 loop=once
object trace stroke=lime width=2 join=round {{ {shapes} }}
object area fill="#ff000080" {{ {shapes} }}
"""


class DrawingTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plot.kfast").write_text(SCENE)

    def hashes(self, *arguments):
        return [line.split()[1] for line in self.run_kfast("hash", *arguments).stdout.splitlines()]

    def told(self, text):
        (self.folder / "told.txt").write_text(text)
        return ["--drawing", "plot=told.txt"]

    def expected(self, shapes):
        (self.folder / "still.kfast").write_text(STILL.format(shapes=shapes))
        return self.hashes("still.kfast")

    def test_names_may_have_the_sign_that_ends_them(self):
        (self.folder / "sign.kfast").write_text(SCENE.replace("plot", '"x=y"'))
        (self.folder / "a=b.txt").write_text("1,1 60,60")
        drawn = [self.run_kfast("hash", scene, "--drawing", f"{name}=a=b.txt").stdout
                 for scene, name in (("sign.kfast", "x=y"), ("plot.kfast", "plot"))]
        self.assertEqual(drawn[0], drawn[1])
        self.assertNotEqual(drawn[1], self.run_kfast("hash", "plot.kfast").stdout)

    def test_a_scene_shows_what_it_is_told(self):
        self.assertEqual(self.hashes("plot.kfast"), self.expected("line 4 32 60 32"))
        for text, shapes in (("4,10 30,50.5 60,12", "line 4 10 30 50.5 60 12"),
                             ("\n10,10 50,10\n30,50 10,10\n/\t20,60 60,60 \n", "polygon 10 10 50 10 30 50; line 20 60 60 60"),
                             ("/ 4,10/9,-20 9,30", "path \"M 4 10 Z\"; line 9 -20 9 30")):
            with self.subTest(text=text):
                self.assertEqual(self.hashes("plot.kfast", *self.told(text)), self.expected(shapes))
        self.assertEqual(len(set(self.hashes("plot.kfast", *self.told(" / \n")))), 1)

    def test_a_panel_on_a_simulated_board_shows_the_same(self):
        told = self.told("4,10 30,50 60,12")
        self.assertEqual(self.hashes("plot.kfast", *told, "--panel", "ssd0323"),
                         self.hashes("plot.kfast", *told, "--size", "128x64", "--format", "grey4"))

    def test_all_that_draws_takes_drawings(self):
        told = self.told("4,10 30,50 60,12")
        self.run_kfast("render", "plot.kfast", "--frame", "1", "-o", "a.png")
        self.run_kfast("render", "plot.kfast", "--frame", "1", *told, "-o", "b.png")
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        lines = self.run_kfast("preview", "plot.kfast", "--headless", "--press", "h + i", *told).stdout.splitlines()
        self.assertIn("level", lines[1])
        self.assertNotEqual(lines, self.run_kfast("preview", "plot.kfast", "--headless", "--press", "h + i").stdout.splitlines())

    def test_info_tells_drawings(self):
        facts = json.loads(self.run_kfast("info", "plot.kfast", "--json", "--tracks").stdout)
        self.assertEqual(facts["inputs"][1], {"name": "plot", "kind": "drawing", "strokes": 2, "points": 30})
        self.assertEqual(facts["objects"], 2)
        self.assertEqual([item["item"] for item in facts["tracks"]["items"]], ["object 1", "object 2"])
        self.assertIn("  input       plot: a drawing, at most 30 points in 2 strokes\n", self.run_kfast("info", "plot.kfast").stdout)

    def test_wrong_drawings(self):
        def refusal(*arguments):
            return self.run_kfast("hash", "plot.kfast", *arguments, status=2).stderr

        (self.folder / "fine.txt").write_text("1,2")
        for argument, message in (("plat=fine.txt", "there is no drawing 'plat' among the inputs: did you mean \"plot\"?"),
                                  ("level=fine.txt", "there is no drawing 'level' among the inputs"),
                                  ("plot", "'plot' has no file: write it like plot=points.txt")):
            self.assertIn(message, refusal("--drawing", argument))
        self.assertIn("'plot' is a drawing: write --drawing plot=FILE", refusal("--input", "plot=1"))
        for text in ("1", "1,", "1,x", "1,2,3", "1;2", "2048,0", "0,-2047.1", "nan,0", "1,2 x"):
            with self.subTest(text=text):
                self.assertIn("is no point: write it like 10,20.5", refusal(*self.told(text)))
        self.assertIn("takes at most 30 points in 2 strokes", refusal(*self.told("1,1 " * 31)))
        self.assertIn("takes at most 30 points in 2 strokes", refusal(*self.told("1,1 / 2,2 / 3,3")))
        result = self.run_kfast("hash", "plot.kfast", "--drawing", "plot=none.txt", status=1)
        self.assertIn("none.txt", result.stderr)
        result = self.run_kfast("hash", "repeat.kfast", "--drawing", "plot=fine.txt", status=2)
        self.assertIn("the scene has none: leave out --drawing", result.stderr)

    def test_more_than_the_format_holds_is_an_error_at_the_object(self):
        many = "\n".join(f"object o{i} stroke=lime join=round width=9 live=plot" for i in range(9))
        (self.folder / "many.kfast").write_text(
            f"kfast 1\ncanvas 64 64\ninput plot kind=drawing points=4096\n{many}\n")
        result = self.run_kfast("check", "many.kfast", status=1)
        self.assertIn("many.kfast:4:1: error: what is told from outside may need ", result.stderr)
        self.assertIn("let the input have fewer points, or use join=bevel", result.stderr)


if __name__ == "__main__":
    unittest.main()
