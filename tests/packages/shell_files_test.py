"""packages/install_shell_files.cmake installs what a command writes for shells and man: here a command that is made up."""

import gzip
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "packages/install_shell_files.cmake"
KFAST = """#!/bin/sh
case "$1 $2" in
    "completions --help") ;;
    "completions "*) echo "words for $2" ;;
    "man "*) echo page >"$2/kfast.1"; echo page >"$2/kfast-new.1" ;;
    *) exit 1 ;;
esac
"""


class ShellFiles(unittest.TestCase):
    def installed(self, prefix, command=KFAST):
        """The files below the prefix, with their texts."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            kfast = folder / "kfast"
            kfast.write_text(command)
            kfast.chmod(0o755)
            facts = {"KFAST": kfast, "BUILD": folder, "DATA": "share", "MANUAL": "share/man",
                     "CMAKE_INSTALL_PREFIX": f"{folder}/{prefix}"}
            subprocess.run(["cmake", *(f"-D{key}={value}" for key, value in facts.items()), "-P", SCRIPT], check=True,
                           stdout=subprocess.DEVNULL, timeout=60)
            return {str(path.relative_to(folder / prefix)): path.read_bytes()
                    for path in (folder / prefix).rglob("*") if path.is_file()}

    def test_each_shell_finds_its_words_and_man_its_pages(self):
        files = self.installed("local")
        self.assertEqual({
            "share/bash-completion/completions/kfast", "share/zsh/site-functions/_kfast",
            "share/fish/vendor_completions.d/kfast.fish", "share/man/man1/kfast.1.gz", "share/man/man1/kfast-new.1.gz",
        }, set(files))
        self.assertEqual(b"words for zsh\n", files["share/zsh/site-functions/_kfast"])
        self.assertEqual(b"page\n", gzip.decompress(files["share/man/man1/kfast.1.gz"]))

    def test_zsh_has_another_folder_for_packages(self):
        self.assertIn("share/zsh/vendor-completions/_kfast", self.installed("usr"))

    def test_a_command_that_fails_is_no_installation(self):
        with self.assertRaises(subprocess.CalledProcessError):
            self.installed("local", KFAST.replace('echo "words for $2"', "exit 1"))


if __name__ == "__main__":
    unittest.main()
