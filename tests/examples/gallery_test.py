"""Every scene of examples/gallery is short, good, fast enough for a Pico, and offered by `kfast new`: gallery_test.py <kfast>."""

import json
import pathlib
import re
import subprocess
import sys
import unittest

KFAST = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = sorted((ROOT / "examples/gallery").glob("*.kfast"))
PAGE = (ROOT / "docs/gallery.md").read_text(encoding="utf-8")
FRAMES_A_SECOND = 30
LARGEST_PICTURE = 60_000


def kfast(*arguments):
    return subprocess.run([KFAST, *map(str, arguments)], capture_output=True, text=True, check=True, timeout=300).stdout


def slowest(scene):
    """Frames a second of the worst frame, with all inputs moving."""
    fps = json.loads(kfast("fit", scene, "--board", "pico", "--json"))["fps"]
    return min(rate for rate in (fps["cpu_worst"], fps["bus_worst"]) if rate is not None)


class GalleryTest(unittest.TestCase):
    def test_it_has_what_people_ask_for(self):
        self.assertLessEqual({"eyes", "face", "walk", "spinner", "ring", "gauge", "thermometer", "clock", "weather", "notification",
                              "menu", "logo", "dashboard"}, {scene.stem for scene in SCENES})

    def test_scenes_are_short_and_have_comments(self):
        for scene in SCENES:
            with self.subTest(scene=scene.name):
                lines = scene.read_text(encoding="utf-8").splitlines()
                self.assertLess(len(lines), 60)
                self.assertLess(max(map(len, lines)), 140)
                self.assertGreater(sum("//" in line for line in lines), 3)

    def test_scenes_compile_without_a_warning(self):
        for scene in SCENES:
            with self.subTest(scene=scene.name):
                self.assertIn(", 0 warnings\n", kfast("check", scene))

    def test_scenes_keep_up_on_a_pico_at_worst(self):
        for scene in SCENES:
            with self.subTest(scene=scene.name):
                self.assertGreaterEqual(slowest(scene), FRAMES_A_SECOND)

    def test_the_command_offers_them_with_their_first_lines(self):
        summaries = {scene.stem: scene.read_text(encoding="utf-8").splitlines()[0].removeprefix("// ") for scene in SCENES}
        listed = json.loads(kfast("new", "--list", "--json"))
        self.assertEqual({one["name"]: one["summary"] for one in listed}, summaries)
        for one in listed:
            facts = json.loads(kfast("info", ROOT / f"examples/gallery/{one['name']}.kfast", "--json"))
            self.assertEqual(one["inputs"], [row["name"] for row in facts["inputs"]])
            self.assertEqual(one["clips"], [row["name"] for row in facts["clips"]])

    def test_the_page_shows_them_in_the_same_order(self):
        order = [one["name"] for one in json.loads(kfast("new", "--list", "--json"))]
        self.assertEqual(re.findall(r"\(pictures/gallery-([\w-]+)\.gif\)", PAGE), order)
        self.assertEqual(re.findall(r"\(\.\./examples/gallery/([\w-]+)\.kfast\)", PAGE), order)

    def test_the_page_names_their_inputs(self):
        sections = dict(re.findall(r"(?ms)^## .*?$\n(?=.*?gallery/([\w-]+)\.kfast)(.*?)(?=^## |\Z)", PAGE))
        for one in json.loads(kfast("new", "--list", "--json")):
            with self.subTest(scene=one["name"]):
                for name in one["inputs"]:
                    self.assertIn(f"`{name}`", sections[one["name"]])

    def test_pictures_are_small(self):
        for scene in SCENES:
            with self.subTest(scene=scene.name):
                self.assertLess((ROOT / f"docs/pictures/gallery-{scene.stem}.gif").stat().st_size, LARGEST_PICTURE)


if __name__ == "__main__":
    unittest.main()
