"""`kfast schema`: the schema accepts what the compiler does, and both of its forms say the same."""

import json
import pathlib
import re
import subprocess
import tempfile
import unittest

import kdl_reader
import schema_check
from command_case import KFAST, ROOT, CommandTest

DOCUMENT = ROOT / "docs/scene-language.md"
BEGIN, END = "<!-- begin: kfast schema --markdown -->\n", "<!-- end -->"


def output_of(*arguments):
    return subprocess.run([KFAST, "schema", *arguments], check=True, capture_output=True, text=True, timeout=120).stdout


SCHEMA = json.loads(output_of("--json"))


def scenes():
    return [*sorted((ROOT / "examples").glob("*.kfast")), *sorted((ROOT / "examples/gallery").glob("*.kfast")), ROOT / "host/commands/templates/starter.kfast"]


class SchemaTest(CommandTest):
    def mistakes(self, text):
        return schema_check.mistakes(kdl_reader.read(text), SCHEMA)

    def test_examples_keep_to_it(self):
        self.assertGreater(len(scenes()), 8)
        for path in scenes():
            with self.subTest(path=path.name):
                self.assertEqual(self.mistakes(path.read_text(encoding="utf-8")), [])

    def test_misspelt_properties_are_found(self):
        """Whatever property of an example is written otherwise, the schema misses or refuses it."""
        for path in scenes():
            text = path.read_text(encoding="utf-8")
            for match in list(re.finditer(r"(?<=\s)([a-z-]+)=(?!=)", re.sub(r"//.*|\"[^\"\n]*\"", lambda m: "_" * len(m[0]),
                                                                          text)))[:40]:
                wrong = text[:match.start(1)] + "x" + text[match.start(1):]
                with self.subTest(path=path.name, property=match[1]):
                    self.assertTrue(any(f"no property x{match[1]}" in each for each in self.mistakes(wrong)))

    def test_variables_and_expressions_keep_to_it(self):
        self.assertEqual(self.mistakes('let a=1 b="a/2"; canvas a*9 9; object o fill=red { circle a "=b" r=a+b }'), [])
        for wrong in ("let a=#true", "let a=(s)1", "let a=2e9", "let 1"):
            self.assertNotEqual(self.mistakes(wrong), [], wrong)

    def test_scenes_are_refused(self):
        for wrong, mistake in (
                ("kfast 1; canvas 1 9000", "value"), ("kfast 1; canvas 9 9 fps=0", "fps=0"),
                ("object a fill=red { circle 1 1 r=-1 }", "r=-1"), ("object a fill=red { circle 1 1 }", "needs r"),
                ("object a { cirle 1 1 r=1 }", "no node cirle"), ("object a stroke=red cap=rond", "cap=rond"),
                ("object a b", "2 values"), ("group { key 0 { circle 1 1 r=1 } }", "no node circle"),
                ("clip a from=(h)1 to=2 loop=thrice", "loop=thrice"), ("bones b { bone a 1 1 9 9 tip=1 }", "tip=1"),
                ("object a fill=red { star 9 9 r=9 points=4.5 }", "points=4.5"), ("object a width=(s)3", "width=3")):
            with self.subTest(wrong=wrong):
                self.assertIn(mistake, " ".join(self.mistakes(wrong)))

    def test_the_kdl_form_says_the_same(self):
        (document,) = kdl_reader.read(output_of())
        self.assertEqual(document.name, "document")
        definitions = next(node for node in document.nodes if node.name == "definitions").nodes
        by_id = {node.properties["id"][1]: node for node in definitions}
        self.assertEqual(set(by_id), {node["id"] for node in SCHEMA["nodes"]})
        self.assertEqual([self.reference(node) for node in document.nodes if node.name == "node"], SCHEMA["outermost"])
        for node_id, definition in by_id.items():
            ways = [way for way in SCHEMA["nodes"] if way["id"] == node_id]
            with self.subTest(id=node_id):
                self.assertEqual([value for _, value in definition.arguments],
                                 [] if ways[0].get("any_name") else [ways[0]["name"]])
                self.compare_properties(definition, ways)
                inside = [self.reference(node) for each in definition.nodes if each.name == "children" for node in each.nodes]
                self.assertEqual(set(inside), {id for way in ways for id in way["nodes"]})

    def reference(self, node):
        return re.fullmatch(r'\[id="(.*)"\]', node.properties["ref"][1])[1]

    def compare_properties(self, definition, ways):
        stated = {node.arguments[0][1]: node for node in definition.nodes if node.name == "prop"}
        self.assertEqual(set(stated), {each["name"] for way in ways for each in way["properties"]})
        if len(ways) > 1:
            return
        for each in ways[0]["properties"]:
            rules = {node.name: node.arguments[0][1] for node in stated[each["name"]].nodes if node.arguments}
            self.assertEqual(rules.get("required", False), each.get("required", False))
            self.assertEqual(rules.get(">="), each.get("least"))
            self.assertEqual(rules.get("<="), each.get("most"))

    def test_the_kdl_form_is_kdl_to_the_compiler_as_well(self):
        (self.folder / "schema.kdl").write_text(output_of(), encoding="utf-8")
        self.refuse("check", "schema.kdl", status=1, says='a scene has no node "document"')

    def test_is_used_rightly(self):
        self.refuse("schema", "--json", "--markdown", status=2, says="--json")
        self.refuse("schema", "x", status=2, says="x")


class ReferenceTest(unittest.TestCase):
    """docs/scene-language.md cannot lie about what there is."""

    TEXT = DOCUMENT.read_text(encoding="utf-8")

    def test_has_the_tables_of_the_compiler(self):
        generated = self.TEXT[self.TEXT.index(BEGIN) + len(BEGIN):self.TEXT.index(END)]
        self.assertEqual(generated.strip(), output_of("--markdown").strip(),
                         "put what `kfast schema --markdown` prints between the marks")

    def prose(self):
        return self.TEXT[:self.TEXT.index(BEGIN)]

    def test_speaks_of_everything(self):
        """In words, not in the generated tables alone."""
        fenced = re.compile(r"```kdl\n.*?```", re.DOTALL)
        code = " ".join(fenced.findall(self.prose()) + re.findall(r"`([^`]+)`", fenced.sub("", self.prose())))
        known = set(re.findall(r"[A-Za-z][A-Za-z0-9-]*", code))
        wanted = {node["name"] for node in SCHEMA["nodes"] if not node.get("any_name")}
        for node in SCHEMA["nodes"]:
            for each in node["properties"]:
                wanted |= {each["name"], *each.get("words", [])}
            for kind in node["values"]["kinds"]:
                wanted |= set(kind.get("words", []))
        wanted |= {law.split("(")[0] for law in SCHEMA["laws"]} | set(SCHEMA["colours"]) | set(SCHEMA["fonts"])
        self.assertEqual(wanted - known, set())

    def rows(self):
        """(name, meaning, default) of the tables of properties."""
        for table in re.findall(r"^\| propert[^\n]*\n\|[-|]+\n((?:\|.*\n)+)", self.prose(), re.MULTILINE):
            for line in table.splitlines():
                cells = [cell.strip() for cell in line.strip("|").split(" | ")]
                for name in re.findall(r"`([^`]+)`", cells[0]):
                    yield name, cells[1].rstrip("| "), cells[2].rstrip("| ") if len(cells) > 2 else ""

    def test_names_no_property_that_there_is_not(self):
        names = {each["name"] for node in SCHEMA["nodes"] for each in node["properties"]}
        rows = list(self.rows())
        self.assertGreater(len(rows), 50)
        self.assertEqual({name for name, _, _ in rows} - names, set())

    def test_tells_the_right_ranges(self):
        """A range "A to B" in the row of a property is one that the compiler has for a property of that name."""
        checked = 0
        for name, meaning, _ in self.rows():
            range_text = re.search(r"(?<![\w.,])(−?[\d,.]*\d) to (−?[\d,.]*\d)(?!\w)", meaning)
            if not range_text:
                continue
            stated = tuple(float(end.replace("−", "-").replace(",", "")) for end in range_text.groups())
            known = {(each["least"], each["most"]) for node in SCHEMA["nodes"] for each in node["properties"]
                     if each["name"] == name and "least" in each}
            if not known:  # "from 0 to 720 it turns twice"
                continue
            checked += 1
            with self.subTest(property=name):
                self.assertIn(stated, known)
        self.assertGreater(checked, 15)

    def default_of(self, name):
        """As the reference has it: a number, or what stands in code."""
        for other, _, default in self.rows():
            plain = re.fullmatch(r"`([^`]+)`|(−?[\d.]+)", default)
            if other == name and plain:
                return (plain[1] or plain[2]).replace("−", "-")
        self.fail(f"the reference has no default of {name}")

    def test_tells_the_right_defaults(self):
        """A scene is the same with a property at its default as without it."""
        moving = "object o fill=red { key 0 { rect 1 1 9 9 }; key 9 { rect 5 5 9 9 } }"
        drawn = "object o stroke=red fill=blue { polygon 9 9 50 20 20 50 9 40 }"
        hatched = "object o fill=blue beam=both { rect 9 9 50 50 }"
        text = 'object o stroke=red { text AV at="9,50" size=20 }'
        for node, body, names in (
                ("canvas", drawn, ("fps", "loop", "route")),
                ("object", moving, ("x", "y", "z", "rotate", "rotate-x", "scale", "scale-x", "opacity", "order", "visible")),
                ("object", drawn, ("rule", "width", "cap", "join", "miter", "beam")),
                ("object", hatched, ("hatch", "hatch-angle")),
                ("text", text, ("font", "align", "spacing")),
                ("key", moving, ("match",))):
            for name in names:
                scene = "kfast 1\ncanvas 100 100 frames=30\n" + body
                changed = re.sub(rf"\b{node} ", f"{node} {name}={self.default_of(name)} ", scene, count=1)
                with self.subTest(property=name):
                    self.assertNotEqual(changed, scene)
                    self.assertEqual(self.compiled(changed), self.compiled(scene))

    def compiled(self, scene):
        with tempfile.TemporaryDirectory(prefix="kfast") as folder:
            path = pathlib.Path(folder) / "scene.kfast"
            path.write_text(scene, encoding="utf-8")
            subprocess.run([KFAST, "compile", path], check=True, capture_output=True, timeout=120)
            return path.with_suffix(".kfb").read_bytes()


if __name__ == "__main__":
    unittest.main()
