"""scripts/debian_packages.py, with sources of packages that are folders. Needs no network."""

import hashlib
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

from debian_packages import DebianPackages, Failure, unpack  # noqa: E402 (lies there)

CONTROL = "Package: {name}\nVersion: 1.5\nArchitecture: all\nMaintainer: nobody\nDescription: a lamp\n"


class DebianPackagesTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.archive = self.folder / "archive"
        self.archive.mkdir()
        (self.archive / "Packages").touch()
        self.source = f"deb [trusted=yes] file:{self.archive} ./"

    def add(self, name, depends=""):
        content = self.folder / name
        (content / "DEBIAN").mkdir(parents=True)
        (content / "usr").mkdir()
        (content / "usr" / name).write_text("lit")
        control = CONTROL.format(name=name) + (f"Depends: {depends}\n" if depends else "")
        (content / "DEBIAN/control").write_text(control)
        file = self.archive / f"{name}.deb"
        subprocess.run(["dpkg-deb", "--build", str(content), str(file)], check=True, stdout=subprocess.DEVNULL)
        digest = hashlib.sha256(file.read_bytes()).hexdigest()
        with (self.archive / "Packages").open("a") as index:
            index.write(f"{control}Filename: ./{file.name}\nSize: {file.stat().st_size}\nSHA256: {digest}\n\n")

    def debian(self, source=None):
        return DebianPackages(self.folder / "apt", source=source or self.source)

    def refusal(self, debian, package):
        with self.assertRaises(Failure) as refused:
            debian.download(self.folder / "packages", package)
        return str(refused.exception)

    def test_a_package_and_what_it_needs_are_downloaded_and_unpacked(self):
        self.add("wick")
        self.add("lamp", depends="wick")
        debian = self.debian()
        packages = debian.with_dependencies("lamp")
        self.assertEqual(sorted(packages), ["lamp=1.5", "wick=1.5"])
        for package in debian.download(self.folder / "packages", *packages):
            unpack(package, self.folder / "root")
        self.assertEqual(sorted(file.name for file in (self.folder / "root/usr").iterdir()), ["lamp", "wick"])

    def test_what_is_missing_from_a_source_that_answers(self):
        said = self.refusal(self.debian(), "lamp")
        self.assertIn("apt-get download: E: Unable to locate package lamp", said)
        self.assertNotIn("network", said)

    def test_a_source_that_does_not_answer_is_the_reason(self):
        gone = self.folder / "gone"
        said = self.refusal(self.debian(f"deb [trusted=yes] file:{gone} ./"), "lamp")
        self.assertRegex(said, f"(?s)apt-get update: .*{gone}.*is the network there")

    def test_a_source_that_does_not_answer_does_not_matter_if_another_has_it(self):
        self.add("lamp")
        debian = self.debian(f"deb [trusted=yes] file:{self.folder / 'gone'} ./\n{self.source}")
        self.assertEqual(len(debian.download(self.folder / "packages", "lamp")), 1)


if __name__ == "__main__":
    unittest.main()
