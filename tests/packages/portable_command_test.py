"""The portable tar, unpacked in a root that has nothing else: portable_command_test.py

The files are those of the build in build/; scripts/release makes the tar of them."""

import os
import pathlib
import shutil
import subprocess
import tarfile
import tempfile
import unittest

from assembled import ROOT, output_of

# Mounts of a namespace of its own are gone with the command.
NAMESPACE = ["unshare", "--mount", *([] if os.geteuid() == 0 else ["--map-root-user"])]
MOUNT = 'mount --rbind /proc "$1/proc" && mount --rbind /dev "$1/dev"'
ENTER = 'root=$1 && shift && exec chroot "$root" "$@"'


def may(*command):
    return subprocess.run(command, stderr=subprocess.DEVNULL, check=False).returncode == 0


MAY_MOUNT = may(*NAMESPACE, "mount", "--rbind", "/proc", "/proc")
ALONE = NAMESPACE if MAY_MOUNT else []  # root of a container may often enter a root, and mount nothing


@unittest.skipUnless(may(*ALONE, "chroot", "/", "true"), "neither root nor namespaces for users: no root can be entered")
class PortableCommand(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        cls.addClassCleanup(temporary.cleanup)
        folder = pathlib.Path(temporary.name)
        output_of(ROOT / "scripts/release", "portable", "--architecture", "amd64", "--no-build", "--folder", folder / "release")
        (cls.tar,) = (folder / "release").glob("*.tar.gz")
        cls.root = folder / "root"
        for name in "proc", "dev", "try":
            (cls.root / name).mkdir(parents=True)
        with tarfile.open(cls.tar) as tar:
            tar.extractall(cls.root)
        (cls.folder,) = cls.root.glob("kfast-*")
        shutil.copy(ROOT / "examples/robot-eyes.kfast", cls.root / "try/eyes.kfast")

    def kfast(self, *arguments, status=0, mount=MAY_MOUNT, **environment):
        """What it prints, started as /kfast-VERSION-linux-x86_64/kfast."""
        environment = {"PATH": os.environ["PATH"], **environment}
        script = f"{MOUNT} && {ENTER}" if mount else ENTER
        command = [*ALONE, "sh", "-c", script, "sh", self.root, f"/{self.folder.name}/kfast", *arguments]
        result = subprocess.run(command, capture_output=True, text=True, timeout=120, env=environment, check=False)
        self.assertEqual(status, result.returncode, result.stderr)
        return result.stdout + result.stderr

    def test_the_root_has_nothing_else(self):
        self.assertEqual({"proc", "dev", "try", self.folder.name}, {path.name for path in self.root.iterdir()})

    def test_tells_its_version(self):
        self.assertIn(self.folder.name.split("-")[1], self.kfast("--version"))

    def test_compiles_draws_and_measures(self):
        self.kfast("compile", "/try/eyes.kfast", "-o", "/try/eyes.kfb")
        self.assertIn("150 frames", self.kfast("info", "/try/eyes.kfb"))
        self.kfast("render", "/try/eyes.kfast", "-o", "/try/eyes.png")
        self.assertEqual(b"\x89PNG", (self.root / "try/eyes.png").read_bytes()[:4])
        self.assertIn("fits", self.kfast("fit", "/try/eyes.kfast", "--board", "pico"))

    def test_previews_in_the_terminal_and_without_a_display(self):
        self.assertIn("\x1b[", self.kfast("preview", "/try/eyes.kfast", "--terminal", "--loops", "1", TERM="xterm", COLUMNS="80"))
        self.kfast("preview", "/try/eyes.kfast", "--headless", "--press", "n q")

    def test_draws_in_a_window_without_drivers_of_graphics_cards(self):
        said = self.kfast("preview", "/try/eyes.kfast", "--loops", "1", SDL_VIDEODRIVER="dummy", XDG_RUNTIME_DIR="/try")
        self.assertNotIn("error", said)

    def test_finds_its_firmware_and_names_itself(self):
        said = self.kfast("flash", "/try/eyes.kfast", "--panel", "st7789", "--dry-run")
        self.assertIn("firmware of ", said)
        for mount in {MAY_MOUNT, False}:
            listed = self.kfast("config", "--list", mount=mount)
            self.assertIn(f"/{self.folder.name}/share/kfast/firmware/pico-spi.bin", listed)

    def test_has_the_licence_of_every_library(self):
        libraries = {path.name for path in (self.folder / "lib/kfast").glob("lib*")}
        texts = self.folder / "share/doc/kfast/libraries"
        listed = [line.split()[0] for line in (texts / "packages.txt").read_text().splitlines()]
        self.assertIn("libc.so.6", libraries)
        self.assertIn("libc6", listed)
        self.assertTrue((texts / "LGPL-2.1").is_file())
        for package in listed:
            self.assertGreater((texts / f"{package}.txt").stat().st_size, 100, package)

    def test_belongs_to_nobody_and_has_one_time(self):
        with tarfile.open(self.tar) as tar:
            entries = tar.getmembers()
        self.assertEqual({(0, 0)}, {(entry.uid, entry.gid) for entry in entries})
        self.assertEqual(1, len({entry.mtime for entry in entries}))
        self.assertEqual({self.folder.name}, {entry.name.split("/")[0] for entry in entries})


if __name__ == "__main__":
    unittest.main()
