"""The rules of udev, which go to a folder of the test; udevadm is a script that writes down how it was called."""

import os
import subprocess
import unittest

from command_case import KFAST, CommandTest

NO_PERMISSION = 4


class InstallUdevTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.rules = self.folder / "rules.d"
        self.rules.mkdir()
        self.programs = self.folder / "programs"
        self.programs.mkdir()

    def udevadm(self, status):
        program = self.programs / "udevadm"
        program.write_text(f'#!/bin/sh\necho "$@" >> "{self.folder}/calls"\nexit {status}\n')
        program.chmod(0o755)

    def install(self, *arguments, **more):
        path = f"{self.programs}:{os.environ['PATH']}"
        return self.run_kfast("install-udev", "--folder", self.rules, *arguments, environment={"PATH": path}, **more)

    def test_the_rules_are_written_and_udev_heeds_them(self):
        self.udevadm(0)
        told = self.install().stdout
        self.assertIn(f"{self.rules}/70-kfast.rules", told)
        self.assertEqual((self.rules / "70-kfast.rules").read_text(), self.run_kfast("devices", "--udev-rule").stdout)
        self.assertEqual((self.folder / "calls").read_text().splitlines(),
                         ["control --reload", "trigger --settle --subsystem-match=hidraw --subsystem-match=usb"])
        self.assertEqual(len(list(self.rules.iterdir())), 1)
        (self.rules / "70-kfast.rules").write_text("old")
        self.install()
        self.assertIn("hidraw", (self.rules / "70-kfast.rules").read_text())

    def test_a_udev_that_is_not_told_is_warned_of(self):
        self.udevadm(2)
        told = self.install()
        self.assertTrue((self.rules / "70-kfast.rules").exists())
        self.assertIn("warning: udev has not been told of the rules", told.stderr)
        self.assertIn("udevadm control --reload && udevadm trigger", told.stderr)

    def test_a_dry_run_writes_nothing(self):
        self.udevadm(0)
        told = self.install("--dry-run").stdout
        self.assertIn(self.run_kfast("devices", "--udev-rule").stdout, told)
        self.assertIn("70-kfast.rules", told)
        self.assertIn("udevadm control --reload", told)
        self.assertEqual(list(self.rules.iterdir()), [])
        self.assertFalse((self.folder / "calls").exists())

    def test_who_may_not_write_is_told_the_command(self):
        self.folder.chmod(0o755)
        self.rules.chmod(0o555)
        nobody = {"user": 65534} if os.geteuid() == 0 else {}
        result = subprocess.run([KFAST, "install-udev", "--folder", self.rules], stderr=subprocess.PIPE, text=True,
                                timeout=120, **nobody)
        self.assertEqual(result.returncode, NO_PERMISSION)
        self.assertIn(f"only root may write to {self.rules}:\n  sudo {KFAST} install-udev\n", result.stderr)
        self.assertEqual(list(self.rules.iterdir()), [])

    def test_a_folder_that_is_not_there(self):
        self.refuse("install-udev", "--folder", self.folder / "none", status=1, says="create the folder first")


if __name__ == "__main__":
    unittest.main()
