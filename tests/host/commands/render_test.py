"""What all kinds of files that kfast render makes have in common: names, options, lack of room, progress."""

import unittest

from render_case import RenderTest


class UsageTest(RenderTest):
    def test_names_and_options_that_do_not_fit(self):
        render = ["render", "repeat.kfast"]
        self.refuse(*render, "--all", "-o", "a.jpg", status=2, says="choose .png, .svg, .apng, .gif, .mp4, .webm")
        self.refuse(*render, "--frame", "1", "-o", "a.jpg", status=2, says="'.jpg' is no kind")
        for kind in ("apng", "gif", "mp4", "webm"):
            self.refuse(*render, "--frame", "1", "-o", f"a.{kind}", status=2, says=f"add --all for a .{kind}")
        self.refuse(*render, "--all", "--kind", "svg", "-o", "a.png", status=2, says="files in a folder")
        self.refuse(*render, "--all", "--kind", "pdf", "-o", "a", status=2, says="--kind")
        self.refuse(*render, "--all", "--loops", "2", "-o", "a.gif", status=2, says="it is for videos")
        self.refuse(*render, "--all", "--loops", "0", "-o", "a.mp4", status=2, says="--loops")
        self.refuse(*render, "--all", "--scale", "0", "-o", "a.gif", status=2, says="--scale")
        self.refuse(*render, "--contact", "--all", "-o", "a.png", status=2, says="--contact")

    def test_without_a_subject_the_ending_decides(self):
        for name in ("a.png", "a.svg", "a"):
            self.run_kfast("render", "repeat.kfast", "-o", name)
            self.run_kfast("render", "repeat.kfast", "--frame", "0", "-o", f"one-{name}")
            self.assertEqual((self.folder / name).read_bytes(), (self.folder / f"one-{name}").read_bytes())
        for name in ("a.gif", "a.apng"):
            self.run_kfast("render", "repeat.kfast", "-o", name)
            self.run_kfast("render", "repeat.kfast", "--all", "-o", f"all-{name}")
            self.assertEqual((self.folder / name).read_bytes(), (self.folder / f"all-{name}").read_bytes())
        self.refuse("render", "repeat.kfast", "--frame", "0", "-o", "b.gif", status=2, says="add --all for a .gif")
        self.refuse("render", "repeat.kfast", "--time", "", "-o", "b.png", status=2, says="'' is no time")
        self.refuse("render", "repeat.kfast", "--all", "--frame", "1", "-o", "b.png", status=2, says="--frame")

    def test_it_says_what_it_wrote(self):
        for arguments, says in ((("-o", "a.gif"), "10 frames, 60x40"), (("-o", "a.apng", "--scale", "2"), "10 frames, 120x80"),
                                (("-o", "a.png"), "1 frame, 60x40"), (("--all", "-o", "a.svg"), "10 frames, 60x40"),
                                (("-o", "a.png", "--size", "9x8"), "1 frame, 9x8"), (("--contact", "-o", "a.png"), "3 keys, 144x114"),
                                (("--sheet", "5", "-o", "a.png"), "10 frames and a.json, 300x80")):
            name = arguments[arguments.index("-o") + 1]
            said = self.run_kfast("render", "repeat.kfast", *arguments)
            self.assertEqual(said.stderr, "")
            size = (self.folder / name).stat().st_size
            self.assertEqual(said.stdout, f"{name}: {says}, " + (f"{size} bytes\n" if size < 1000 else f"{(size + 500) // 1000} KB\n"))
        said = self.run_kfast("render", "repeat.kfast", "--all", "-o", "all").stdout
        self.assertEqual(said, f"all: 10 files, 60x40, {sum(file.stat().st_size for file in (self.folder / 'all').iterdir()) / 1000:.0f} KB\n")

    def test_quiet_it_says_nothing(self):
        for command in (("render", "repeat.kfast", "-o", "a.gif"), ("compile", "repeat.kfast"), ("export", "--header", "repeat.kfast"),
                        ("export", "--ild", "repeat.kfast"), ("export", "--wav", "repeat.kfast"), ("config", "pico-st7789", "-o", "a.kdl"),
                        ("uf2", "pack", "--scene", "repeat.kfast", "-o", "a.uf2"), ("uf2", "unpack", "a.uf2", "-o", "u"), ("man", "m"),
                        ("new", "n.kfast", "--force")):
            self.assertNotEqual(self.run_kfast(*command).stdout, "", command)
            self.assertEqual(self.run_kfast(*command, "-q").stdout, "", command)
        (self.folder / "dot.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><circle r="4"/></svg>')
        self.assertEqual(self.run_kfast("import", "dot.svg", "--quiet").stdout, "")
        self.refuse("render", "nothing.kfast", "-o", "a.gif", "-q", status=1, says="no such file")

    def test_endings_in_capitals_and_folders_with_a_dot(self):
        self.render("repeat.kfast", "--all", "-o", "A.GIF")
        self.assertEqual((self.folder / "A.GIF").read_bytes()[:3], b"GIF")
        (self.folder / "v1.2").mkdir()
        for name in ("v1.2", "v1.3/"):
            self.render("repeat.kfast", "--all", "-o", name)
            self.assertEqual(len(list((self.folder / name).iterdir())), 10)

    def test_no_room(self):
        for name in ("full.apng", "full.png", "full.svg"):
            (self.folder / name).symlink_to("/dev/full")
            self.refuse("render", "repeat.kfast", "--all", "-o", name, status=1, says="make room")
        for name in ("a.apng", "a.svg"):
            self.refuse("render", "repeat.kfast", "--all", "-o", name, status=1, says="make room", limit=64)
        self.refuse("render", "repeat.kfast", "--sheet", "3", "-o", "a.png", status=1, says="make room", limit=64)

    def test_no_room_for_a_video(self):
        for name in ("a.mp4", "a.webm"):
            (self.folder / name).write_bytes(b"before")
            self.refuse("render", "repeat.kfast", "--all", "-o", name, status=1, says="ffmpeg failed", limit=512)
            self.assertEqual((self.folder / name).read_bytes(), b"before")

    def test_a_list_without_room_leaves_the_sheet_of_before(self):
        (self.folder / "old.json").mkdir()
        (self.folder / "old.png").write_bytes(b"before")
        self.refuse("render", "repeat.kfast", "--sheet", "3", "-o", "old.png", status=1, says="name a file, not a folder")
        self.assertEqual((self.folder / "old.png").read_bytes(), b"before")

    def test_panels_clips_and_beams(self):
        self.render("marked.kfast", "--clip", "blink", "--speed", "-1", "--all", "-o", "out.apng")
        shown = [pixels for _, pixels in self.pictures("out.apng")]
        self.assertEqual(shown, self.frames("marked.kfast", "--clip", "blink", "--speed", "-1"))
        self.render("marked.kfast", "--panel", "ssd1306", "--sheet", "5", "-o", "sheet.png")
        self.assertEqual(self.opened("sheet.png").size, (640, 128))
        self.render("marked.kfast", "--panel", "ssd1306", "--frame", "0", "-o", "out.svg")
        self.assertIn('viewBox="0 0 128 64"', (self.folder / "out.svg").read_text())
        self.render("marked.kfast", "--beam", "scope", "--size", "100x100", "--clip", "blink", "--all", "-o", "out.png")
        self.assertEqual(self.opened("out.png").size, (100, 100))

    def test_long_work_is_seen_on_a_terminal_alone(self):
        self.assertEqual(self.written_to_a_terminal("render", "repeat.kfast", "--all", "-o", "out.gif"), "")
        long = ["--speed", "0.01", "--size", "500x400", "--format", "rgb666"]
        written = self.written_to_a_terminal("hash", "repeat.kfast", *long)
        self.assertRegex(written, r"\rdrawing \[#* *\] +\d+ %  \d+ s left")
        self.assertRegex(written, r"\r +\r$")


if __name__ == "__main__":
    unittest.main()
