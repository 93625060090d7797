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
*--build*first-look*) sleep "${{BUILD_SECONDS:-0}}"; mkdir -p build/host/bin
    printf '#!/bin/bash\n%s "$@"; touch "$STATE/scene-shown"\n' {FIRST_LOOK} >build/host/bin/kfast-first-look
    chmod +x build/host/bin/kfast-first-look ;;
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
        self.expect_in_order(self.demo(), "1 of 3", "  first-look ", "Installing", "  command ", "three times", "2 of 3",
                             "  demo-board ", "first-light.kfb", "board and preview agree", "3 of 3", "they agree in every pixel", "Next:",
                             "kfast preview examples/robot-eyes.kfast", "kfast new my.kfast", "kfast fit my.kfast --board pico")

    def test_the_scene_moves_before_anything_else_is_installed_or_built(self):
        self.demo()
        self.assertEqual(["cmake --preset first-look", "cmake --build --preset first-look", "cmake --preset demo-command",
                          "cmake --build --preset demo-command", "cmake --preset demo-board",
                          "cmake --build --preset demo-board"], self.machine.calls("cmake"))
        installed = self.machine.installed()
        self.assertLess(installed.index("libpng-dev"), min(installed.index("libsdl2-dev"), installed.index("gcc-arm-none-eabi")))
        self.assertFalse({"clang", "synfig", "nodejs"} & set(installed), "sets that the demo does not need")

    def test_what_comes_later_is_installed_while_the_first_look_and_the_command_compile(self):
        printed = self.demo(BUILD_SECONDS="3")
        self.expect_in_order(printed, "in the background", "  command ", " MB to fetch", "three times", "2 of 3",
                             "in the background", "  demo-board ", " MB to fetch", "first-light.kfb")
        self.assertEqual(1, printed.count("Installing"), "the first look's alone is waited for")
        self.assertIn("Installing", (self.machine.folder / "build/demo/install-command.log").read_text(encoding="utf-8"))

    def test_what_is_not_yet_installed_is_waited_for(self):
        self.machine.has("slow-libsdl2-dev")
        process = self.machine.begin("scripts/demo", **self.hidden)
        self.machine.wait_for("scene-shown")
        (self.machine.state / "slow-libsdl2-dev").unlink()
        printed, errors = process.communicate(timeout=60)
        self.assertEqual(0, process.returncode, errors)
        self.expect_in_order(printed, "2 of 3", "Waiting for the packages", " s\n", "  demo-board ")

    def test_who_would_be_asked_for_a_password_waits_in_the_second_step(self):
        self.machine.has("asks-for-password")
        printed = self.demo(USER_NUMBER="1000")
        self.assertNotIn("in the background", printed)
        self.expect_in_order(printed, "2 of 3", "  command ", "Installing", "  demo-board ", "Installing")

    def test_other_users_install_in_the_background_by_one_call_of_sudo(self):
        self.demo(USER_NUMBER="1000")
        self.assertIn("sudo -n nice scripts/install demo-board", self.machine.calls("sudo")[-1])

    def test_a_failure_in_the_background_is_told_in_the_second_step(self):
        self.machine.has("too-large-libsdl2-dev")
        result = self.machine.run("scripts/demo", **self.hidden)
        self.assertEqual(1, result.returncode)
        self.expect_in_order(result.stdout, "three times", "2 of 3", "  command ", "Installing", "failed")
        self.assertIn("No space left on device", result.stderr)

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

    def test_ctrl_c_leaves_no_package_half_installed(self):
        self.machine.has("slow-libsdl2-dev")
        process = self.machine.begin("scripts/demo", BUILD_SECONDS="20", **self.hidden)
        self.machine.wait_for("installing-libsdl2-dev")
        for _ in range(2):
            os.killpg(process.pid, signal.SIGINT)
            time.sleep(0.5)
        self.assertIsNone(process.poll(), "it waits for dpkg")
        self.assertNotIn("libsdl2-dev", self.machine.installed())
        (self.machine.state / "slow-libsdl2-dev").unlink()
        printed, _ = process.communicate(timeout=30)
        self.assertEqual(130, process.returncode)
        self.assertIn("Waiting for the packages in the background", printed)
        self.assertIn("libsdl2-dev", self.machine.installed())
        self.expect_in_order(self.demo(), "three times", "they agree")


if __name__ == "__main__":
    unittest.main()
