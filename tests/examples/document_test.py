"""Whatever the documents of the library show as code is code that is compiled: it stands in a file of examples/ as it is."""

import pathlib
import re
import textwrap
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = ["docs/library.md", "docs/packages.md", "packages/README.md"]
SOURCES = {".c", ".cpp", ".ino", ".txt", ".h"}
SNIPPET = re.compile(r"^```(c|cpp|cmake)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def runs_of_lines(text, count):
    lines = text.splitlines()
    for begin in range(len(lines) - count + 1):
        yield textwrap.dedent("\n".join(lines[begin:begin + count]))


def stands_in(snippet, text):
    wanted = textwrap.dedent(snippet).rstrip("\n")
    return wanted in runs_of_lines(text, wanted.count("\n") + 1)


class Document(unittest.TestCase):
    def test_shows_only_what_is_compiled(self):
        sources = [path.read_text(encoding="utf-8") for path in sorted((ROOT / "examples").rglob("*")) if path.suffix in SOURCES]
        for document in DOCUMENTS:
            snippets = SNIPPET.findall((ROOT / document).read_text(encoding="utf-8"))
            self.assertGreater(len(snippets), 0)
            for _, snippet in snippets:
                with self.subTest(document=document, snippet=snippet):
                    self.assertTrue(any(stands_in(snippet, source) for source in sources))

    def test_notices_a_difference(self):
        self.assertTrue(stands_in("b;\n    c;\n", "a;\n    b;\n        c;\n"))
        self.assertFalse(stands_in("b;\nd;\n", "a;\n    b;\n    c;\n"))


if __name__ == "__main__":
    unittest.main()
