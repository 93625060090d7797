"""SVGs that kfast render makes, drawn by librsvg: render_svg_test.py <kfast> <rsvg-convert>."""

import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

RSVG = sys.argv.pop()

from command_case import ROOT
from render_case import RenderTest

sys.path.insert(0, str(ROOT / "tests" / "import"))
import compare_pictures

SVG = "{http://www.w3.org/2000/svg}"

# Curves, groups, opacity of several layers and of one, even-odd, caps, joins, dots and turns in space.
VARIED = """kfast 1
canvas 120 90 fps=30 background="#102030"
object both fill="#f0d040" stroke="#4060ff" width=6 join=round opacity=0.5 {
    key 0 { circle 30 30 r=20 }
    key 10 { rect 20 20 30 30 }
}
object single fill="#ff404080" {
    key 0 { rect 50 10 30 20 }
}
object hollow fill="#40ff40" rule=even-odd {
    key 0 { rect 60 40 30 30; rect 70 50 10 10 }
}
object open stroke="#ffffff" width=5 cap=square join=miter miter=2 {
    key 0 { path "M 10 60 L 20 80 L 30 60 L 34 80" }
}
object dot stroke="#ff80ff" width=9 cap=round {
    key 0 { path "M 100 20 L 100 20" }
}
group turned rotate-y=40 rotate-x=20 pivot-x=100 pivot-y=65 {
    object face fill="#80c0ff" stroke="#c00000" width=2 { key 0 { circle 100 65 r=15 } }
}
"""


class VectorTest(RenderTest):
    def setUp(self):
        super().setUp()
        (self.folder / "varied.kfast").write_text(VARIED)

    def compare(self, vector, picture, width):
        subprocess.run([RSVG, "--width", str(width), self.folder / vector, "-o", self.folder / "seen.png"], check=True)
        difference = compare_pictures.compare(self.folder / "seen.png", self.folder / picture)
        self.assertEqual(difference.problems(near=0.995, worst=12, mean=1), [], f"{vector}: {difference}")

    def test_looks_like_the_picture(self):
        examples = ROOT / "examples"
        scenes = [(self.folder / "varied.kfast", []), (examples / "stroller.kfast", []), (examples / "worm.kfast", []), (examples / "one-to-two.kfast", []),
                  (examples / "card.kfast", []), (examples / "jitterbug.kfast", []), (examples / "plot.kfast", []), (examples / "clock-face.kfast", ["--input", "clock=08:45"]),
                  (examples / "dial.kfast", ["--input", "speed=70", "--input", "mood=0.5"]), (examples / "logo.kfast", ["--size", "100x150"]),
                  (examples / "robot-eyes.kfast", ["--size", "90x150", "--scaling", "cover"])]
        for scene, options in scenes:
            for frame in (0, 9):
                self.render(scene, *options, "--frame", frame, "-o", "out.svg")
                self.render(scene, *options, "--frame", frame, "-o", "out.png")
                self.compare("out.svg", "out.png", self.opened("out.png").width)

    def test_a_fill_that_breaks_in_two(self):
        (self.folder / "broken.kfast").write_text("""kfast 1
canvas 120 90 fps=30
object parting fill="#ffffff" {
    key 0 { rect 10 10 100 70 }
    key 10 { circle 30 45 r=20; circle 90 45 r=20; rect 50 5 20 10 }
}
""")
        for frame in (2, 5):
            self.render("broken.kfast", "--frame", frame, "-o", "out.svg")
            self.render("broken.kfast", "--frame", frame, "-o", "out.png")
            self.compare("out.svg", "out.png", 120)

    def test_paths_tell_what_they_are(self):
        self.render("varied.kfast", "--frame", "0", "-o", "out.svg")
        picture = ElementTree.parse(self.folder / "out.svg").getroot()
        self.assertEqual([element.tag.removeprefix(SVG) for element in picture], ["rect", "g", *["path"] * 5])
        self.assertEqual(picture[1].attrib, {"opacity": "0.502"})
        both = picture[1][0].attrib
        self.assertEqual((both["fill"], both["stroke"], both["stroke-width"], both["stroke-linejoin"]),
                         ("#f0d040", "#4060ff", "6", "round"))
        self.assertEqual(both["d"].count("C"), 4)
        self.assertEqual(picture[2].attrib, {"fill": "#ff4040", "fill-opacity": "0.502", "d": "M50 10L80 10L80 30L50 30L50 10Z"})
        self.assertEqual(picture[3].attrib["fill-rule"], "evenodd")
        self.assertEqual((picture[4].attrib["stroke-linecap"], picture[4].attrib["stroke-miterlimit"], picture[4].attrib["fill"]),
                         ("square", "2", "none"))
        self.assertNotIn("C", picture[6].attrib["d"], "curves in space become lines")

    def test_fractions_are_exact_to_a_sixteenth(self):
        (self.folder / "fine.kfast").write_text('kfast 1\ncanvas 9 9\nobject a fill="#ffffff" { key 0 { rect 1.0625 -2.9375 3 4 } }\n')
        self.render("fine.kfast", "--frame", "0", "-o", "out.svg")
        self.assertIn('d="M1.0625 -2.9375L4.0625 -2.9375L4.0625 1.0625L1.0625 1.0625L1.0625 -2.9375Z"',
                      (self.folder / "out.svg").read_text())

    def test_a_folder_of_vectors(self):
        self.render("once.kfast", "--all", "--kind", "svg", "-o", "frames")
        self.assertEqual(sorted(path.name for path in (self.folder / "frames").iterdir()), [f"{i:04}.svg" for i in range(11)])
        self.render("once.kfast", "--frame", "4", "-o", "4.svg")
        self.assertEqual((self.folder / "frames/0004.svg").read_bytes(), (self.folder / "4.svg").read_bytes())

    def test_an_animated_vector_takes_turns(self):
        for loop, ending in (("once", {"fill": "freeze"}), ("repeat", {"repeatCount": "indefinite"})):
            self.render(f"resting-{loop}.kfast", "--all", "-o", "out.svg")
            picture = ElementTree.parse(self.folder / "out.svg").getroot()
            frames = picture.findall(f"{SVG}g")
            turns = [frame.find(f"{SVG}animate").attrib for frame in frames]
            self.assertEqual([frame.get("display") for frame in frames], [None] + ["none"] * (len(frames) - 1))
            count = 7 if loop == "once" else 6
            self.assertEqual(len(frames), 5 if loop == "once" else 4)
            for turn in turns:
                self.assertEqual({key: turn.get(key) for key in ending}, ending)
                self.assertAlmostEqual(float(turn["dur"].removesuffix("s")), count / 29.97, places=6)
            times = [[round(float(time) * count, 5) for time in turn["keyTimes"].split(";")] for turn in turns]
            ends = [[0, 3, 6], [0, 6]] if loop == "once" else [[0, 3]]
            self.assertEqual(times, [[0, 1], [0, 1, 2], [0, 2, 3], *ends])
            self.assertEqual(turns[1]["values"], "none;inline;none")
        self.render("resting-once.kfast", "--frame", "0", "-o", "out.png")
        self.compare("out.svg", "out.png", 21)

    def test_what_cannot_be_a_vector(self):
        svg = ["render", "once.kfast", "--frame", "1", "-o", "a.svg"]
        self.refuse(*svg, "--beam", "scope", status=2, says="no outlines")
        self.refuse(*svg, "--format", "mono1", status=2, says="no pixels")
        self.refuse(*svg, "--scale", "2", status=2, says="choose --size")
        self.refuse("render", "once.kfast", "--all", "--kind", "svg", "--scale", "2", "-o", "f", status=2, says="choose --size")


if __name__ == "__main__":
    unittest.main()
