"""kfast preview --beside: what another panel has shown, at the right of the preview."""

import re
import unittest

from command_case import CommandTest

PANEL = ("--size", "60x40", "--format", "grey4")
NO_WINDOW = {"TERM": "dumb", "COLORTERM": "", "NO_COLOR": "1"}


class BesideTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.run_kfast("render", "repeat.kfast", *PANEL, "--all", "-o", "board")

    def snapshot(self, name, *arguments):
        self.run_kfast("preview", "repeat.kfast", "--headless", "--snapshot", name, "--window", "800x400", *arguments)
        return (self.folder / name).read_bytes()

    def test_what_is_no_terminal_gets_both_pictures_as_text(self):
        lines = [self.run_kfast("preview", "repeat.kfast", *PANEL, "--terminal", *more, environment=NO_WINDOW).stdout.splitlines()
                 for more in ((), ("--beside", "board"))]
        alone, both = ([line for line in text if line.strip()] for text in lines)
        self.assertGreater(len(re.findall(r"@+", both[1])), len(re.findall(r"@+", alone[1])))

    def test_a_window_shows_another_picture_where_the_board_does(self):
        same = self.snapshot("same.png", *PANEL, "--beside", "board")
        self.assertNotEqual(same, self.snapshot("alone.png", *PANEL))
        (self.folder / "board/0005.png").replace(self.folder / "board/0000.png")
        self.assertNotEqual(same, self.snapshot("other.png", *PANEL, "--beside", "board"))

    def test_pictures_of_another_size_are_refused(self):
        self.refuse("preview", "repeat.kfast", "--size", "30x20", "--terminal", "--beside", "board", status=1,
                    says="60x40 pixels and the panel of the preview 30x20: choose the same one with --panel or --size")

    def test_a_folder_without_pictures_is_refused(self):
        (self.folder / "empty").mkdir()
        self.refuse("preview", "repeat.kfast", "--terminal", "--beside", "empty", status=1, says="empty has no pictures 0000.png")
        self.refuse("preview", "repeat.kfast", "--terminal", "--beside", "nowhere", status=1, says="nowhere")

    def test_unseen_it_would_be_of_no_use(self):
        self.refuse("preview", "repeat.kfast", "--headless", "--beside", "board", status=2, says="add --snapshot")


if __name__ == "__main__":
    unittest.main()
