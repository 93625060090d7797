"""Every link between the documents leads to a file, and to a heading that it has."""

import re
import unicodedata
import unittest

from page import ROOT, all_pages, prose

LINK = re.compile(r"!?\[(?:[^\]\[]|\[[^\]]*\])*\]\(([^()\s]+)\)")
HEADING = re.compile(r"^#+ +(.*?) *$")


def anchor(heading):
    """As code hosts and MkDocs make it of a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)|[`*]", r"\1", heading).lower()
    return re.sub(r"[^\w\- ]", "", text).strip().replace(" ", "-")


def site_anchor(heading):
    """As Python-Markdown makes it, which MkDocs uses."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)|[`*]", r"\1", heading)
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", plain).strip().lower())


def site_anchors(path):
    lines = prose(path.read_text(encoding="utf-8"))
    return {site_anchor(heading.group(1)) for heading in map(HEADING.match, lines) if heading}


def anchors(path):
    found = []
    for line in prose(path.read_text(encoding="utf-8")):
        heading = HEADING.match(line)
        if heading:
            name = anchor(heading.group(1))
            repeated = sum(other == name or re.fullmatch(re.escape(name) + r"-\d+", other) is not None for other in found)
            found.append(f"{name}-{repeated}" if repeated else name)
    return found


class Links(unittest.TestCase):
    def test_lead_somewhere(self):
        for path in all_pages():
            for number, line in enumerate(prose(path.read_text(encoding="utf-8")), 1):
                for target in LINK.findall(line):
                    if not re.match(r"[a-z]+:", target):
                        with self.subTest(place=f"{path.relative_to(ROOT)}:{number}", target=target):
                            self.look_at(path, target)

    def look_at(self, path, target):
        name, _, heading = target.partition("#")
        to = (path.parent / name).resolve() if name else path
        self.assertTrue(to.exists(), "there is no such file")
        self.assertTrue(to.is_relative_to(ROOT), "leads out of the project")
        if heading:
            self.assertIn(heading, anchors(to))
            if to.parent == ROOT / "docs":
                self.assertIn(heading, site_anchors(to), "the site has another name for it: change the heading")

    def test_each_picture_is_shown_and_can_be_made_anew(self):
        shown = {target for path in all_pages()
                 for target in re.findall(r"pictures/([\w-]+\.\w+)\)", path.read_text(encoding="utf-8"))}
        maker = (ROOT / "scripts/pictures").read_text(encoding="utf-8")
        made = re.findall(r'(?m)^    (?:\*\*\{)?f?"([\w{}-]+\.\w+)": lambda', maker)
        for path in (ROOT / "docs/pictures").iterdir():
            with self.subTest(picture=path.name):
                self.assertIn(path.name, shown)
                self.assertTrue(any(re.fullmatch(re.sub(r"\{\w+\}", "[\\\\w-]+", name), path.name) for name in made))

    def test_pages_are_found_from_the_first_one(self):
        index = "\n".join(prose((ROOT / "docs/index.md").read_text(encoding="utf-8")))
        listed = set(LINK.findall(index))
        of_the_site = re.findall(r"[\w-]+\.md", (ROOT / "mkdocs.yml").read_text(encoding="utf-8"))
        for path in (ROOT / "docs").glob("*.md"):
            if path.name != "index.md":
                self.assertIn(path.name, listed)
                self.assertIn(path.name, of_the_site)


if __name__ == "__main__":
    unittest.main()
