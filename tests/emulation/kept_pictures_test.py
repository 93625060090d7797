"""What board_test.py keeps of a board's panel is what the preview shows beside it, frame by frame:

    kept_pictures_test.py <lm3s6965evb-cortex-….elf> <scene.kfb> <kfast>"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from PIL import Image, ImageChops

HERE = pathlib.Path(__file__).resolve().parent
IMAGE, SCENE, KFAST = sys.argv[1:]
sys.argv[1:] = []


class KeptPicturesTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.kept, self.rendered = (pathlib.Path(temporary.name, name) for name in ("kept", "rendered"))
        self.kept.mkdir()
        (self.kept / "9999.png").write_text("of another scene", encoding="utf-8")
        subprocess.run([sys.executable, HERE / "board_test.py", IMAGE, SCENE, KFAST, "--keep", self.kept], check=True, timeout=200)
        subprocess.run([KFAST, "render", SCENE, "--panel", "ssd0323", "--all", "-o", self.rendered], check=True, timeout=60)

    def test_there_is_each_frame_as_large_as_the_panel(self):
        names = [sorted(path.name for path in folder.iterdir()) for folder in (self.kept, self.rendered)]
        self.assertEqual(*names)
        for name in names[0]:
            kept, rendered = (Image.open(folder / name).convert("RGB") for folder in (self.kept, self.rendered))
            self.assertEqual(kept.size, rendered.size)
            self.assertIsNone(ImageChops.difference(kept, rendered).getbbox(), name)
        subprocess.run([KFAST, "preview", SCENE, "--panel", "ssd0323", "--terminal", "--beside", self.kept], check=True,
                       stdout=subprocess.DEVNULL, timeout=60)


if __name__ == "__main__":
    unittest.main()
