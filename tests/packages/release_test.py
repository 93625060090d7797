"""scripts/release, with parts that take little time: what it makes is whole, or nothing changes. release_test.py"""

import pathlib
import shutil
import subprocess
import unittest

from assembled import ROOT, temporary_folder

FAST = ["arduino", "esp-idf", "uf2"]


def release(*arguments, script=ROOT / "scripts/release"):
    return subprocess.run([script, *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False)


def planned(result):
    return [pathlib.Path(line).name for line in result.stdout.splitlines() if line.startswith("/")]


class Release(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = temporary_folder(cls)
        cls.made = cls.folder / "made"
        cls.result = release(*FAST, "--no-build", "--folder", cls.made)

    def call(self, *arguments, status=0):
        result = release(*arguments)
        self.assertEqual(status, result.returncode, result.stderr)
        return result

    def copied(self, name):
        folder = self.folder / name
        shutil.copytree(self.made, folder)
        return folder

    def expect_untouched(self, folder):
        self.assertEqual(sorted(path.name for path in self.made.iterdir()), sorted(path.name for path in folder.iterdir()))
        self.assertEqual([], list(self.folder.glob(".release-*")))

    def test_makes_the_files_that_it_announces(self):
        self.assertEqual(0, self.result.returncode, self.result.stderr)
        announced = self.call(*FAST, "--no-build", "--dry-run", "--folder", self.folder / "none")
        self.assertFalse((self.folder / "none").exists())
        self.assertEqual(sorted(planned(announced)), sorted(path.name for path in self.made.iterdir()))
        self.assertEqual([], list(self.folder.glob(".release-*")))

    def test_announces_what_it_would_build(self):
        plan = self.call("--dry-run").stdout
        for name in ("scripts/build pico\n", "scripts/build linux-arm64\n", "_arm64.deb", "-linux-x86_64.tar.gz", "SHA256SUMS"):
            self.assertIn(name, plan)
        self.assertNotIn("scripts/build", self.call("arduino", "--dry-run").stdout)
        self.assertNotIn("arm64", self.call("debian", "--architecture", "amd64", "--dry-run").stdout)

    def test_sums_are_those_of_all_files(self):
        subprocess.run(["sha256sum", "--check", "--strict", "--quiet", "SHA256SUMS"], cwd=self.made, check=True, timeout=60)
        lines = (self.made / "SHA256SUMS").read_text().splitlines()
        self.assertEqual(len(lines) + 1, len(list(self.made.iterdir())))

    def test_a_picture_moves_on_each_display_without_a_computer(self):
        images = list(self.made.glob("*.uf2"))
        self.assertEqual(7, len(images))
        for image in images:
            with self.subTest(image=image.name):
                said = subprocess.run([ROOT / "build/host/bin/kfast", "uf2", "info", image], capture_output=True, text=True,
                                      check=True, timeout=60).stdout
                panel = image.stem.split("-pico-")[1].split("-")[0]
                self.assertIn("firmware for ", said)
                self.assertRegex(said, f"settings of .*{'scope' if panel == 'xy' else panel}")
                self.assertIn("scene: ", said)

    def test_the_next_one_takes_its_place_as_a_whole(self):
        folder = self.copied("replaced")
        self.call("arduino", "--no-build", "--folder", folder)
        self.assertEqual(2, len(list(folder.iterdir())))

    def test_one_that_fails_changes_nothing(self):
        project = self.folder / "project"
        for name in ("core", "library", "packages", "examples", "scripts", "boards/pico/configurations"):
            shutil.copytree(ROOT / name, project / name)  # and no LICENSE
        folder = self.copied("kept")
        result = release("arduino", "--no-build", "--folder", folder, script=project / "scripts/release")
        self.assertEqual(1, result.returncode)
        self.assertIn("LICENSE", result.stderr)
        self.expect_untouched(folder)

    def test_files_of_others_are_not_replaced(self):
        folder = self.copied("shared")
        (folder / "diary.txt").write_text("dear diary")
        result = self.call("arduino", "--no-build", "--folder", folder, status=1)
        self.assertIn("diary.txt", result.stderr)
        self.assertTrue((folder / "diary.txt").is_file())

    def test_addresses_that_are_missing_are_told(self):
        told = self.call("arduino", "--dry-run").stderr
        facts = (ROOT / "packages/project.json").read_text()
        for name in "mail", "url":
            self.assertEqual(f'"{name}": null' in facts, f"packages/project.json has no {name} yet" in told)

    def test_a_part_that_there_is_not(self):
        result = self.call("portabel", status=2)
        self.assertIn("there is no part 'portabel': they are debian, portable, uf2", result.stderr)


if __name__ == "__main__":
    unittest.main()
