"""What scripts/make_editor_files.py makes: snippets that compile, a grammar that colours, files that vim reads."""

import json
import re
import shutil
import subprocess
import sys
import unittest
import zipfile

from command_case import KFAST, ROOT, CommandTest

CARRIED = "\nobject o fill=white skin=s bone=arm { rect 1 1 9 9 }"
BONES = "bones s { bone arm 20 20 60 20; bone fore 60 20 80 50 parent=arm; BODY }" + CARRIED
SKIN = "bones s { bone arm 20 20 60 20 region=99 }\nobject o fill=white skin=s { rect 1 1 9 9; BODY }"
BENT = "object o fill=white { key 0 { rect 20 50 80 20; BODY } }"

# What a snippet is tried in, in the place of BODY, by the id of what it stands in.
AROUND = {
    "": "BODY",
    "palette": "palette { BODY }",
    "object": "object o stroke=white { BODY }",
    "group": "group { BODY; object o fill=white { circle 9 9 r=3 } }",
    "symbol": "symbol p { BODY }\nobject o fill=white { use p 50 50 }",
    "track": "object o stroke=white { circle 9 9 r=3; track x { at 0 0; BODY } }",
    "bones": BONES,
    "bone": "bones s { bone arm 20 20 60 20 { BODY } }" + CARRIED,
    "pose": BONES.replace("BODY", "pose 30 { BODY }"),
    "reach": BONES.replace("BODY", "reach fore bend=left { at 0 85 50; BODY }"),
    "mesh": "object o stroke=white { mesh { vertices 0 0 0  9 0 0  9 9 9; edges 1 2; BODY } }",
    "weights": SKIN.replace("BODY", "weights { BODY }"),
}
# Of those that need something else beside them.
AROUND_NODE = {
    "track": "object o stroke=white { circle 9 9 r=3; BODY }",
    "weights": SKIN,
    "skeleton": BENT,
    "backbone": BENT.replace("BODY", "skeleton { BODY; width 20 }"),
    "width": BENT.replace("BODY", "skeleton { backbone 20 60 60 60 100 60; BODY }"),
    "left": BENT.replace("BODY", "skeleton { backbone 20 60 100 60; BODY; right 20 70 100 70 }"),
    "right": BENT.replace("BODY", "skeleton { backbone 20 60 100 60; left 20 50 100 50; BODY }"),
    "use": "symbol wheel { object w fill=white { circle 0 0 r=9 } }\nBODY",
    "use of drawing": "symbol eye { ellipse 0 0 rx=18 ry=24 }\nobject o fill=white { BODY }",
    "input": "BODY\nobject o fill=white { circle 9 9 r=3; track x input=gaze { at -1 0; at 1 9 } }",
}


def with_defaults(body):
    """What stands there if a snippet is taken as it is; of a place that is named twice, the same."""
    defaults = {}

    def take(match):
        defaults[match[1]] = match[2].replace("\\}", "}")
        return defaults[match[1]]

    text = re.sub(r"\$\{(\d+):((?:\\.|[^}\\])*)\}", take, "\n".join(body))
    return re.sub(r"\$0", "", text)


class EditorTest(CommandTest):
    def setUp(self):
        super().setUp()
        subprocess.run([sys.executable, ROOT / "scripts/make_editor_files.py", KFAST, self.folder], check=True, timeout=120)
        self.schema = json.loads(self.run_kfast("schema", "--json").stdout)

    def read(self, name):
        return json.loads((self.folder / "vscode" / name).read_text(encoding="utf-8"))

    def test_all_files_are_there(self):
        package = self.read("package.json")
        self.assertRegex(package["version"], r"^\d+\.\d+\.\d+$")
        contributed = package["contributes"]
        for path in (contributed["languages"][0]["configuration"], contributed["grammars"][0]["path"],
                     contributed["snippets"][0]["path"], "tasks.json"):
            self.assertTrue(self.read(path))
        with zipfile.ZipFile(self.folder / "kfast.vsix") as archive:
            self.assertEqual(json.loads(archive.read("extension/package.json")), package)
            self.assertIn(f'Version="{package["version"]}"', archive.read("extension.vsixmanifest").decode())

    def test_every_node_has_a_snippet(self):
        self.assertEqual(set(self.read("snippets/kfast.json")), {node["id"] for node in self.schema["nodes"]})

    def scene_with(self, node_id, text):
        if node_id == "kfast":
            return text
        if node_id == "canvas":
            return "kfast 1\n" + text
        inside_of = next(node for node in self.schema["nodes"] if node["id"] == node_id)["inside_of"]
        around = AROUND_NODE.get(node_id) or next(AROUND[each] for each in ("object", *inside_of)
                                                  if each in inside_of and each in AROUND)
        return "kfast 1\ncanvas 240 240 frames=60\n" + around.replace("BODY", text)

    def test_snippets_compile(self):
        prefixes = set()
        for node_id, snippet in self.read("snippets/kfast.json").items():
            text = with_defaults(snippet["body"])
            with self.subTest(node=node_id):
                (self.folder / "snippet.kfast").write_text(self.scene_with(node_id, text), encoding="utf-8")
                self.run_kfast("check", "snippet.kfast")
                self.assertNotIn("$", text)
                self.assertNotIn(snippet["prefix"], prefixes)
                prefixes.add(snippet["prefix"])

    def scopes(self, line):
        """(text, scope) of a line, as an editor finds them: the first pattern at the leftmost place."""
        patterns, at, found = self.read("syntaxes/kfast.tmLanguage.json")["patterns"], 0, []
        while at < len(line):
            matches = [(match.start(), place, match, pattern) for place, pattern in enumerate(patterns)
                       for match in [re.compile(pattern.get("match", pattern.get("begin"))).search(line, at)] if match]
            if not matches:
                break
            _, _, match, pattern = min(matches, key=lambda each: each[:2])
            for number, capture in pattern.get("captures", {"0": pattern}).items():
                if match[int(number)]:
                    found.append((match[int(number)], capture["name"].removesuffix(".kfast")))
            at = max(match.end(), at + 1)
        return found

    def test_grammar_colours(self):
        keyword, name, number = "keyword.control", "variable.parameter", "constant.numeric"
        self.assertEqual(self.scopes('object star fill="#fff" { circle 60 -6.5 r=20; key (s)1 { empty } } // ball'), [
            ("object", keyword), ("fill", name), ("=", "keyword.operator"), ('"#fff"', "constant.other.color"),
            ("{", "punctuation"), ("circle", keyword), ("60", number), ("-6.5", number), ("r", name),
            ("=", "keyword.operator"), ("20", number), (";", "punctuation"), ("key", keyword), ("(s)", "storage.type.unit"),
            ("1", number), ("{", "punctuation"), ("empty", keyword), ("// ball", "comment.line.double-slash")])
        self.assertEqual(self.scopes("canvas 9 9 loop=ping-pong route=#true"), [
            ("canvas", keyword), ("9", number), ("9", number), ("loop", name), ("=", "keyword.operator"),
            ("ping-pong", "support.constant"), ("route", name), ("=", "keyword.operator"), ("#true", "constant.language")])
        self.assertEqual(self.scopes('track rotate-x law="steps(4)" { at 0 red-ish }')[:3], [
            ("track", keyword), ("rotate-x", "support.constant"), ("law", name)])
        self.assertNotIn(("red", "support.constant.color"), self.scopes("use red-ish 1 1"))

    def test_problem_matcher_finds_places(self):
        pattern = self.read("package.json")["contributes"]["problemMatchers"][0]["pattern"]
        (self.folder / "wrong.kfast").write_text("kfast 1\ncanvas 9 9\nobject a fill=rd { circle 1 1 r=1 }\n")
        text = self.run_kfast("check", "wrong.kfast", status=1).stderr
        matches = [match for line in text.splitlines() if (match := re.match(pattern["regexp"], line))]
        self.assertEqual([match.groups() for match in matches],
                         [("wrong.kfast", "3", "15", "error", 'unknown colour "rd"')])
        self.assertEqual([pattern[part] for part in ("file", "line", "column", "severity", "message")], [1, 2, 3, 4, 5])

    def test_problem_matcher_tells_of_a_file_that_cannot_be_read(self):
        matchers = {each["name"]: each for each in self.read("package.json")["contributes"]["problemMatchers"]}
        pattern = matchers["kfast-file"]["pattern"]
        for name, found in (("missing.kfast", ("missing.kfast", "there is no such file: check the name and the folder")),
                            ("wrong.kfast", None)):
            (self.folder / "wrong.kfast").write_text("kfast 1\ncanvas 9 9\nobject a fill=rd { circle 1 1 r=1 }\n")
            text = self.run_kfast("check", name, status=1).stderr
            matches = [match.groups() for line in text.splitlines() if (match := re.match(pattern["regexp"], line))]
            self.assertEqual(matches, [found] if found else [])
        check = self.read("tasks.json")["tasks"][0]
        self.assertEqual({each.removeprefix("$") for each in check["problemMatcher"]}, set(matchers))
        self.assertEqual(check["presentation"]["reveal"], "always", "nothing matches when there is no kfast")

    def need_vim(self, feature):
        if not shutil.which("vim"):
            self.skipTest("there is no vim")
        if feature not in subprocess.run(["vim", "--version"], capture_output=True, text=True, timeout=60).stdout:
            self.skipTest(f"this vim has no {feature}")

    def vim(self, *commands):
        """What vim prints for them in a file with a mistake, with our files alone."""
        (self.folder / "wrong.kfast").write_text(
            "kfast 1\ncanvas 9 9\nobject a fill=rd { circle 1 1 r=1 }\nclip b from=0 to=1\nobject c fill=red\n")
        script = self.folder / "script.vim"
        script.write_text("\n".join(["set nocompatible nomore", f"set runtimepath={self.folder}/vim,$VIMRUNTIME",
                                     "filetype plugin on", "syntax on", "edit wrong.kfast", "redir! > out.txt", *commands,
                                     "redir END", "qall!"]) + "\n")
        result = subprocess.run(["vim", "-e", "-s", "-u", "NONE", "-S", script], cwd=self.folder, capture_output=True,
                                text=True, timeout=120, stdin=subprocess.DEVNULL)
        printed = (self.folder / "out.txt").read_text()
        self.assertNotRegex(printed + result.stdout + result.stderr, r"E\d+:")
        return printed

    def test_vim_colours(self):
        self.need_vim("+syntax")
        printed = self.vim("echo &filetype b:current_syntax",
                           *(f"echo synIDattr(synID({line}, {column}, 1), 'name')"
                             for line, column in ((3, 1), (3, 10), (3, 20), (3, 27), (3, 31), (5, 15))))
        self.assertEqual(printed.split(), ["kfast", "kfast", "kfastNode", "kfastProperty", "kfastNode", "kfastNumber",
                                           "kfastProperty", "kfastColour"])

    def test_vim_finds_places(self):
        self.need_vim("+quickfix")
        printed = self.vim(f"let &makeprg = '{KFAST} check %:S'", "silent make!",
                           "for each in getqflist() | echo each.valid bufname(each.bufnr) each.lnum each.col each.type "
                           "each.text | endfor")
        entries = [line for line in printed.splitlines() if line.startswith("1 ")]
        self.assertEqual(len(entries), 2, printed)
        self.assertTrue(entries[0].startswith('1 wrong.kfast 3 15 E unknown colour "rd"'))
        self.assertIn('did you mean "red"?', printed)

    def test_vim_tells_what_could_not_be_checked(self):
        self.need_vim("+quickfix")
        shown = ["silent make!", "for each in getqflist() | echo each.type bufname(each.bufnr) each.text | endfor"]
        printed = self.vim(f"let &makeprg = '{KFAST} check missing.kfast'", *shown)
        self.assertEqual([line for line in printed.splitlines() if line.startswith("E ")],
                         ["E missing.kfast there is no such file: check the name and the folder"])
        (self.folder / "tools").mkdir()
        (self.folder / "tools/tee").symlink_to(shutil.which("tee"))
        for shell in ("bash", "dash", "zsh"):
            if shutil.which(shell):
                printed = self.vim(f"set shell={shutil.which(shell)}", f"let $PATH = '{self.folder}/tools'",
                                   "let &makeprg = 'kfast check %:S'", *shown)
                self.assertRegex(printed, r"(?m)^E .*not found.*", shell)

    def test_vim_snippets_are_the_same(self):
        names = {each["prefix"] for each in self.read("snippets/kfast.json").values()}
        for path in ("snippets", "UltiSnips"):
            text = (self.folder / "vim" / path / "kfast.snippets").read_text(encoding="utf-8")
            self.assertEqual(set(re.findall(r"^snippet (\S+)", text, re.MULTILINE)), names)


if __name__ == "__main__":
    unittest.main()
