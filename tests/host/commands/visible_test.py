"""Nothing that comes from outside makes a terminal do something: names, texts, arguments and the environment may hold
what it would obey, and come out as <U+001B> and the like."""

import json
import os
import re
import subprocess
import unittest
import zlib

from command_case import KFAST, CommandTest
from pretend_firmware import firmware

# An escape sequence, a bell, a control sequence in one code point, a carriage return, text from right to left.
EVIL = "\x1b[31m\x07\x9b2J\r\u202e"
EVIL_BYTES = EVIL.encode() + b"\xff\xc2"
OBEYED = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")
OWN = re.compile("\x1b\\[(0|1;31|1;35|1;36)m")
ESCAPED = EVIL.replace("\x1b", "\\u{1b}").replace("\x07", "\\u{7}").replace("\x9b", "\\u{9b}").replace("\r", "\\r").replace(
    "\u202e", "\\u{202e}")

NAMED = """kfast 1
canvas 60 40 fps=30 frames=60
input AAAAAAAAAAAA min=0 max=1
input BBBBBBBBBBBB kind=text glyphs="AB" max=4 default="AB"
object dot fill=white { rect 0 0 9 9; track x input=AAAAAAAAAAAA { at 0 0; at 1 9 } }
clip CCCCCCCCCCCC from=1 to=5
event 3 DDDDDDDDDDDD
"""
SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="60" height="40"><g id="a{evil}"><rect width="5" height="5" id="{evil}"
filter="url(#{evil})"/></g><image width="4" height="4" id="{evil}" href="{evil}.png"/><{tag} id="{evil}"/></svg>"""
CONFIGURATION = 'board pico\nfirmware "{evil}"\nbus {evil}\npin "{evil}" 3\n'


class VisibleTest(CommandTest):
    def write(self, name, content):
        path = os.path.join(os.fsencode(self.folder), os.fsencode(name))
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return name

    def shown(self, *arguments, environment=None, text=None):
        """What a command prints, which may be asked for anything, and says something of it."""
        result = subprocess.run([KFAST, *arguments], cwd=self.folder, capture_output=True, timeout=120, input=text,
                                env={**os.environb, **(environment or {})})
        self.assertGreaterEqual(result.returncode, 0, f"{arguments}: {result.stderr}")
        for stream in (result.stdout, result.stderr):
            self.assertIsNone(OBEYED.search(stream.decode()), f"{arguments}: {stream}")
        everything = (result.stdout + result.stderr).decode()
        self.assertTrue(everything, f"{arguments}")
        return everything

    def evil(self, *arguments, code="<U+001B>", **more):
        self.assertIn(code, self.shown(*arguments, **more), f"{arguments}")

    def named(self):
        """A compiled scene whose names could not come from a scene text."""
        self.write("named.kfast", NAMED)
        self.run_kfast("compile", "named.kfast", "-o", "named.kfb")
        scene = bytearray((self.folder / "named.kfb").read_bytes())
        for letter in b"ABCD":
            scene = scene.replace(bytes([letter]) * 12, EVIL.encode()[:11] + bytes([letter]))
        scene[4:8] = zlib.crc32(scene[8:]).to_bytes(4, "little")
        return self.write("named.kfb", bytes(scene))


class FileNameTest(VisibleTest):
    def test_files_that_there_are_not(self):
        for command in ("check", "compile", "info", "render", "hash", "fit", "import", "preview", "export", "uf2", "play",
                        "upload", "flash", "live", "config", "wiring", "panel", "man"):
            self.shown(command, EVIL_BYTES)
            self.shown(command, EVIL_BYTES, "-o", b"no/" + EVIL_BYTES)
            self.shown(command, "once.kfast", "-o", b"no/" + EVIL_BYTES)

    def test_files_with_such_names(self):
        name = EVIL_BYTES + b".kfast"
        whole = (self.folder / "once.kfast").read_text()
        for content in ("", "\0", "kfast 1", "KFB", "<svg", "{}", SVG.format(evil="a", tag="b"), whole):
            self.write(name, content)
            for command in ("check", "info", "fit", "hash"):
                self.shown(command, name)
            self.shown("check", "--json", name)
        self.evil("compile", "once.kfast", "-o", EVIL_BYTES + b".kfb")
        self.evil("info", EVIL_BYTES + b".kfb")
        self.evil("render", "once.kfast", "-o", EVIL_BYTES + b".png")
        self.evil("render", "once.kfast", "--all", "-o", EVIL_BYTES)
        self.evil("render", "once.kfast", "--all", "-o", EVIL_BYTES + b".mp4")
        self.evil("export", "once.kfast", "--header", "-o", EVIL_BYTES + b".h")
        self.evil("new", EVIL_BYTES + b".kfast")
        self.evil("config", "pico-ssd1306-i2c", "-o", EVIL_BYTES + b".bin")

    def test_json_means_what_it_meant(self):
        self.write(EVIL + ".kfast", (self.folder / "once.kfast").read_bytes())
        self.assertEqual(json.loads(self.shown("info", "--json", EVIL + ".kfast"))["file"], EVIL + ".kfast")
        self.assertEqual(json.loads(self.shown("check", "--json", EVIL + ".kfast"))["files"][0]["file"], EVIL + ".kfast")


class ContentTest(VisibleTest):
    def test_names_in_a_compiled_scene(self):
        name = self.named()
        for command in (("info",), ("info", "--tracks"), ("fit",), ("check",), ("hash",), ("fit", "--board", "pico")):
            self.shown(*command, name)
        self.evil("info", name)
        self.assertEqual(json.loads(self.shown("info", "--json", name))["clips"][0]["name"], EVIL.encode()[:11].decode() + "C")
        self.evil("render", name, "--clip", "none", "-o", "a.png")
        self.evil("render", name, "--input", "none=1", "-o", "a.png")
        self.shown("preview", name, "--headless", "--frames", "9")
        self.shown("render", name, "--sheet", "4", "-o", "a.png")
        self.shown("export", name, "--header", "-o", "a.h")

    def test_scene_texts(self):
        for text in (f'kfast 1\ncanvas 60 40\nobject "{ESCAPED}" fill=red {{ rect 90 0 9 9 }}\n',
                     f'kfast 1\ncanvas 60 40\nobject a fill="{ESCAPED}" {{ path "{ESCAPED}"; text "{ESCAPED}" font="{ESCAPED}" }}\n',
                     f'kfast 1\ncanvas 60 40\n"{ESCAPED}" "{ESCAPED}"="{ESCAPED}" {{ "{ESCAPED}" }}\n',
                     f'kfast 1\ncanvas 60 40 {EVIL} fps={EVIL}\n', f'kfast 1\ncanvas 60 40 "\\{EVIL}"\n', f"{EVIL}", f"kfast {EVIL}",
                     f'kfast 1\ncanvas 60 40\nsymbol s {{ }}\nuse "{ESCAPED}"\nobject a fill=red skin="{ESCAPED}" {{ }}\n'):
            self.write(EVIL + ".kfast", text)
            for command in ("check", "compile", "info", "fit"):
                self.shown(command, EVIL + ".kfast")
            self.shown("check", "--json", EVIL + ".kfast")
            self.write("bytes.kfast", text.encode() + EVIL_BYTES)
            self.shown("check", "bytes.kfast")
            self.shown("check", "-", "--stdin-filename", EVIL, text=text.encode())

    def test_drawings_of_other_programs(self):
        entities = "".join(f"&#{ord(letter)};" for letter in EVIL)
        lottie = {"v": "5.5.7", "fr": 30, "ip": 0, "op": 30, "w": 60, "h": 40, "nm": EVIL, "layers": [
            {"ty": 4, "nm": EVIL, "ip": 0, "op": 30, "st": 0, "ks": {"p": {"a": 0, "k": [0, 0], "x": EVIL}},
             "ef": [{"nm": EVIL, "ty": 99}], "shapes": [{"ty": EVIL, "nm": EVIL}, {"ty": "gr", "nm": EVIL, "it": [
                 {"ty": "rc", "nm": EVIL, "p": {"a": 0, "k": [5, 5]}, "s": {"a": 0, "k": [9, 9]}, "r": {"a": 0, "k": 0}},
                 {"ty": "fl", "nm": EVIL, "c": {"a": 0, "k": [1, 0, 0, 1]}, "o": {"a": 0, "k": 100}}, {"ty": "tr"}]}]},
            {"ty": 77, "nm": EVIL, "ip": 0, "op": 30}], "markers": [{"cm": EVIL, "tm": 3, "dr": 9}]}
        files = {"a.svg": SVG.format(evil=EVIL, tag="b"), "b.svg": SVG.format(evil=entities, tag="b"),
                 "c.svg": SVG.format(evil="\x9b2J\r\u202e", tag="b\u202e"), "a.json": json.dumps(lottie, ensure_ascii=False),
                 "b.json": json.dumps(lottie), "c.json": '{"layers": [' + EVIL,
                 "a.sif": f'<canvas version="1.2" width="60" height="40"><name>{EVIL}</name><layer type="\u202e\x9b"/></canvas>'}
        for name, content in files.items():
            self.write(name, content)
            for command in (("check",), ("check", "--strict"), ("info", "--tracks"), ("check", "--json"), ("import", "-o", "-"),
                            ("import", "--json", "-o", "made.kfast"), ("import", "-o", "made.kfast")):
                self.shown(*command[:1], name, *command[1:])
        self.run_kfast("import", "b.json", "-o", "made.kfast")
        self.shown("check", "made.kfast")

    def test_drives_of_boards(self):
        (self.folder / EVIL).mkdir()
        images = self.folder / "images"
        images.mkdir()
        for number, bus in enumerate(("spi", "i2c", "parallel", "xy")):
            (images / f"pico-{bus}.bin").write_bytes(firmware(5000 + number, mark=b"KFPI" + bytes([number, 0, 0, 0])))
        environment = {b"KFAST_FIRMWARE": os.fsencode(images)}
        for drive in ("drive", EVIL):
            os.makedirs(self.folder / drive, exist_ok=True)
            self.write(f"{drive}/INFO_UF2.TXT", b"UF2 Bootloader v3.0\nModel: " + EVIL_BYTES + b"\nBoard-ID: " + EVIL_BYTES + b"\n")
            self.evil("flash", "--drive", drive, "--no-wait", environment=environment)

    def test_files_of_settings_and_boards(self):
        for evil in (EVIL, ESCAPED, f'"{ESCAPED}"'):
            self.write("a.kdl", CONFIGURATION.format(evil=evil))
            self.write("b.kdl", f'kfast-board 1\nname "{evil}"\n"{evil}" {evil}\n')
            for arguments in (("config", "a.kdl"), ("wiring", "a.kdl"), ("flash", "--config", "a.kdl", "--dry-run"),
                              ("fit", "once.kfast", "--board", "a.kdl"), ("fit", "once.kfast", "--board", "b.kdl"),
                              ("render", "once.kfast", "--beam", "b.kdl", "-o", "a.png")):
                self.shown(*arguments)
        self.write("a.ild", b"ILDA\0\0\0\5" + EVIL.encode()[:8] + EVIL.encode()[:8] + b"\0\1\0\0\0\1\0\0"
                   + bytes(6) + b"\x80\0\0\0\0\0" [:2] + b"ILDA\0\0\0\5" + bytes(24))
        self.shown("info", "a.ild")
        self.write("a.uf2", EVIL_BYTES * 64)
        self.shown("uf2", "info", "a.uf2")


class ArgumentTest(VisibleTest):
    def test_commands_and_options(self):
        self.evil(EVIL)
        self.evil("uf2", EVIL)
        self.evil("--" + EVIL)
        commands = re.findall(r"(?m)^  ([a-z0-9-]+) ", self.run_kfast("--help").stdout)
        self.assertGreater(len(commands), 25)
        for command in commands:
            if command != "preview":
                self.shown(command, EVIL, EVIL, EVIL, EVIL)
            self.shown(command, "--" + EVIL)
            self.shown(command, b"--x" + EVIL_BYTES + b"=3")
            self.shown(command, "-" + EVIL)

    def test_values_of_options(self):
        for command in ("render", "fit", "info", "hash", "export", "compile", "import", "check", "flash", "play", "upload", "live",
                        "panel", "seek", "speed", "brightness", "slots", "config", "wiring", "devices", "new"):
            page = self.run_kfast(command, "--help").stdout
            options = re.findall(r"(?m)^  (?:-\w, )?(--[a-z-]+) [A-Z]", page)
            self.assertTrue(options, command)
            for option in options:
                self.shown(command, "once.kfast", option, EVIL_BYTES)

    def test_the_environment(self):
        for name in (b"KFAST_FIRMWARE", b"TMPDIR", b"PATH", b"EDITOR", b"HOME", b"TERM", b"LANG", b"KFAST_DEVICE"):
            environment = {name: EVIL.encode()}
            self.shown("flash", "--panel", "ssd1306", "--dry-run", "--port", "9-9.9.9", environment=environment)
            self.shown("render", "once.kfast", "--all", "-o", "a.mp4", environment=environment)
            self.shown("devices", environment=environment)

    def test_values_of_inputs_from_standard_input(self):
        self.shown("live", "once.kfast", "--device", "sim:" + EVIL, text=EVIL.encode())
        self.shown("check", "-", text=EVIL_BYTES)


class TerminalTest(VisibleTest):
    def on_a_terminal(self, *arguments, stream, status):
        text = self.written_to_a_terminal(*arguments, stream=stream, status=status).replace("\r\n", "\n")
        self.assertIsNotNone(OWN.search(text), text)
        self.assertIsNone(OBEYED.search(OWN.sub("", text)), text)

    def test_colours_are_our_own(self):
        self.write("evil.kfast", f'kfast 1\ncanvas 60 40\nobject "{ESCAPED}" {EVIL}\n')
        self.on_a_terminal("check", "evil.kfast", stream="stderr", status=1)
        self.on_a_terminal("check", "--help", stream="stdout", status=0)


if __name__ == "__main__":
    unittest.main()
