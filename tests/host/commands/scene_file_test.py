"""Scenes and compiled scenes, good and bad, through the real command."""

import json
import os
import shutil
import unittest
import zlib

from command_case import ROOT, SCENE, CommandTest, kfast


class CompileTest(CommandTest):
    def test_writes_beside_the_scene_and_says_what(self):
        before = len(list(self.folder.iterdir()))
        line = self.run_kfast("compile", "repeat.kfast").stdout
        size = (self.folder / "repeat.kfb").stat().st_size
        self.assertRegex(line, rf"^repeat.kfb: {size} bytes, 10 frames, 1 object, \d+ bytes of memory at 60x40\n$")
        self.assertEqual(len(list(self.folder.iterdir())), before + 1)

    def test_writes_where_told(self):
        self.run_kfast("compile", "repeat.kfast", "-o", "other.bin")
        self.run_kfast("compile", "repeat.kfast")
        self.assertEqual((self.folder / "other.bin").read_bytes(), (self.folder / "repeat.kfb").read_bytes())

    def test_never_overwrites_its_input(self):
        self.refuse("compile", "repeat.kfast", "-o", "repeat.kfast", status=1, says="overwrite the scene itself")
        self.refuse("compile", "repeat.kfast", "-o", "./repeat.kfast", status=1, says="overwrite the scene itself")
        os.rename(self.folder / "repeat.kfast", self.folder / "text.kfb")
        self.refuse("compile", "text.kfb", status=1, says="overwrite the scene itself")

    def test_looks_for_fonts_beside_the_scene(self):
        inner = self.folder / "inner"
        inner.mkdir()
        shutil.copy("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", inner / "Sans.ttf")
        text = 'kfast 1\ncanvas 9 9\nobject o fill=red { text I at="1,8" size=8 font="Sans.ttf" }\n'
        for scene in (inner / "beside.kfast", self.folder / "above.kfast"):
            scene.write_text(text)
        self.run_kfast("check", "inner/beside.kfast")
        self.assertEqual(kfast("check", "beside.kfast", folder=inner).returncode, 0)
        self.refuse("check", "above.kfast", status=1, says="error: Sans.ttf: there is no such file")

    def test_takes_no_compiled_scene(self):
        self.compiled()
        self.refuse("compile", "repeat.kfb", status=1, says="compiled already")

    def test_unwritable_outputs(self):
        self.refuse("compile", "repeat.kfast", "-o", "none/a.kfb", status=1, says="create the folder first")
        self.refuse("compile", "repeat.kfast", "-o", ".", status=1, says="name a file, not a folder")
        self.refuse("compile", "repeat.kfast", "-o", "/dev/full", status=1, says="No space left")

    def test_a_full_disk_keeps_the_earlier_file(self):
        before = self.compiled()
        self.refuse("compile", "once.kfast", "-o", "repeat.kfb", status=1, says="make room", limit=50)
        self.assertEqual((self.folder / "repeat.kfb").read_bytes(), before)


class InputTest(CommandTest):
    COMMANDS = (["check"], ["info"], ["hash"], ["preview", "--headless"], ["render", "--all", "-o", "out"],
                ["compile", "-o", "out"])

    def everywhere(self, name, says):
        for command in self.COMMANDS:
            with self.subTest(command=command):
                self.refuse(*command, name, status=1, says=says)

    def write(self, name, content):
        (self.folder / name).write_bytes(content)
        return name

    def test_missing(self):
        self.everywhere("none.kfast", "none.kfast: there is no such file")

    def test_folder(self):
        self.everywhere(".", "this is a folder")

    def test_empty(self):
        self.everywhere(self.write("empty.kfast", b""), "empty.kfast: the file is empty")

    def test_binary(self):
        self.everywhere(self.write("binary.kfast", bytes(range(256)) * 9), "neither a scene nor a compiled scene")

    def test_utf_16(self):
        text = SCENE.format(loop="repeat")
        for number, encoding in enumerate(("utf-16", "utf-16-le", "utf-16-be")):
            name = self.write(f"wide{number}.kfast", text.encode(encoding))
            self.everywhere(name, "the text is in UTF-16: save it as UTF-8")
        self.run_kfast("check", self.write("marked.kfast", text.encode("utf-8-sig")))

    def test_huge(self):
        with open(self.folder / "huge.kfast", "wb") as file:
            file.truncate((16 << 20) + 1)
        self.everywhere("huge.kfast", "larger than 16 MB")

    def test_huge_text(self):
        good = SCENE.format(loop="repeat").encode()
        self.run_kfast("check", self.write("largest.kfast", good.ljust(4 << 20)))
        self.everywhere(self.write("larger.kfast", good.ljust((4 << 20) + 1)), "a text larger than 4 MB")

    def test_wrong_text(self):
        text = SCENE.format(loop="repeat").replace("rect 40", "rekt 40")
        self.everywhere(self.write("wrong.kfast", text.encode()), "wrong.kfast:5:")

    def test_truncated(self):
        self.everywhere(self.write("short.kfb", self.compiled()[:-5]), "breaks off before its end")
        self.everywhere(self.write("shorter.kfb", b"KFB"), "breaks off before its end")

    def test_newer(self):
        scene = self.compiled()
        scene[3] = 9
        self.everywhere(self.write("newer.kfb", scene),
                        "newer.kfb: made by a newer kfast (format 9, this one reads 3): update kfast, or compile")

    def test_damaged(self):
        scene = self.compiled()
        scene[-1] ^= 1
        self.everywhere(self.write("damaged.kfb", scene), "damaged on the way")

    def test_contradicting(self):
        scene = self.compiled()
        at = 8
        for _ in range(2):  # behind the size and the bytes for outlines
            while scene[at] & 0x80:
                at += 1
            at += 1
        scene[at] |= 0x80  # a bit without a meaning
        scene[4:8] = zlib.crc32(scene[8:]).to_bytes(4, "little")
        self.everywhere(self.write("bad.kfb", scene), "contradicts itself")

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_unreadable(self):
        (self.folder / "repeat.kfast").chmod(0)
        self.everywhere("repeat.kfast", "you may not read it")

    def test_the_content_decides_what_a_file_is(self):
        self.run_kfast("compile", "repeat.kfast", "-o", "binary.kfast")
        os.rename(self.folder / "repeat.kfast", self.folder / "text.kfb")
        self.assertEqual(self.run_kfast("hash", "binary.kfast").stdout, self.run_kfast("hash", "text.kfb").stdout)


class CheckTest(CommandTest):
    def test_a_good_scene(self):
        self.assertRegex(self.run_kfast("check", "repeat.kfast").stdout, r"^repeat.kfast: ok: .*, 0 warnings\n$")

    def test_warnings_are_counted_and_do_not_fail(self):
        path = self.folder / "repeat.kfast"
        path.write_text(path.read_text().replace("key 10 ", "key 10 law=accelerate "))
        result = self.run_kfast("check", "repeat.kfast")
        self.assertIn(", 1 warning\n", result.stdout)
        self.assertIn("repeat.kfast:6:12: warning: ", result.stderr)
        self.assertNotIn("\x1b", result.stderr, "colour is for terminals")

    def test_all_errors_in_one_run(self):
        path = self.folder / "repeat.kfast"
        path.write_text(path.read_text().replace("rect", "rekt"))
        self.refuse("check", "repeat.kfast", status=1, says="kfast: repeat.kfast: 3 errors")


class InfoTest(CommandTest):
    def test_json(self):
        facts = json.loads(self.run_kfast("info", "repeat.kfast", "--json").stdout)
        memory = facts.pop("memory")
        self.assertEqual(facts, {
            "file": "repeat.kfast", "bytes": len(self.compiled()), "canvas": {"width": 60, "height": 40}, "fps": 30,
            "frames": 10, "pictures": 10, "seconds": 10 / 30, "loop": "repeat", "objects": 1, "wire_frames": 0, "items": 1, "symbols": 0,
            "keys": [0, 4, 10], "features": ["tweens"], "inputs": [], "clocks": [], "clips": [], "events": []})
        self.assertEqual((memory["width"], memory["height"]), (60, 40))

    def test_symbols_clips_and_events(self):
        scene = ROOT / "examples" / "robot-eyes.kfast"
        facts = json.loads(self.run_kfast("info", scene, "--json").stdout)
        self.assertEqual((facts["objects"], facts["items"], facts["symbols"]), (1, 4, 1))
        self.assertEqual(facts["clips"][0], {"name": "blink", "from": 8, "to": 18, "loop": "once"})
        self.assertEqual([clip["name"] for clip in facts["clips"]], ["blink", "look", "happy", "angry"])
        self.assertEqual(facts["events"], [{"name": "blinked", "at": 13}])
        self.assertIn(20, facts["keys"], "the keys of a group count too")
        text = self.run_kfast("info", scene).stdout
        self.assertRegex(text, r"clip +angry: frames 85 to 146, once\n")
        self.assertRegex(text, r"event +blinked: frame 13\n")

    def test_text(self):
        text = self.run_kfast("info", "ping-pong.kfast", "--panel", "ssd0323").stdout
        self.assertRegex(text, r"loop +ping-pong\n")
        self.assertRegex(text, r"keys +3, at frames 0 4 10\n")
        self.assertRegex(text, r"memory +\d+ bytes for a panel of 128x64\n")

    def test_wire_frames(self):
        scene = ROOT / "examples" / "jitterbug.kfast"
        facts = json.loads(self.run_kfast("info", scene, "--json").stdout)
        self.assertEqual((facts["objects"], facts["wire_frames"]), (3, 3))
        self.assertRegex(self.run_kfast("info", scene).stdout, r"objects +3, 3 wire frames among them\n")

    def with_marks(self):
        (self.folder / "marks.kfast").write_text("""kfast 1
canvas 60 40 fps=30 frames=40
symbol wheel { object rim stroke=white { circle 0 0 r=9; key 3 rotate=0; key 7 rotate=90 } }
group car { use wheel 10 10; use wheel 40 10 { key 0 x=40; key 12.5 x=50 } }
clip go from=2.5 to=30 loop=ping-pong
event 5 "a b"
event 5 stop
""")
        return "marks.kfast"

    def test_json_of_symbols_and_marks(self):
        facts = json.loads(self.run_kfast("info", self.with_marks(), "--json").stdout)
        self.assertEqual((facts["objects"], facts["items"], facts["symbols"]), (1, 4, 1))
        self.assertEqual(facts["keys"], [0, 3, 7, 12.5])
        self.assertEqual(facts["clips"], [{"name": "go", "from": 2.5, "to": 30, "loop": "ping-pong"}])
        self.assertEqual(facts["events"], [{"name": "a b", "at": 5}, {"name": "stop", "at": 5}])

    def test_text_of_symbols_and_marks(self):
        text = self.run_kfast("info", self.with_marks()).stdout
        self.assertRegex(text, r"objects +1\n +items +4\n +symbols +1\n")
        self.assertRegex(text, r"clip +go: frames 2.5 to 30, ping-pong\n +event +a b: frame 5\n +event +stop: frame 5\n")


if __name__ == "__main__":
    unittest.main()
