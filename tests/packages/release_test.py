"""scripts/release, with parts that take little time: what it makes is whole, or nothing changes. release_test.py"""

import pathlib
import re
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

    def test_each_uf2_has_firmware_settings_and_scene(self):
        images = list(self.made.glob("*.uf2"))
        self.assertEqual(7, len(images))
        for image in images:
            with self.subTest(image=image.name):
                said = subprocess.run([ROOT / "build/host/bin/kfast", "uf2", "info", image], capture_output=True, text=True,
                                      check=True, timeout=60).stdout
                panel = image.stem.split("-pico-")[1].split("-")[0]
                self.assertIn("firmware for ", said)
                self.assertRegex(said, f"settings of .*{'beam' if panel == 'xy' else panel}")
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
        result = self.call("uf2", "--folder", folder, status=1)
        self.assertIn("diary.txt", result.stderr)
        self.assertEqual("", result.stdout, "nothing is built before")
        self.assertTrue((folder / "diary.txt").is_file())

    def test_warns_of_addresses_that_are_missing(self):
        warnings = self.call("arduino", "--dry-run").stderr
        facts = (ROOT / "packages/project.json").read_text()
        for name in "mail", "url":
            self.assertEqual(f'"{name}": null' in facts, f"packages/project.json has no {name} yet" in warnings)

    def test_a_part_that_there_is_not(self):
        result = self.call("portabel", status=2)
        self.assertIn("there is no part 'portabel': they are debian, portable, uf2", result.stderr)


class Arm64(unittest.TestCase):
    """What is made for another processor than this one, and cannot be started here."""

    @classmethod
    def setUpClass(cls):
        cls.folder = temporary_folder(cls)
        result = release("debian", "portable", "--architecture", "arm64", "--no-build", "--folder", cls.folder / "made")
        if result.returncode != 0:
            raise AssertionError(result.stderr)
        (cls.package,) = (cls.folder / "made").glob("*.deb")
        (tar,) = (cls.folder / "made").glob("*.tar.gz")
        subprocess.run(["tar", "-xf", tar, "-C", cls.folder], check=True, timeout=60)
        (cls.unpacked,) = cls.folder.glob("kfast-*")

    def output_of(self, *command):
        return subprocess.run([*map(str, command)], capture_output=True, text=True, check=True, timeout=60).stdout

    def test_the_package_is_for_it_and_depends_on_its_libraries(self):
        self.assertEqual("arm64\n", self.output_of("dpkg-deb", "--field", self.package, "Architecture"))
        depends = self.output_of("dpkg-deb", "--field", self.package, "Depends").strip().split(", ")
        named = {dependency.split()[0]: dependency for dependency in depends}
        self.assertGreaterEqual(set(named), {"libc6", "libstdc++6", "libpng16-16", "libusb-1.0-0", "libgpiod2"})
        self.assertFalse([name for name in named if "sdl" in name or ":" in name])
        self.assertRegex(named["libc6"], r"\(>= 2\.36\)")
        self.assertRegex(named["libstdc++6"], r"\(>= 12")

    def test_the_package_has_what_that_for_this_processor_has(self):
        files = self.output_of("dpkg-deb", "--contents", self.package)
        for name in ("usr/bin/kfast", "usr/share/kfast/firmware/pico-spi.bin", "usr/share/man/man1/kfast.1.gz",
                     "usr/share/bash-completion/completions/kfast", "usr/lib/udev/rules.d/70-kfast.rules"):
            self.assertIn(f"./{name}\n", files)

    def test_the_tar_has_all_libraries_and_all_are_for_it(self):
        libraries = self.unpacked / "lib/kfast"
        for file in [*libraries.iterdir(), self.unpacked / "bin/kfast"]:
            self.assertIn("AArch64", self.output_of("readelf", "--file-header", file), file.name)
            needed = set(re.findall(r"NEEDED.*\[(.*)\]", self.output_of("readelf", "--dynamic", file)))
            missing = {name for name in needed if not (libraries / name).is_file()}
            self.assertLessEqual(missing, {"ld-linux-aarch64.so.1"}, file.name)  # which is ld.so there
        self.assertTrue((libraries / "ld.so").is_file())
        self.assertIn("glibc=", (self.unpacked / "share/doc/kfast/libraries/packages.txt").read_text())


if __name__ == "__main__":
    unittest.main()
