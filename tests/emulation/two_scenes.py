"""Emulated boards that play one scene and are sent another one."""

from pico import expect_scene
from served_pico import ServedPico

CONFIGURATION = "pico-st7789"
FRAMES = 8


class TwoScenes:
    """Boards that play, and what they are to show."""

    def __init__(self, desk, at_first, sent):
        self.desk = desk
        self.settings = desk.settings(CONFIGURATION)
        self.at_first, self.sent = desk.compile(at_first), desk.compile(sent)
        self._hashes = {scene: desk.hashes(scene, self.settings) for scene in (self.at_first, self.sent)}

    def board(self, *options):
        return ServedPico(self.desk.image(self.settings), *self.desk.recorded(self.settings), "--scene", self.at_first,
                          *options)

    def expect_playing(self, board, scene, when):
        expect_scene(self.desk.watch(board, self.settings, FRAMES), self._hashes[scene], f"{when} the board")
