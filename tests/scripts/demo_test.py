"""scripts/demo on a pretended machine, whose builds put a kfast there that is built already:
demo_test.py <kfast-first-look> <kfast>"""

import os
import pathlib
import signal
import sys
import tempfile
import time
import unittest

from pretended_apt import PretendedMachine

FIRST_LOOK, KFAST = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
FILES = ("scripts/demo", "scripts/install", "examples/first-light.kfast", "CMakePresets.json")

CMAKE = f"""
echo "cmake $*" >>"$CALLS"
case "$*" in
*--build*first-look*) sleep "${{BUILD_SECONDS:-0}}"; mkdir -p build/host/bin; ln -sf {FIRST_LOOK} build/host/bin/kfast-first-look ;;
*--build*command*) ln -sf {KFAST} build/host/bin/kfast ;;
*--build*) mkdir -p build/demo-board; touch build/demo-board/lm3s6965evb-cortex-m3.elf ;;
esac
"""

# The emulated board is tested by tests/emulation; here it shows what the preview shows.
BOARD_TEST = """
import pathlib, subprocess, sys
image, scene, kfast, keep, folder = sys.argv[1:]
assert keep == "--keep" and pathlib.Path(image).is_file() and pathlib.Path(scene).is_file()
subprocess.run([kfast, "render", scene, "--panel", "ssd0323", "--all", "-o", folder], check=True)
print("board and preview agree")
"""


class DemoTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        folder = pathlib.Path(temporary.name)
        self.machine = PretendedMachine(folder, FILES, {"cmake": CMAKE})
        (folder / "tests/emulation").mkdir(parents=True)
        (folder / "tests/emulation/board_test.py").write_text(BOARD_TEST, encoding="utf-8")
        self.hidden = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "TERM": "dumb", "SDL_VIDEODRIVER": ""}

    def demo(self, **more):
        result = self.machine.run("scripts/demo", **self.hidden, **more)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        return result.stdout

    def expect_in_order(self, text, *parts):
        at = 0
        for part in parts:
            self.assertIn(part, text[at:], f"is missing, or too early, in:\n{text}")
            at = text.index(part, at) + len(part)

    def test_three_steps_lead_from_nothing_to_both_pictures(self):
        self.expect_in_order(self.demo(), "1 of 3", "  first-look ", "Installing", "three times", "2 of 3", "  command ", "  demo-board ",
                             "first-light.kfb", "board and preview agree", "3 of 3", "they agree in every pixel", "Next:",
                             "kfast preview examples/robot-eyes.kfast", "kfast new my.kfast", "kfast fit my.kfast --board pico")

    def test_the_scene_moves_before_anything_else_is_installed_or_built(self):
        self.demo()
        self.assertEqual(["cmake --preset first-look", "cmake --build --preset first-look", "cmake --preset demo-command",
                          "cmake --build --preset demo-command", "cmake --preset demo-board",
                          "cmake --build --preset demo-board"], self.machine.calls("cmake"))
        installed = self.machine.installed()
        self.assertLess(installed.index("libpng-dev"), min(installed.index("libsdl2-dev"), installed.index("gcc-arm-none-eabi")))
        self.assertFalse({"clang", "synfig", "nodejs"} & set(installed), "sets that the demo does not need")

    def test_what_comes_later_is_fetched_while_the_first_look_compiles(self):
        printed = self.demo(BUILD_SECONDS="3")
        self.expect_in_order(printed, "2 of 3", "  demo-board ", " 0 MB to fetch", "Installing")
        self.assertNotIn("Fetching", printed[printed.index("2 of 3"):])

    def test_a_second_time_nothing_is_installed(self):
        self.demo()
        self.assertNotIn("MB to fetch", self.demo())
        self.assertEqual([], self.machine.calls("apt-get"))

    def test_ctrl_c_says_that_it_goes_on(self):
        process = self.machine.begin("scripts/demo", BUILD_SECONDS="20", **self.hidden)
        deadline = time.monotonic() + 30
        while not self.machine.calls("cmake --build"):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        os.killpg(process.pid, signal.SIGINT)
        _, errors = process.communicate(timeout=30)
        self.assertEqual(130, process.returncode)
        self.assertIn("Stopped. scripts/demo goes on from there", errors)
        self.expect_in_order(self.demo(), "three times", "they agree")


if __name__ == "__main__":
    unittest.main()
