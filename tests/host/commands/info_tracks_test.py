"""kfast info --tracks: all that moves the items and the bones of a scene."""

import json
import re
import unittest

from command_case import CommandTest

SCENE = """kfast 1
canvas 60 40 fps=30 frames=60
symbol wheel {
    object rim stroke=white { circle 0 0 r=9; track rotate { at 0 0; at 60 -720 } }
}
object dot fill="#f00" z=-20 {
    rect 1 1 14 14
    track y { at 40 4; at 0 0.5; at 15.5 20 }
    track opacity law=accelerate { at 0 0; at 9 1 }
    key 0 x=1 law=hold visible=#false
    key 10 x=2 law="steps(4)" fill="#00ff0080"
    key 20 x=3 visible=#true
}
group {
    object still fill=white beam=both hatch=2.5 hatch-angle=45 { rect 0 0 5 5 }
    use wheel { track along "M 0 0 L 30 40" turn=#true { at 0 0; at 60 1 } }
    track scale-y law="bezier(0.42,0,0.58,1)" { at 0 1; at 5 -2 }
}
"""

LINES = """\
  object 1 "dot"
    x          0 1 hold, 10 2 steps(4), 20 3
    y          smooth: 0 0.5, 15.5 20, 40 4
    z          -20
    opacity    accelerate: 0 0, 9 1
    visible    0 #false, 20 #true
    fill       hold: 0 #ff0000, 10 #00ff0080
  group 2
    scale-y    bezier(0.42,0,0.58,1): 0 1, 5 -2
    object 2.1 "still"
      beam       both: lines 2.5 px apart, at 45°
    use 2.2 "wheel" of symbol 1
      along      constant: 0 0, 60 1; the path is 50 px long, and the item turns with it
  symbol 1 "wheel"
    object 1 "rim"
      rotate     smooth: 0 0, 60 -720
"""

BONES = """kfast 1
canvas 60 40 fps=30 frames=60
bones robot {
    bone torso 30 36 30 16 {
        bone arm 30 16 42 16
        bone horn 30 20 35 20
    }
    bone foot 4 36 12 36
    pose 0 rest law=accelerate
    pose 20 { torso turn=90 x=2 y=-1.5; arm turn=-45 }
    pose 30 law-y=hold { arm length=18 y=2 }
    pose 60 rest
}
bones wheel turns=as-written { bone spoke 20 20 25 20; pose 0 rest; pose 5.5 { spoke turn=-720 } }
object sleeve fill=white skin=robot bone=arm { rect 28 14 16 4 }
object tyre stroke=white skin=wheel { circle 20 20 r=4; weights { spoke 1 } }
"""

BONE_LINES = """\
  object 1 "sleeve"
  object 2 "tyre"
  skeleton 1 "robot"
    bone 1 "torso"
      angle   0 270 accelerate, 20 0 constant, 60 270
      x       0 30 accelerate, 20 32 constant, 60 30
      y       0 36 accelerate, 20 34.5 constant, 60 36
      length  20
    bone 2 "foot"
      angle   0
      x       4
      y       36
      length  8
    bone 3 "arm" of bone 1 "torso"
      angle   0 90 accelerate, 20 45 constant, 30 90 constant, 60 90
      x       0 20 accelerate, 20 20 constant, 30 18 constant, 60 20
      y       0
      length  0 12 accelerate, 20 12 constant, 30 18 constant, 60 12
    bone 4 "horn" of bone 1 "torso"
      angle   90
      x       16
      y       0
      length  5
  skeleton 2 "wheel"
    bone 1 "spoke"
      angle   constant: 0 0, 5.5 -720
      x       20
      y       20
      length  5
"""


class TracksTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "moving.kfast").write_text(SCENE)

    def test_text(self):
        plain = self.run_kfast("info", "moving.kfast").stdout
        self.assertEqual(self.run_kfast("info", "moving.kfast", "--tracks").stdout, plain + LINES)

    def test_a_compiled_scene_says_the_same_without_names(self):
        text = self.run_kfast("info", "moving.kfast", "--tracks").stdout
        self.run_kfast("compile", "moving.kfast")
        compiled = self.run_kfast("info", "moving.kfb", "--tracks").stdout
        self.assertEqual(compiled.splitlines()[1:], re.sub(' "[a-z]+"', "", text).splitlines()[1:])

    def test_json(self):
        plain = json.loads(self.run_kfast("info", "moving.kfast", "--json").stdout)
        facts = json.loads(self.run_kfast("info", "moving.kfast", "--json", "--tracks").stdout)
        tracks = facts.pop("tracks")
        self.assertEqual(facts.pop("skeletons"), [])
        self.assertEqual(facts, plain)
        dot, group = tracks["items"]
        self.assertEqual((dot["item"], group["item"]), ("object 1", "group 2"))
        self.assertEqual((dot["name"], tracks["symbols"][0]["name"]), ("dot", "wheel"))
        self.assertNotIn("name", group)
        self.assertEqual(dot["tracks"][0], {"property": "x", "smooth": False, "keys": [
            {"at": 0, "value": 1, "law": "hold"}, {"at": 10, "value": 2, "law": "steps(4)"},
            {"at": 20, "value": 3}]})
        self.assertEqual(dot["tracks"][1], {"property": "y", "smooth": True, "keys": [
            {"at": 0, "value": 0.5}, {"at": 15.5, "value": 20}, {"at": 40, "value": 4}]})
        self.assertEqual(dot["tracks"][2], {"property": "z", "value": -20})
        self.assertEqual(dot["tracks"][4]["keys"], [{"at": 0, "value": False}, {"at": 20, "value": True}])
        still, use = group["items"]
        self.assertEqual(still, {
            "item": "object 2.1", "name": "still", "tracks": [], "beam": {"draws": "both", "hatch": 2.5, "hatch-angle": 45}})
        self.assertEqual((use["item"], use["symbol"]), ("use 2.2", 1))
        self.assertEqual(use["tracks"], [{"property": "along", "smooth": False, "keys": [
            {"at": 0, "value": 0, "law": "constant"}, {"at": 60, "value": 1}], "length": 50, "turn": True}])
        self.assertEqual(tracks["symbols"][0]["items"][0]["tracks"][0]["property"], "rotate")


class BoneTracksTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "moving.kfast").write_text(BONES)

    def test_text(self):
        plain = self.run_kfast("info", "moving.kfast").stdout
        self.assertEqual(self.run_kfast("info", "moving.kfast", "--tracks").stdout, plain + BONE_LINES)

    def test_json(self):
        plain = json.loads(self.run_kfast("info", "moving.kfast", "--json").stdout)
        facts = json.loads(self.run_kfast("info", "moving.kfast", "--json", "--tracks").stdout)
        robot, wheel = facts.pop("skeletons")
        facts.pop("tracks")
        self.assertEqual(facts, plain)
        self.assertEqual((robot["skeleton"], wheel["skeleton"]), (1, 2))
        torso, foot, arm, horn = robot["bones"]
        self.assertEqual([bone["bone"] for bone in robot["bones"]], [1, 2, 3, 4])
        self.assertEqual([bone["name"] for bone in robot["bones"]], ["torso", "foot", "arm", "horn"])
        self.assertEqual(robot["name"], "robot")
        self.assertEqual([bone.get("parent") for bone in robot["bones"]], [None, None, 1, 1])
        self.assertEqual(torso["tracks"][2], {"property": "y", "smooth": False, "keys": [
            {"at": 0, "value": 36, "law": "accelerate"}, {"at": 20, "value": 34.5, "law": "constant"},
            {"at": 60, "value": 36}]})
        self.assertEqual(horn["tracks"][1], {"property": "x", "value": 16})
        self.assertEqual([track["property"] for track in foot["tracks"]], ["angle", "x", "y", "length"])
        self.assertEqual(arm["tracks"][3]["keys"][2], {"at": 30, "value": 18, "law": "constant"})
        self.assertEqual(wheel["bones"][0]["tracks"][0]["keys"][1], {"at": 5.5, "value": -720})

    def test_a_long_list_is_cut(self):
        keys = "; ".join(f"at {number} {number % 7}" for number in range(8000))
        (self.folder / "long.kfast").write_text(
            "kfast 1\ncanvas 60 40 fps=30 frames=8000\ninput level min=0 max=8000\n"
            f"object a fill=red {{ rect 0 0 9 9; track x {{ {keys} }}; track y input=level {{ {keys} }} }}\n")
        text = self.run_kfast("info", "--tracks", "long.kfast").stdout
        self.assertLess(max(map(len, text.splitlines())), 2000)
        self.assertEqual(len(re.findall(r"(?m)^  keys        8000, at frames 0 1 2 .* 99 \.\.\. and 7900 more$", text)), 1)
        self.assertIn(", 98 0, 99 1 ... and 7900 more\n", text)
        self.assertEqual(text.count(" ... and 7900 more\n"), 4)
        facts = json.loads(self.run_kfast("info", "--tracks", "--json", "long.kfast").stdout)
        self.assertEqual((len(facts["keys"]), len(facts["tracks"]["items"][0]["tracks"][0]["keys"])), (8000, 8000))


if __name__ == "__main__":
    unittest.main()
