"""The scene to start from."""

import unittest

from command_case import CommandTest


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

    def test_names_and_places_that_do_not_fit(self):
        self.refuse("new", "eyes.kfb", status=1, says="ends in .kfast")
        self.refuse("new", "eyes", status=1, says="ends in .kfast")
        self.refuse("new", "none/eyes.kfast", status=1, says="create the folder first")
        self.refuse("new", status=2, says="SCENE is required")


if __name__ == "__main__":
    unittest.main()
