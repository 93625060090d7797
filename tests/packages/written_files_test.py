"""packages/install_written_files.cmake installs what a command writes for shells, man and editors: written_files_test.py <kfast>.
The pages and completions are those of a command that is made up; the words for editors are from kfast."""

import gzip
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "packages/install_written_files.cmake"
REAL = pathlib.Path(sys.argv.pop(1)).resolve()
KFAST = f"""#!/bin/sh
case "$1 $2" in
    "completions "*) echo "words for $2" ;;
    "man "*) mkdir -p "$2/man1" "$2/man5"; echo page >"$2/man1/kfast.1"; echo page >"$2/man5/kfast.5" ;;
    "schema "* | "--version "*) exec {REAL} "$@" ;;
    *) exit 1 ;;
esac
"""


class WrittenFiles(unittest.TestCase):
    def installed(self, prefix, command=KFAST):
        """The files below the prefix, with their texts."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            kfast = folder / "kfast"
            kfast.write_text(command)
            kfast.chmod(0o755)
            facts = {"KFAST": kfast, "BUILD": folder, "DATA": "share", "MANUAL": "share/man",
                     "PYTHON": sys.executable, "CMAKE_INSTALL_PREFIX": f"{folder}/{prefix}"}
            subprocess.run(["cmake", *(f"-D{key}={value}" for key, value in facts.items()), "-P", SCRIPT], check=True,
                           stdout=subprocess.DEVNULL, timeout=60)
            return {str(path.relative_to(folder / prefix)): path.read_bytes()
                    for path in (folder / prefix).rglob("*") if path.is_file()}

    def test_each_shell_finds_its_words_and_man_its_pages(self):
        files = self.installed("local")
        self.assertEqual({
            "share/bash-completion/completions/kfast", "share/zsh/site-functions/_kfast",
            "share/fish/vendor_completions.d/kfast.fish", "share/man/man1/kfast.1.gz", "share/man/man5/kfast.5.gz",
        }, {name for name in files if "/editors/" not in name})
        self.assertEqual(b"words for zsh\n", files["share/zsh/site-functions/_kfast"])
        self.assertEqual(b"page\n", gzip.decompress(files["share/man/man1/kfast.1.gz"]))

    def test_editors_find_their_files(self):
        files = self.installed("local")
        for name in "kfast.vsix", "vscode/package.json", "vim/ftdetect/kfast.vim":
            self.assertIn(f"share/kfast/editors/{name}", files)

    def test_zsh_has_another_folder_for_packages(self):
        self.assertIn("share/zsh/vendor-completions/_kfast", self.installed("usr"))

    def test_a_command_that_fails_is_no_installation(self):
        with self.assertRaises(subprocess.CalledProcessError):
            self.installed("local", KFAST.replace('echo "words for $2"', "exit 1"))


if __name__ == "__main__":
    unittest.main()
