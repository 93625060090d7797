"""The scene to start from, and those of the gallery."""

import json
import os
import pty
import re
import subprocess
import unittest

from command_case import KFAST, ROOT, CommandTest

GALLERY = sorted((ROOT / "examples/gallery").glob("*.kfast"))


def shown_in_a_terminal(*arguments, **environment):
    """On standard output, in a terminal of 80 x 24 characters."""
    master, slave = pty.openpty()
    program = subprocess.Popen([KFAST, *arguments], stdout=slave, env={**os.environ, "COLORTERM": "", "NO_COLOR": "", **environment})
    os.close(slave)
    shown = b""
    while True:
        try:
            shown += os.read(master, 65536)
        except OSError:  # the other end is closed
            break
    os.close(master)
    return program.wait(timeout=120), shown.decode().replace("\r\n", "\n")


class NewTest(CommandTest):
    def test_the_scene_compiles_without_a_warning_and_moves(self):
        self.assertIn("kfast preview eyes.kfast", self.run_kfast("new", "eyes.kfast").stdout)
        self.assertIn("ok", self.run_kfast("check", "eyes.kfast").stdout)
        self.assertIn("0 warnings", self.run_kfast("check", "eyes.kfast").stdout)
        hashes = {line.split()[-1] for line in self.run_kfast("hash", "eyes.kfast").stdout.splitlines()}
        self.assertGreater(len(hashes), 15)

    def test_every_line_of_the_scene_is_short_and_it_has_comments(self):
        self.run_kfast("new", "eyes.kfast")
        lines = (self.folder / "eyes.kfast").read_text().splitlines()
        self.assertLess(max(map(len, lines)), 120)
        self.assertGreater(sum("//" in line for line in lines), 10)

    def test_nothing_is_overwritten(self):
        before = (self.folder / "once.kfast").read_bytes()
        self.refuse("new", "once.kfast", status=1, says="once.kfast exists already")
        self.assertEqual((self.folder / "once.kfast").read_bytes(), before)
        (self.folder / "dangling.kfast").symlink_to("elsewhere.kfast")
        self.refuse("new", "dangling.kfast", status=1, says="exists already")

    def test_force_replaces_a_file(self):
        self.run_kfast("new", "once.kfast", "--force", "--like", "gauge")
        self.assertEqual((self.folder / "once.kfast").read_text(), (ROOT / "examples/gallery/gauge.kfast").read_text())

    def test_names_and_places_that_do_not_fit(self):
        self.refuse("new", "eyes.kfb", status=1, says="ends in .kfast")
        self.refuse("new", "eyes", status=1, says="ends in .kfast")
        self.refuse("new", "none/eyes.kfast", status=1, says="create the folder first")
        self.refuse("new", status=2, says="SCENE is required")
        self.refuse("new", "--like", "gauge", status=2, says="SCENE is required")


class GalleryTest(CommandTest):
    def test_a_new_scene_is_that_of_the_gallery(self):
        for scene in GALLERY:
            with self.subTest(scene=scene.name):
                printed = self.run_kfast("new", "mine.kfast", "--force", "--like", scene.stem).stdout
                self.assertEqual((self.folder / "mine.kfast").read_bytes(), scene.read_bytes())
                self.assertIn("kfast preview mine.kfast", printed)

    def test_a_name_that_there_is_not(self):
        self.refuse("new", "mine.kfast", "--like", "gage", status=2, says='did you mean "gauge"?')
        self.refuse("new", "mine.kfast", "--like", "zebra", status=2, says="thermometer")

    def test_the_list_is_plain_where_nobody_looks(self):
        lines = self.run_kfast("new", "--list").stdout.splitlines()
        self.assertEqual({line.split()[0] for line in lines}, {scene.stem for scene in GALLERY})
        for line in lines:
            self.assertRegex(line, r"^[a-z]+  +[A-Z].*\.$")
            self.assertLess(len(line), 80)

    def test_the_list_shows_pictures_in_a_terminal(self):
        status, shown = shown_in_a_terminal("new", "--list", TERM="xterm-256color")
        self.assertEqual(status, 0)
        self.assertTrue(shown.endswith(self.run_kfast("new", "--list").stdout))
        pictures = re.sub(r"\x1b\[[0-9;]*m", "", shown.removesuffix(self.run_kfast("new", "--list").stdout)).splitlines()
        self.assertEqual({name for line in pictures if "\u2580" not in line for name in line.split()},
                         {scene.stem for scene in GALLERY})
        self.assertEqual(sum(line.count("\u2580") for line in pictures), 18 * 9 * len(GALLERY))
        self.assertLess(max(map(len, pictures)), 80)

    def test_the_list_has_no_pictures_where_they_cannot_be_shown(self):
        plain = self.run_kfast("new", "--list").stdout
        self.assertEqual(shown_in_a_terminal("new", "--list", TERM="dumb"), (0, plain))
        status, shown = shown_in_a_terminal("new", "--list", TERM="xterm", NO_COLOR="1")
        self.assertEqual(status, 0)
        self.assertNotIn("\x1b", shown)

    def test_the_list_for_tools(self):
        listed = json.loads(self.run_kfast("new", "--list", "--json").stdout)
        self.assertEqual({one["name"] for one in listed}, {scene.stem for scene in GALLERY})
        gauge = next(one for one in listed if one["name"] == "gauge")
        self.assertEqual(gauge["inputs"], ["value"])

    def test_options_that_do_not_go_together(self):
        self.refuse("new", "--list", "mine.kfast", status=2, says="SCENE excludes --list")
        self.refuse("new", "--list", "--like", "gauge", status=2, says="excludes")
        self.refuse("new", "mine.kfast", "--json", status=2, says="--json requires --list")


if __name__ == "__main__":
    unittest.main()
