"""scripts/install on a pretended machine: install_test.py"""

import os
import pathlib
import re
import select
import signal
import tempfile
import unittest

from pretended_apt import ROOT, PretendedMachine

FILES = ("scripts/install", "tests/emulation/package.json", "tests/emulation/package-lock.json")
INSTALL = "scripts/install"


class InstallCase(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.machine = PretendedMachine(pathlib.Path(temporary.name), FILES)
        self.modules = self.machine.folder / "tests/emulation/node_modules"

    def install(self, *arguments, status=0, **more):
        result = self.machine.run(INSTALL, *arguments, **more)
        self.assertEqual(status, result.returncode, result.stdout + result.stderr)
        self.assertEqual([], list(self.machine.folder.glob("kfast-install*")), "logs are left behind")
        return result


class PackagesTest(InstallCase):
    def test_a_set_is_installed_with_its_figures_before(self):
        self.machine.has("lists")
        result = self.install("boards")
        self.assertRegex(result.stdout, r"(?m)^  boards +12 packages, +12 MB to fetch, +30 MB on the disk$")
        self.assertIn("Fetching 12 MB ... ", result.stdout)
        self.assertIn("Installing 12 packages ... ", result.stdout)
        self.assertIn("gcc-arm-none-eabi", self.machine.installed())
        self.assertNotIn("libsdl2-dev", self.machine.installed())
        self.assertEqual("", result.stderr, "debconf's line about apt-utils is not to be seen")

    def test_it_does_nothing_when_all_is_there(self):
        self.machine.has("lists")
        self.install("command", "boards")
        result = self.install("boards", "command")
        self.assertEqual(("", "", []), (result.stdout, result.stderr, self.machine.calls()))

    def test_without_a_set_all_are_installed(self):
        self.machine.has("lists", "knows-kernel")
        self.install()
        for package in ("libsdl2-dev", "gcc-arm-none-eabi", "dpkg-dev", "valgrind"):
            self.assertIn(package, self.machine.installed())
        self.assertEqual(["npm ci --silent"], self.machine.calls("npm"))

    def test_a_package_of_two_sets_counts_once(self):
        self.machine.has("lists")
        lines = re.findall(r"(?m)^  (\S+) +(\d+) packages", self.install("--dry-run", "boards", "demo-board").stdout)
        self.assertEqual([("boards", "12"), ("demo-board", "4")], lines)

    def test_the_command_needs_neither_compilers_of_boards_nor_programs_of_tests(self):
        self.machine.has("lists")
        self.install("command")
        self.assertFalse({"gcc-arm-none-eabi", "clang", "synfig", "qemu-system-arm"} & set(self.machine.installed()))

    def test_no_set_brings_the_large_library_that_images_are_not_linked_with(self):
        self.assertNotIn("libstdc++-arm-none-eabi-newlib", (ROOT / INSTALL).read_text(encoding="utf-8"))

    def test_a_dry_run_lists_and_installs_nothing(self):
        self.machine.has("lists")
        result = self.install("--dry-run", "boards")
        self.assertIn("gcc-arm-none-eabi libnewlib-dev", result.stdout)
        self.assertEqual([], self.machine.installed())
        self.assertEqual([], [line for line in self.machine.calls("apt-get") if "--print-uris" not in line])
        self.machine.has("all-installed")
        self.assertIn("All packages of these sets are installed: boards", self.install("--dry-run", "boards").stdout)

    def test_a_dry_run_does_not_ask_for_lists(self):
        self.assertIn("apt-get update", self.install("--dry-run", "boards", status=1).stderr)
        self.assertNotIn("update", " ".join(self.machine.calls("apt-get")))

    def test_lists_are_fetched_where_there_are_none(self):
        result = self.install("boards")
        self.assertIn("lists of packages, about 9 MB ... ", result.stdout)
        self.assertIn("gcc-arm-none-eabi", self.machine.installed())

    def test_what_was_fetched_is_not_fetched_again(self):
        self.machine.has("lists")
        self.install("--download", "boards")
        self.assertEqual([], self.machine.installed())
        result = self.install("boards")
        self.assertRegex(result.stdout, r"boards +12 packages, +0 MB to fetch")
        self.assertNotIn("Fetching", result.stdout)
        self.assertIn("gcc-arm-none-eabi", self.machine.installed())

    def test_lists_that_are_too_old_are_fetched_anew(self):
        self.machine.has("lists", "old-lists")
        result = self.install("boards")
        self.assertIn("lists of packages", result.stdout)
        self.assertIn("gcc-arm-none-eabi", self.machine.installed())

    def test_errors_of_dpkg_are_printed(self):
        self.machine.has("lists", "too-large-gcc-arm-none-eabi")
        result = self.install("boards", status=1)
        self.assertIn("No space left on device", result.stderr)
        self.assertNotIn("debconf", result.stderr)

    def test_an_installation_that_was_interrupted_is_completed_first(self):
        self.machine.has("lists", "half-installed")
        self.install("boards")
        self.assertIn("dpkg --configure -a", self.machine.calls("dpkg"))

    def test_other_users_install_through_sudo(self):
        self.machine.has("lists")
        result = self.install("boards", USER_NUMBER="1000")
        self.assertIn("through sudo", result.stdout)
        self.assertRegex(self.machine.calls("sudo")[-1], "^sudo setsid --wait env DEBIAN_FRONTEND=noninteractive .*apt-get")

    def printed_until(self, process, words):
        printed = b""
        while words.encode() not in printed:
            self.assertTrue(select.select([process.stdout], [], [], 30)[0], f"no '{words}' in {printed}")
            more = os.read(process.stdout.fileno(), 4096)
            self.assertTrue(more, f"no '{words}' in {printed}")
            printed += more
        return printed.decode()

    def test_a_stop_while_packages_are_installed_waits_for_dpkg(self):
        self.machine.has("lists", "slow-gcc-arm-none-eabi")
        process = self.machine.begin(INSTALL, "boards")
        out = self.printed_until(process, "Installing 12 packages ... ")
        self.machine.wait_for("installing-gcc-arm-none-eabi")
        os.killpg(process.pid, signal.SIGINT)
        out += self.printed_until(process, "stopping when they are installed")
        (self.machine.state / "slow-gcc-arm-none-eabi").unlink()
        out += process.communicate(timeout=30)[0]
        self.assertEqual(130, process.returncode, out)
        self.assertIn("stopping when they are installed", out)
        self.assertIn("gcc-arm-none-eabi", self.machine.installed())

    def test_without_npm_goes_on_with_a_note(self):
        self.machine.has("all-installed")
        result = self.install("--without-npm")
        self.assertIn("scripts/install command boards", result.stderr)
        self.assertEqual([], self.machine.calls())

    def test_wrong_usage(self):
        for arguments in (["--without"], ["comand"], ["--dry-run", ""]):
            result = self.install(*arguments, status=2)
            self.assertIn("usage: scripts/install", result.stderr)
            self.assertEqual([], self.machine.calls())


class EmulatorTest(InstallCase):
    def setUp(self):
        super().setUp()
        self.machine.has("lists", "all-installed", "knows-kernel")

    def test_modules_are_installed_once(self):
        for wanted in (["npm ci --silent"], []):
            self.install("emulator")
            self.assertEqual(wanted, self.machine.calls())
        self.assertTrue((self.modules / "package-lock.json").is_file())

    def test_a_failure_of_npm_is_told_in_a_sentence(self):
        self.machine.settings["NPM"] = "exit 7"
        result = self.install(status=1)
        self.assertEqual(["npm ci --silent"], self.machine.calls())
        self.assertIn("npm could not install rp2040js", result.stderr)
        self.assertIn("scripts/install command boards release tests", result.stderr)
        self.assertFalse(self.modules.exists())

    def test_apt_gets_its_lists_when_it_does_not_know_the_kernel(self):
        (self.machine.state / "knows-kernel").unlink()
        self.install("emulator")
        self.assertRegex(" ".join(self.machine.calls()), r"^apt-get .* update npm ci --silent$")

    def test_the_demo_needs_neither_npm_nor_tests(self):
        calls = re.findall(r"(?m)^(?:scripts/install|begin_install) (.+)", (ROOT / "scripts/demo").read_text(encoding="utf-8"))
        self.assertEqual({"first-look", "command", "demo-board"}, set(calls))


if __name__ == "__main__":
    unittest.main()
