"""kfast import, and files of other programs through the commands that take scenes."""

import gzip
import json
import math
import unittest

from command_case import ROOT, CommandTest
from imported_files import FILL, FRAME, GRADIENT, SIF, SVG, ImportCase, lottie, zipped


class ImportTest(ImportCase):
    def test_writes_a_scene_beside_the_file_and_tells_what_it_has(self):
        line = self.run_kfast("import", "dot.json").stdout
        self.assertRegex(line, r"^dot.kfast: 1 object, \d+ keys, \d+ points; \d+ bytes compiled, \d+ bytes of memory at "
                               r"100x80\nall is carried over\n$")
        self.assertIn("object dot", (self.folder / "dot.kfast").read_text())
        self.assertRegex(self.run_kfast("check", "dot.kfast").stdout, "ok: .*, 0 warnings")

    def test_the_text_and_the_file_are_the_same_scene(self):
        for name, content in {"dot.json": lottie(), "sun.svg": SVG.format(x=20), "ball.sif": SIF}.items():
            with self.subTest(name=name):
                self.write(name, content)
                self.run_kfast("import", name, "-o", "text.kfast")
                self.run_kfast("compile", "text.kfast", "-o", "text.kfb")
                self.run_kfast("compile", name, "-o", "file.kfb")
                self.assertEqual((self.folder / "text.kfb").read_bytes(), (self.folder / "file.kfb").read_bytes())

    def test_standard_output_has_the_text_alone(self):
        result = self.run_kfast("import", "dot.json", "-o", "-")
        self.assertTrue(result.stdout.startswith("// "), result.stdout)
        self.assertIn("kfast 1\n", result.stdout)
        self.assertTrue(result.stderr.startswith("standard output: 1 object"), result.stderr)

    def test_a_text_that_was_changed_is_replaced_by_name_alone(self):
        self.run_kfast("import", "dot.json")
        self.run_kfast("import", "dot.json")
        self.write("dot.kfast", "// changed by hand")
        self.refuse("import", "dot.json", status=1, says="-o dot.kfast replaces it")
        self.assertEqual((self.folder / "dot.kfast").read_text(), "// changed by hand")
        self.run_kfast("import", "dot.json", "-o", "dot.kfast")
        self.assertIn("object dot", (self.folder / "dot.kfast").read_text())

    def test_never_overwrites_the_file(self):
        self.refuse("import", "dot.json", "-o", "dot.json", status=1, says="overwrite the file that is imported")

    def test_the_content_tells_the_kind(self):
        for content in (lottie(), "\ufeff \n" + lottie(), SVG.format(x=20), "\ufeff" + SVG.format(x=20), SIF,
                        gzip.compress(SVG.format(x=20).encode()), gzip.compress(SIF.encode()),
                        gzip.compress(lottie().encode()), zipped({"animations/dot.json": lottie()})):
            with self.subTest(content=content[:20]):
                self.run_kfast("check", self.write("any.name", content))

    def test_losses_are_listed(self):
        text = self.run_kfast("import", "shiny.json").stdout
        self.assertIn("1 thing is not carried over:\n", text)
        self.assertRegex(text, r"\n  .*gradient.* \(dot.*\): ")

    def test_strict_refuses_losses_and_writes_nothing(self):
        self.refuse("import", "shiny.json", "--strict", status=1, says="kfast: shiny.json: 1 thing is not carried over:\n")
        self.run_kfast("import", "dot.json", "--strict")

    def test_json(self):
        report = json.loads(self.run_kfast("import", "shiny.json", "--json").stdout)
        self.assertEqual((report["file"], report["scene"]), ("shiny.json", "shiny.kfast"))
        self.assertEqual((report["objects"], report["more_losses"]), (1, 0))
        self.assertEqual((report["memory"]["width"], report["memory"]["height"]), (100, 80))
        loss, = report["losses"]
        self.assertEqual(set(loss), {"feature", "layer", "time", "instead"})
        self.assertIn("dot", loss["layer"])

    def test_size(self):
        self.assertIn("canvas 50 40", self.run_kfast("import", "dot.json", "--canvas", "50x50", "-o", "-").stdout)
        self.assertIn("canvas 200 160", self.run_kfast("import", "dot.json", "--canvas", "200x900", "-o", "-").stdout)
        self.assertRegex(self.run_kfast("check", "dot.json", "--canvas", "50x50").stdout, "at 50x40")
        self.refuse("import", "dot.json", "--canvas", "2048x9", status=2, says="at most 2047")

    def test_a_canvas_that_is_too_large_is_made_smaller_and_told(self):
        self.write("large.json", lottie(w=4094, h=2000))
        result = self.run_kfast("import", "large.json", "-o", "-")
        self.assertIn("canvas 2047 1000", result.stdout)
        self.assertIn("canvas of 4094x2000 pixels: all of it smaller, on 2047x1000", result.stderr)
        self.run_kfast("check", "large.json", "--strict", "--canvas", "2047x2047")

    def test_what_goes_far_beyond_a_large_canvas_makes_it_smaller(self):
        def flying(side):
            move = {"a": 1, "k": [{"t": 0, "s": [10, 10]}, {"t": 30, "s": [90, 4000]}]}
            shapes = [{"ty": "el", "p": {"a": 0, "k": [0, 0]}, "s": {"a": 0, "k": [20, 20]}}, FILL]
            layer = {"ty": 4, "nm": "dot", "ip": 0, "op": 30, "st": 0, "ks": {"p": move}, "shapes": shapes}
            return json.dumps({**FRAME, "w": side, "h": side, "layers": [layer]})
        self.write("tall.json", flying(3000))
        result = self.run_kfast("import", "tall.json", "-o", "-")
        self.assertIn("canvas 1528 1528", result.stdout)
        self.assertNotIn("scale", result.stdout)
        self.assertIn("canvas of 3000x3000 pixels: all of it smaller, on 1528x1528", result.stderr)
        self.write("small.json", flying(1000))
        text = self.run_kfast("import", "small.json", "-o", "-", "--strict").stdout
        self.assertIn("canvas 1000 1000", text)
        self.assertIn("group scale=2", text)

    def test_limits_of_scenes_are_told_with_a_remedy(self):
        def turning(number):
            turn = {"a": 1, "k": [{"t": 0, "s": [0], "o": {"x": 0.3, "y": number / 300}, "i": {"x": 0.6, "y": 1}},
                                  {"t": 30, "s": [90]}]}
            shapes = [{"ty": "rc", "p": {"a": 0, "k": [9, 9]}, "s": {"a": 0, "k": [20, 9]}, "r": {"a": 0, "k": 0}}, FILL]
            return {"ty": 4, "nm": "bar", "ip": 0, "op": 30, "st": 0, "ks": {"r": turn}, "shapes": shapes}
        self.write("laws.json", json.dumps({**FRAME, "layers": [turning(number) for number in range(300)]}))
        self.assertIn("300 different eases: ", self.run_kfast("import", "laws.json").stdout)
        self.refuse("import", "laws.json", "-o", "strict.kfast", "--strict", status=1, says="different eases")
        spin = {"a": 1, "k": [{"t": time, "s": [time * time % 251], "h": 1} for time in range(70000)]}
        dot = {"ty": 4, "nm": "dot", "ip": 0, "op": 70000, "st": 0, "ks": {"r": spin}, "shapes": turning(0)["shapes"]}
        self.write("keys.json", json.dumps({**FRAME, "op": 70000, "layers": [dot]}))
        self.refuse("import", "keys.json", status=1, says="keys.json: something has more than 65535 keys")
        zigzag = " ".join(f"{x % 60} {x * 7 % 40}" for x in range(70000))
        self.write("zigzag.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="60" height="40">'
                                 + "".join(f'<path d="M {zigzag[:4000]} {x}"/>' for x in range(400)) + "</svg>")
        self.refuse("import", "zigzag.svg", "--tolerance", "0", status=1, says="; show less at once, use symbols less often, or draw with fewer points")

    def test_background_of_files_that_have_none(self):
        self.write("sun.svg", SVG.format(x=20))
        self.write("night.svg", SVG.format(x=20).replace("<svg", '<svg style="background-color: navy"'))
        self.assertIn("background=white", self.scene("sun.svg"))
        night = self.run_kfast("import", "night.svg", "--background", "red", "-o", "-").stdout
        self.assertIn('background "#000080"', night)
        self.assertNotIn("background=", self.scene("dot.json"))
        for name in ("sun.svg", "dot.json"):
            text = self.run_kfast("import", name, "--background", "#0F8", "-o", "-").stdout
            self.assertRegex(text, 'canvas.* background=background\n')
            self.assertIn('background "#00ff88"', text)
        self.run_kfast("import", "--keys", "sun.svg", "night.svg", "--at", "0", "9", "-o", "keys.kfast")
        self.assertIn("background=white", (self.folder / "keys.kfast").read_text())
        self.refuse("import", "sun.svg", "--background", "snowy", status=2, says="'snowy' is no colour: take a name like")
        self.refuse("import", "sun.svg", "--background", "#fff8", status=2, says="cannot be transparent")

    def test_tolerance_leaves_points_out(self):
        scene = ROOT / "tests/accuracy/lottie/walker.json"
        points = []
        for tolerance in ("0", "0.03125", "4"):
            report = self.run_kfast("import", scene, "-o", "walker.kfast", "--json", "--tolerance", tolerance).stdout
            points.append(json.loads(report)["points"])
        self.assertEqual(points, sorted(points, reverse=True))
        self.assertLess(points[2], points[0] / 2 + 10)
        for wrong in ("-1", "nan", "x", "100"):
            self.refuse("import", "dot.json", "--tolerance", wrong, status=2, says="is not a number from 0 to 64")

    def test_usage(self):
        self.refuse("import", status=2, says="one of FILE and --keys FILES --at TIMES")
        self.refuse("import", "dot.json", "--at", "0", status=2, says="--keys")
        self.refuse("import", "dot.json", "--animation", "a", status=1, says="this is none")


class KeyDrawingTest(ImportCase):
    def setUp(self):
        super().setUp()
        for x in (10, 30, 50):
            self.write(f"pose{x}.svg", SVG.format(x=x))

    def test_drawings_become_keys(self):
        result = self.run_kfast("import", "--keys", "pose10.svg", "pose30.svg", "pose50.svg", "--at", "0", "12", "0.8s",
                                "--fps", "25", "--law", "ease-in-out", "--end", "once", "-o", "-")
        self.assertIn("fps=25", result.stdout)
        self.assertIn("loop=once", result.stdout)
        self.assertIn("ease-in-out", result.stdout)
        self.assertIn("20", result.stdout)
        self.assertIn("object sun", result.stdout)

    def test_layers_that_are_keys_are_told(self):
        layers = "".join(f'<g id="{name}"><circle r="{3 + index}"/></g>' for index, name in enumerate(("f 0", "f 12")))
        self.write("layers.svg", f'<svg xmlns="http://www.w3.org/2000/svg" width="90" height="90">{layers}</svg>')
        told = 'the layers "f 0", "f 12" are key drawings, by their names: --layers never draws them over each other'
        self.assertIn(told + "\n", self.run_kfast("import", "layers.svg").stdout)
        self.assertEqual(json.loads(self.run_kfast("import", "layers.svg", "--json").stdout)["notes"], [told])
        self.assertNotIn("by their names", self.run_kfast("import", "layers.svg", "--layers", "never",
                                                          "-o", "still.kfast").stdout)

    def test_what_is_the_same_by_its_order_alone_is_told(self):
        def said(first, second):
            for name, content in (("a.svg", first), ("b.svg", second)):
                self.write(name, f'<svg xmlns="http://www.w3.org/2000/svg" width="90" height="90">{content}</svg>')
            return self.run_kfast("import", "--keys", "a.svg", "b.svg", "--at", "0", "9", "-o", "a.kfast").stdout

        hint = 'name parts alike (id="...") so that they become each other'
        self.assertIn(hint, said('<path d="M0 0h9v9z"/>', '<path d="M40 0h9v9h-9z"/>'))
        self.assertIn("of 2 outlines, and of 1 outline: one path each", said('<path d="M0 0h9v9zM20 0h9v9z"/>', '<path d="M0 0h9v9z"/>'))
        for first, second in (('<path id="sun" d="M0 0h9v9z"/>', '<path id="sun" d="M40 0h9v9h-9z"/>'),
                              ('<path d="M0 0h9v9z"/>', '<path d="M0 0h9v9z"/>')):
            self.assertNotIn(hint, said(first, second))
        self.assertIn(hint, said('<g id="sky"><path d="M0 0h9v9z"/></g>', '<g id="sky"><path d="M9 0h9v9z"/></g>'))

    def test_the_scene_is_named_after_the_first(self):
        self.run_kfast("import", "--keys", "pose10.svg", "pose30.svg", "--at", "0", "9")
        self.assertTrue((self.folder / "pose10.kfast").is_file())

    def test_wrong_drawings_and_times(self):
        self.refuse("import", "--keys", "pose10.svg", "pose30.svg", "--at", "0", status=1,
                    says="2 key drawings but 1 times")
        self.refuse("import", "--keys", "pose10.svg", "pose30.svg", "--at", "9", "3", status=1, says="do not rise")
        self.refuse("import", "--keys", "pose10.svg", "dot.json", "--at", "0", "3", status=1,
                    says="dot.json: is no SVG file, as key drawings are")
        self.refuse("import", "--keys", "pose10.svg", "--at", "soon", status=1, says="'soon' is no time")
        self.refuse("import", "--keys", "pose10.svg", status=2, says="--at")
        self.refuse("import", "dot.json", "--law", "sudden", status=2, says="unknown law")
        self.refuse("import", "dot.json", "--law", "steps(3)", status=2, says="cannot be imported")
        self.refuse("import", "dot.json", "--end", "never", status=2, says="'never' is unknown")

    def test_options_of_key_drawings_are_refused_where_there_are_none(self):
        for option in (["--fps", "60"], ["--law", "hold"], ["--end", "once"], ["--layers", "never"]):
            self.refuse("import", "dot.json", *option, status=1, says="are for key drawings of SVG, and this is none")


class DotLottieTest(ImportCase):
    def setUp(self):
        super().setUp()
        manifest = {"version": "2", "animations": [{"id": "dot", "speed": 2, "loop": False}, {"id": "shiny"}]}
        self.write("two.lottie", zipped({"manifest.json": json.dumps(manifest), "a/dot.json": lottie(),
                                         "a/shiny.json": lottie(GRADIENT)}))

    def test_the_first_animation_is_taken_as_the_manifest_says(self):
        result = self.run_kfast("import", "two.lottie", "-o", "-")
        self.assertIn("fps=60", result.stdout)
        self.assertIn("loop=once", result.stdout)
        self.assertIn("more than one animation: 'dot' of dot, shiny (--animation ID takes another)", result.stderr)

    def test_its_background_lies_behind_a_layer_that_covers_the_canvas(self):
        ground = {"ty": 1, "sc": "#ff0000", "sw": FRAME["w"], "sh": FRAME["h"], "ip": 0, "op": 30, "st": 0, "ks": {}}
        manifest = {"animations": [{"id": "dot", "background": "#00ff00"}]}
        for layers, background in (([], "#00ff00"), ([ground], "#ff0000")):
            animation = json.loads(lottie())
            animation["layers"] += layers
            self.write("ground.lottie", zipped({"manifest.json": json.dumps(manifest),
                                                "a/dot.json": json.dumps(animation)}))
            self.assertIn(f'{{ background "{background}"', self.run_kfast("import", "ground.lottie", "-o", "-").stdout)

    def test_another_animation(self):
        self.run_kfast("check", "two.lottie", "--animation", "dot", "--strict")
        self.assertIn("gradient", self.run_kfast("check", "two.lottie", "--animation", "shiny").stdout)
        self.refuse("import", "two.lottie", "--animation", "x", status=1,
                    says="there is no animation 'x': it has dot, shiny")


class EverywhereTest(ImportCase):
    COMMANDS = (["info"], ["hash"], ["preview", "--headless"], ["render", "--all", "-o", "out"],
                ["compile", "-o", "out.kfb"], ["fit", "--board", "pico"], ["export", "--header"])

    def test_commands_take_files_of_other_programs(self):
        for command in self.COMMANDS:
            with self.subTest(command=command):
                self.assertEqual(self.run_kfast(*command, "dot.json").stderr, "")
                self.assertEqual(self.run_kfast(*command, "shiny.json").stderr,
                                 "shiny.json: warning: 1 thing is not carried over: 'kfast check shiny.json' lists them\n")

    def test_compile_writes_beside_the_file(self):
        self.assertRegex(self.run_kfast("compile", "dot.json").stdout, r"^dot.kfb: ")

    def test_check_lists_losses(self):
        result = self.run_kfast("check", "shiny.json")
        self.assertRegex(result.stdout, r"^shiny.json: ok: .*, 0 warnings\n1 thing is not carried over:\n  .*gradient")
        self.assertEqual(result.stderr, "")

    def test_strict(self):
        for command in (["check"], ["compile"], ["fit", "--board", "pico"]):
            self.refuse(*command, "shiny.json", "--strict", status=1, says="shiny.json: 1 thing is not carried over:\n")
            self.run_kfast(*command, "dot.json", "--strict")

    def test_help_names_the_files(self):
        self.assertIn("import", self.run_kfast("--help").stdout)
        for command in ("compile", "check", "fit", "preview", "render", "flash", "upload", "play"):
            self.assertIn(".lottie", self.run_kfast(command, "--help").stdout, command)


class LongTest(CommandTest):
    def test_long_imports_are_seen_on_a_terminal_alone(self):
        (self.folder / "short.svg").write_text(SVG.format(x=20))
        self.assertEqual(self.written_to_a_terminal("import", "short.svg"), "")
        (self.folder / "long.json").write_text(rings(150, points=200, frames=1000))
        written = self.written_to_a_terminal("import", "long.json")
        self.assertRegex(written, r"\rimporting \[#* *\] +\d+ %  \d+ s left")
        self.assertRegex(written, r"\r +\r$")


def rings(count, points, frames):
    """Layers with a way between two drawings of so many points."""
    def ring(turn):
        angles = [2 * math.pi * place / points for place in range(points)]
        wave = [[50 + 40 * math.cos(angle + turn), 50 + 30 * math.sin(angle)] for angle in angles]
        return {"c": True, "v": wave, "i": [[0, 0]] * points, "o": [[0, 0]] * points}

    def layer(number):
        keys = [{"t": 0, "s": [ring(number)], "o": {"x": 0.3, "y": 0}, "i": {"x": 0.6, "y": 1}}, {"t": frames, "s": [ring(number + 1)]}]
        return {"ty": 4, "ip": 0, "op": frames, "st": 0, "ks": {}, "shapes": [{"ty": "sh", "ks": {"a": 1, "k": keys}}, FILL]}

    return json.dumps({**FRAME, "op": frames, "layers": [layer(number) for number in range(count)]})


if __name__ == "__main__":
    unittest.main()
