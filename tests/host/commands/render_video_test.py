"""Videos that kfast render has ffmpeg make. A program of the test's own in its place tells what it is given:
render_video_test.py <kfast> <ffmpeg, or -NOTFOUND>."""

import json
import os
import signal
import subprocess
import sys
import time
import unittest

FFMPEG = sys.argv.pop()

from command_case import KFAST, ROOT
from render_case import RenderTest

sys.path.insert(0, str(ROOT / "tests" / "import"))
import compare_pictures

# Tells its arguments, and how much it reads; FAKE_FFMPEG says how it ends.
FAKE = """#!{python}
import json, os, sys
how = os.environ["FAKE_FFMPEG"]
if how == "deaf":
    sys.exit("first\\nlast words")
pictures = sys.stdin.buffer.read()
if how == "ill":
    print("\\n".join(f"line {{i}}" for i in range(20)), file=sys.stderr)
    sys.exit(3)
with open(sys.argv[-1], "wb") as output:
    output.write(json.dumps({{"arguments": sys.argv[1:], "bytes": len(pictures)}}).encode())
"""


class VideoTest(RenderTest):
    def fake(self, how):
        tools = self.folder / "tools"
        tools.mkdir(exist_ok=True)
        (tools / "ffmpeg").write_text(FAKE.format(python=sys.executable))
        (tools / "ffmpeg").chmod(0o755)
        return {"PATH": f"{tools}:{os.environ['PATH']}", "FAKE_FFMPEG": how}

    def given(self, *arguments):
        result = self.render(*arguments, environment=self.fake("well"))
        told = json.loads((self.folder / arguments[-1]).read_text())
        return told["arguments"], told["bytes"], result.stderr

    def test_what_ffmpeg_is_given(self):
        arguments, count, said = self.given("repeat.kfast", "--all", "--loops", "3", "-o", "out.mp4")
        self.assertEqual((count, said), (3 * 10 * 60 * 40 * 3, ""))
        command = " ".join(arguments)
        for part in ("-f rawvideo -pix_fmt rgb24 -video_size 60x40 -framerate 30 -i pipe:0", "-c:v libx264", "-pix_fmt yuv420p",
                     "-f mp4"):
            self.assertIn(part, command)
        arguments, count, _ = self.given("ping-pong.kfast", "--all", "--scale", "2", "-o", "out.webm")
        self.assertEqual(count, 20 * 120 * 80 * 3)
        self.assertIn("-c:v libvpx-vp9", " ".join(arguments))

    def test_closed_standard_files_are_no_pipes(self):
        environment = {**os.environ, **self.fake("well")}
        for closed in ([0], [1], [2], [0, 1, 2]):
            def close(numbers=closed):
                for number in numbers:
                    os.close(number)

            subprocess.run([KFAST, "render", "-q", "repeat.kfast", "--all", "-o", "out.mp4"], cwd=self.folder, env=environment,
                           preexec_fn=close, timeout=120, check=True)
            self.assertEqual(json.loads((self.folder / "out.mp4").read_text())["bytes"], 10 * 60 * 40 * 3)
            (self.folder / "out.mp4").unlink()

    def test_odd_sides_get_a_pixel(self):
        arguments, count, said = self.given("resting-once.kfast", "--all", "-o", "out.mp4")
        self.assertIn("-video_size 22x12 -framerate 2997/100", " ".join(arguments))
        self.assertEqual(count, 7 * 22 * 12 * 3)
        self.assertIn("sides of even length", said)

    def test_failures_leave_no_file(self):
        video = ["render", "repeat.kfast", "--all", "-o", "out.mp4"]
        environment = self.fake("ill")
        self.refuse(*video, status=1, says="line 19", environment=environment)
        self.assertNotIn("line 11\n", self.run_kfast(*video, status=1, environment=environment).stderr)
        environment = self.fake("deaf")
        self.refuse(*video, "--scale", "16", status=1, says="last words", environment=environment)
        self.refuse(*video, status=1, says="apt install ffmpeg", environment={"PATH": str(self.folder)})
        self.refuse("render", "repeat.kfast", "--all", "-o", "no/out.mp4", status=1, says="create the folder first")
        (self.folder / "old.mp4").write_text("old")
        self.refuse("render", "repeat.kfast", "--all", "-o", "old.mp4", status=1, says="line 19", environment=self.fake("ill"))
        self.assertEqual((self.folder / "old.mp4").read_text(), "old")

    def test_an_interruption_leaves_no_file(self):
        environment = {**os.environ, **self.fake("well")}
        player = subprocess.Popen([KFAST, "render", "repeat.kfast", "--all", "--loops", "1000", "--scale", "32", "-o", "out.mp4"],
                                  cwd=self.folder, env=environment)
        deadline = time.monotonic() + 60
        while not list(self.folder.glob(".kfast-*")) and time.monotonic() < deadline:
            time.sleep(0.01)
        player.send_signal(signal.SIGTERM)
        self.assertEqual(player.wait(timeout=60), -signal.SIGTERM)
        self.assertEqual([path.name for path in self.folder.iterdir() if path.suffix in (".mp4", ".tmp")], [])

    @unittest.skipUnless(os.access(FFMPEG, os.X_OK), "there is no ffmpeg")
    def test_a_true_video(self):
        (self.folder / "bin").mkdir()
        (self.folder / "bin/ffmpeg").symlink_to(FFMPEG)
        for name in ("out.mp4", "out.webm"):
            self.render("once.kfast", "--all", "--scale", "4", "-o", name, environment={"PATH": str(self.folder / "bin")})
            subprocess.run([FFMPEG, "-v", "error", "-i", name, "frame-%02d.png"], cwd=self.folder, check=True)
            self.assertEqual(len(list(self.folder.glob("frame-*.png"))), 11)
            for frame in (0, 7):
                self.render("once.kfast", "--frame", frame, "--scale", "4", "-o", "frame.png")
                difference = compare_pictures.compare(self.folder / f"frame-{frame + 1:02}.png", self.folder / "frame.png")
                self.assertEqual(difference.problems(), [], f"{name}: {difference}")
            for file in self.folder.glob("frame-*.png"):
                file.unlink()


if __name__ == "__main__":
    unittest.main()
