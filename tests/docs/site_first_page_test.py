"""The site begins with the first screen of README.md and the list of all pages: scripts/site_first_page.py.

Where MkDocs is installed, it builds the site without a warning."""

import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest

from page import ROOT, blocks

sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
import site_first_page
import site_links

README = (ROOT / "README.md").read_text(encoding="utf-8")
INDEX = (ROOT / "docs/index.md").read_text(encoding="utf-8")
LONGEST_SCREEN = 60  # lines: what is seen without much scrolling


def on_the_site(markdown, name):
    """What the hooks make of a page, in the order in which mkdocs.yml has them."""
    page = types.SimpleNamespace(file=types.SimpleNamespace(src_path=name))
    order = re.search(r"hooks: \[(.*)\]", (ROOT / "mkdocs.yml").read_text(encoding="utf-8")).group(1)
    assert order == "scripts/site_first_page.py, scripts/site_links.py"
    for hook in (site_first_page, site_links):
        markdown = hook.on_page_markdown(markdown, page=page, config={"repo_url": None}, files=None)
    return markdown


class SiteFirstPage(unittest.TestCase):
    def setUp(self):
        self.page = on_the_site(INDEX, "index.md")

    def test_it_begins_as_the_readme_does(self):
        self.assertTrue(self.page.startswith("# KFAST\n"))
        screen = README.partition(site_first_page.END)[0]
        self.assertLess(screen.count("\n"), LONGEST_SCREEN)
        self.assertEqual([block.text for block in blocks(self.page)], [block.text for block in blocks(screen)])

    def test_the_first_screen_says_what_for_whom_and_how(self):
        order = ["![", "\n- **", "    scripts/demo", "```kdl\n// hello.kfast"]
        places = [self.page.index(part) for part in order]
        self.assertEqual(places, sorted(places))
        reasons = re.findall(r"(?m)^- \*\*", self.page[places[1]:places[2]])
        self.assertEqual(len(reasons), 3)

    def test_the_list_of_pages_follows(self):
        pages = INDEX[INDEX.index("\n## "):]
        self.assertTrue(self.page.endswith(site_links.on_page_markdown(pages, config={"repo_url": None})))
        self.assertNotIn("](../", self.page)

    def test_its_links_and_pictures_are_on_the_site(self):
        targets = re.findall(r"\]\((?![a-z]+:|#)([^)#]+)", self.page)
        self.assertIn("pictures/animations.gif", targets)
        for target in targets:
            self.assertTrue((ROOT / "docs" / target).exists(), target)

    def test_links_of_the_readme_lead_from_docs(self):
        screen = "[a](docs/fit.md#speed) ![b](docs/pictures/b.gif) [c](examples/README.md) [d](https://kdl.dev) [e](#here)\n"
        self.assertEqual(site_first_page.first_screen(screen + site_first_page.END),
                         "[a](fit.md#speed) ![b](pictures/b.gif) [c](../examples/README.md) [d](https://kdl.dev) [e](#here)\n")
        with self.assertRaises(ValueError):
            site_first_page.first_screen(screen)

    def test_other_pages_stay_as_they_are(self):
        self.assertEqual(on_the_site("# Fit\n\n[a](fit.md)\n", "fit.md"), "# Fit\n\n[a](fit.md)\n")

    @unittest.skipUnless(shutil.which("mkdocs"), "needs mkdocs")
    def test_the_site_is_built_without_a_warning(self):
        with tempfile.TemporaryDirectory(prefix="kfast") as folder:
            result = subprocess.run(["mkdocs", "build", "--strict", "--site-dir", folder], cwd=ROOT, capture_output=True, text=True,
                                    check=False)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertNotIn("WARNING", result.stderr)


if __name__ == "__main__":
    unittest.main()
