"""What tests of kfast render have in common: a scene that rests for a while, and what is in the pictures of a file."""

import shutil

from PIL import Image

from command_case import CommandTest

# 29.97 frames a second, of which three are the same.
RESTING = """kfast 1
canvas 21 11 fps=29.97 loop={loop}
object dot fill="#f2f2f2" {{
    key 0 {{ rect 1 1 4 4 }}
    key 3 law=hold {{ rect 7 1 4 4 }}
    key 6 {{ rect 13 4 4 4 }}
}}
"""


class RenderTest(CommandTest):
    def setUp(self):
        super().setUp()
        for loop in ("once", "repeat"):
            (self.folder / f"resting-{loop}.kfast").write_text(RESTING.format(loop=loop))

    def render(self, *arguments, **more):
        return self.run_kfast("render", *arguments, **more)

    def opened(self, name):
        with Image.open(self.folder / name) as image:
            return image.convert("RGB")

    def pictures(self, name):
        """Of an animation, as pairs of milliseconds and pixels."""
        found = []
        with Image.open(self.folder / name) as image:
            for index in range(getattr(image, "n_frames", 1)):
                image.seek(index)
                found.append((image.info.get("duration"), image.convert("RGB").tobytes()))
        return found

    def frames(self, *arguments):
        self.render(*arguments, "--all", "-o", "frames")
        files = sorted((self.folder / "frames").iterdir())
        pixels = [self.opened(file).tobytes() for file in files]
        shutil.rmtree(self.folder / "frames")
        return pixels
