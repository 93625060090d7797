"""kfast import of files that are damaged, endless, or something else."""

import gzip
import json
import random
import unittest

from command_case import kfast
from imported_files import FRAME, GRADIENT, SIF, SVG, ImportCase, lottie, zipped


class RubbishTest(ImportCase):
    """Whatever a file holds, the answer is a sentence, or a scene."""

    def refused(self, name, content, says=""):
        self.write(name, content)
        for command in (["import", "-o", "out.kfast"], ["check"]):
            self.refuse(*command, name, status=1, says=f"kfast: {name}:{says and ' ' + says}")

    def test_other_files(self):
        self.refused("page.html", "<!DOCTYPE html><html><body>hello</body></html>",
                     "an XML file, but neither SVG nor Synfig")
        self.refused("wide.svg", SVG.format(x=1).encode("utf-16"), "the text is in UTF-16: save it as UTF-8")
        self.refused("other.zip", zipped({"readme.txt": "hello"}), "a zip file without an animation")
        self.refused("twice.svgz", gzip.compress(gzip.compress(b"<svg/>")), "is packed twice")
        self.write("hello.svg", "hello")
        self.refuse("import", "hello.svg", status=1, says="hello.svg: nothing that can be imported: kfast imports Lottie")
        self.write("void.svg", "")
        self.refuse("import", "void.svg", status=1, says="void.svg: the file is empty")
        self.refuse("import", "none.svg", status=1, says="none.svg: there is no such file")
        self.run_kfast("compile", "once.kfast")
        self.refuse("import", "once.kfb", status=1, says="once.kfb: a compiled scene already")

    def test_bombs(self):
        self.refused("bomb.svgz", gzip.compress(b" " * (17 << 20)), "holds more than 16 MB")
        self.refused("bomb.lottie", zipped({"a/dot.json": b" " * (17 << 20)}), "a/dot.json is larger than 16 MB")

    def test_broken_texts(self):
        self.refused("half.json", lottie()[:-9])
        self.refused("half.svg", SVG.format(x=1)[:-12])
        self.refused("half.sif", SIF[:-40])
        self.refused("list.json", "{}")

    def test_depths(self):
        deep = 100_000
        self.refused("deep.json", '{"layers":' + "[" * deep)
        self.refused("deeper.json", '{"layers":' + "[" * deep + "]" * deep + "}")
        groups = '{"ty":"gr","it":[' * deep + "]}" * deep
        self.refused("groups.json", json.dumps({**FRAME, "layers": [{"ty": 4, "ip": 0, "op": 9, "ks": {}, "shapes": [0]}]})
                     .replace("[0]", f"[{groups}]"))
        self.refused("deep.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">' + "<g>" * deep
                     + '<rect width="5" height="5"/>' + "</g>" * deep + "</svg>")
        self.refused("deep.sif", '<canvas version="1.2" width="9" height="9">'
                     + '<layer type="group"><param name="canvas"><canvas>' * deep
                     + "</canvas></param></layer>" * deep + "</canvas>")

    def test_circles(self):
        comp = {"ty": 0, "refId": "a", "ip": 0, "op": 30, "st": 0, "ks": {}, "w": 9, "h": 9}
        self.answered("circle.json", json.dumps({**FRAME, "layers": [comp], "assets": [{"id": "a", "layers": [comp]}]}))
        self.answered("circle.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">'
                                    '<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g><use href="#a"/></svg>')

    def test_what_explodes(self):
        uses = "".join(f'<g id="l{level + 1}">' + f'<use href="#l{level}"/>' * 10 + "</g>" for level in range(12))
        self.answered("laughs.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><defs>'
                                    f'<rect id="l0" width="5" height="5" fill="red"/>{uses}</defs><use href="#l12"/></svg>')
        comps = [{"id": f"c{level + 1}",
                  "layers": [{"ty": 0, "refId": f"c{level}", "ip": 0, "op": 30, "ks": {}, "w": 900, "h": 900}] * 10}
                 for level in range(12)]
        square = {"ty": "rc", "p": {"k": [5, 5]}, "s": {"k": [5, 5]}, "r": {"k": 0}}
        fill = {"ty": "fl", "c": {"k": [1, 0, 0]}, "o": {"k": 100}}
        squares = {"ty": 4, "ip": 0, "op": 30, "ks": {}, "shapes": [{"ty": "gr", "it": [square, fill]}] * 1000}
        comps.append({"id": "c0", "layers": [squares]})  # so many at a time, for sanitizers are slow
        self.answered("laughs.json", json.dumps({**FRAME, "layers": comps[11]["layers"], "assets": comps}))

    def answered(self, name, content):
        """Either a scene or a refusal, and nothing in between."""
        self.write(name, content)
        result = self.run_any("check", name)
        self.assertIn(result.returncode, (0, 1), f"{name}: {result.stderr[:400]}")
        self.assertNotIn("mistake in kfast", result.stderr)
        if result.returncode:
            self.assertTrue(result.stderr.startswith(f"kfast: {name}:"), result.stderr[:400])

    def run_any(self, *arguments):
        return kfast(*arguments, folder=self.folder)

    def test_numbers(self):
        for number in ("1e999", "-1e308", "1e-320", "NaN", "nan", "inf", "0x10", "1e", "--1", "99999999999999999999", "null",
                       '"a"', "[]", "{}", "1.5.5", ""):
            with self.subTest(number=number):
                self.answered("number.svg", SVG.replace("{x}", number.replace('"', "&quot;")))
                self.answered("size.svg", SVG.replace('width="60"', f'width="{number.replace(chr(34), "")}"'))
                self.answered("number.sif", SIF.replace('value="0.5"', f'value="{number.replace(chr(34), "")}"'))
                self.answered("size.sif", SIF.replace('width="64"', f'width="{number.replace(chr(34), "")}"'))
                for at in ("[20, 20]", '"fr": 30', '"op": 30', '"w": 100', "0.5", "100}", '"t": 30', "[90, 70]"):
                    name, colon, value = at.partition(": ")
                    self.answered("number.json", lottie().replace(at, f"{name}: {number}" if colon else number, 1))

    def test_cut_and_changed(self):
        dice = random.Random(10)
        for name, content in {"a.json": lottie(GRADIENT), "a.svg": SVG.format(x=9), "a.sif": SIF,
                              "a.lottie": zipped({"manifest.json": "{}", "a/dot.json": lottie()})}.items():
            whole = content if isinstance(content, bytes) else content.encode()
            for _ in range(25):
                changed = bytearray(whole[:dice.randrange(4, len(whole))] if dice.random() < 0.3 else whole)
                for _ in range(dice.randrange(1, 4)):
                    changed[dice.randrange(4, len(changed))] = dice.choice(b'0-9e{}[]",:<>/ \0\xff')
                with self.subTest(changed=bytes(changed)):
                    self.write(name, bytes(changed))
                    result = self.run_any("check", name)
                    self.assertIn(result.returncode, (0, 1), result.stderr[:400])
                    self.assertNotIn("mistake in kfast", result.stderr)


if __name__ == "__main__":
    unittest.main()
