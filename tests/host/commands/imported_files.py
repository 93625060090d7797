"""Small files of Lottie, SVG and Synfig, for the tests of kfast import."""

import io
import json
import zipfile

from command_case import CommandTest

FRAME = {"v": "5.7.0", "fr": 30, "ip": 0, "op": 30, "w": 100, "h": 80}
FILL = {"ty": "fl", "c": {"a": 0, "k": [1, 0.5, 0, 1]}, "o": {"a": 0, "k": 100}}
GRADIENT = {"ty": "gf", "o": {"a": 0, "k": 100}, "t": 1, "s": {"a": 0, "k": [0, 0]}, "e": {"a": 0, "k": [9, 0]},
            "g": {"p": 2, "k": {"a": 0, "k": [0, 1, 0, 0, 1, 0, 0, 1]}}}
MOVE = {"a": 1, "k": [{"t": 0, "s": [10, 10], "o": {"x": 0.3, "y": 0}, "i": {"x": 0.6, "y": 1}}, {"t": 30, "s": [90, 70]}]}

SVG = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" width="60" height="40">
  <circle id="sun" cx="{x}" cy="20" r="8" fill="#ff8000"/>
</svg>
"""

SIF = """<?xml version="1.0" encoding="UTF-8"?>
<canvas version="1.2" width="64" height="48" view-box="-2 1.5 2 -1.5" fps="24" begin-time="0f" end-time="1s">
  <layer type="circle" active="true" desc="ball">
    <param name="color"><color><r>1</r><g>0.5</g><b>0</b><a>1</a></color></param>
    <param name="radius"><real value="0.5"/></param>
    <param name="origin"><vector><x>0</x><y>0</y></vector></param>
  </layer>
</canvas>
"""


def lottie(paint=FILL, **more):
    shapes = [{"ty": "el", "p": {"a": 0, "k": [0, 0]}, "s": {"a": 0, "k": [20, 20]}}, paint]
    return json.dumps({**FRAME, "layers": [{"ty": 4, "nm": "dot", "ip": 0, "op": 30, "st": 0, "ks": {"p": MOVE},
                                            "shapes": shapes}], **more})


def zipped(files):
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            archive.writestr(path, content)
    return whole.getvalue()


class ImportCase(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("dot.json", lottie())
        self.write("shiny.json", lottie(GRADIENT))

    def write(self, name, content):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def scene(self, name):
        """The text that `kfast import` makes of a file."""
        return self.run_kfast("import", name, "-o", "-").stdout
