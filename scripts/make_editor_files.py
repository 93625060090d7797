#!/usr/bin/env python3
"""Makes what VS Code and vim need for scenes: make_editor_files.py KFAST FOLDER

Words come from `kfast schema --json`, the rest from the folder editors/. FOLDER/vscode is an extension,
FOLDER/kfast.vsix the same to be installed, and FOLDER/vim belongs into ~/.vim.
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

EDITORS = pathlib.Path(__file__).resolve().parent.parent / "editors"

MANIFEST = """<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity Language="en-US" Id="{name}" Version="{version}" Publisher="{publisher}"/>
    <DisplayName>{displayName}</DisplayName>
    <Description xml:space="preserve">{description}</Description>
  </Metadata>
  <Installation><InstallationTarget Id="Microsoft.VisualStudio.Code"/></Installation>
  <Dependencies/>
  <Assets><Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true"/></Assets>
</PackageManifest>
"""

CONTENT_TYPES = """<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
  <Default Extension="json" ContentType="application/json"/>
  <Default Extension="vsixmanifest" ContentType="text/xml"/>
</Types>
"""


def any_of(words):
    """A regular expression; longer words first, so that rotate-x is not taken for rotate."""
    return "|".join(re.escape(word).replace(r"\-", "-") for word in sorted(set(words), key=lambda w: (-len(w), w)))


def words_of(vocabulary):
    """What is coloured: nodes, properties and words."""
    nodes = [node["name"] for node in vocabulary["nodes"] if not node.get("any_name")]
    properties, words = [], []
    for node in vocabulary["nodes"]:
        for one in node["properties"]:
            properties.append(one["name"])
            words += one.get("words", [])
        for kind in node["values"]["kinds"]:
            words += kind.get("words", [])
    laws = [law.split("(")[0] for law in vocabulary["laws"]]
    return nodes, properties, words + laws + vocabulary["fonts"], vocabulary["colours"]


def grammar(vocabulary):
    """For TextMate and VS Code. The expressions mean the same to Oniguruma and to Python."""
    nodes, properties, words, colours = words_of(vocabulary)
    end = r"(?=[\s;{}=]|$)"
    return {
        "name": "KFAST scene",
        "scopeName": "source.kfast",
        "fileTypes": ["kfast"],
        "patterns": [
            {"name": "comment.block.kfast", "begin": r"/\*", "end": r"\*/"},
            {"name": "comment.line.double-slash.kfast", "match": r"//.*$"},
            {"name": "comment.block.kfast", "match": r"/-"},
            {"name": "string.quoted.triple.kfast", "begin": r'"""', "end": r'"""'},
            {"name": "string.quoted.other.kfast", "match": r'#"[^"]*"#'},
            {"name": "constant.other.color.kfast", "match": r'"#[0-9A-Fa-f]{3,8}"'},
            {"name": "string.quoted.double.kfast", "match": r'"(?:[^"\\]|\\.)*"'},
            {"match": rf"(?:^|([;{{]))\s*({any_of(nodes)}){end}",
             "captures": {"1": {"name": "punctuation.kfast"}, "2": {"name": "keyword.control.kfast"}}},
            {"match": rf"\b({any_of(properties)})(=)",
             "captures": {"1": {"name": "variable.parameter.kfast"}, "2": {"name": "keyword.operator.kfast"}}},
            {"name": "storage.type.unit.kfast", "match": r"\((?:s|ms)\)"},
            {"name": "constant.language.kfast", "match": r"#(?:true|false)\b"},
            {"name": "constant.numeric.kfast", "match": r"(?<![\w-])[-+]?\d[\d_]*(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w-])"},
            {"name": "support.constant.color.kfast", "match": rf"(?<![\w-])(?:{any_of(colours)}){end}"},
            {"name": "support.constant.kfast", "match": rf"(?<![\w-])(?:{any_of(words)}){end}"},
        ],
    }


def usage_of(node_id, vocabulary):
    return next(node["usage"] for node in vocabulary["nodes"] if node["id"] == node_id)


def prefix_of(node_id, vocabulary):
    """What is typed for a snippet: the name of the node, and for another place where that is."""
    name = next(node["name"] for node in vocabulary["nodes"] if node["id"] == node_id)
    return name.lower() if name == node_id else node_id.replace(" of ", "-")


def snippets(vocabulary):
    bodies = json.loads((EDITORS / "snippets.json").read_text(encoding="utf-8"))
    return {node_id: {"prefix": prefix_of(node_id, vocabulary), "body": body,
                      "description": usage_of(node_id, vocabulary)}
            for node_id, body in bodies.items()}


def vim_syntax(vocabulary):
    nodes, properties, words, colours = words_of(vocabulary)

    def vim_any_of(names):
        return r"\%(" + any_of(names).replace("|", r"\|") + r"\)"

    return "\n".join([
        "if exists('b:current_syntax')",
        "    finish",
        "endif",
        r"syntax match kfastWord /\%(^\|[^-[:alnum:]]\)\@1<=" + vim_any_of(words) + r"\ze\%([[:space:];{}]\|$\)/",
        r"syntax match kfastColour /\%(^\|[^-[:alnum:]]\)\@1<=" + vim_any_of(colours) + r"\ze\%([[:space:];{}]\|$\)/",
        r"syntax match kfastProperty /\%(^\|[^-[:alnum:]]\)\@1<=" + vim_any_of(properties) + r"\ze=/",
        r"syntax match kfastNode /\%(^\|[;{]\)\@1<=\s*" + vim_any_of(nodes) + r"\ze\%([[:space:];{}]\|$\)/",
        r"syntax match kfastNumber /\%(^\|[^-[:alnum:]]\)\@1<=[-+]\?\d[0-9_]*\%(\.\d\+\)\?\%([eE][-+]\?\d\+\)\?\>/",
        r"syntax match kfastUnit /(m\?s)/",
        r"syntax match kfastTruth /#\%(true\|false\)\>/",
        r'syntax region kfastString start=/"/ skip=/\\./ end=/"/',
        r'syntax region kfastString start=/"""/ end=/"""/',
        r"syntax match kfastComment /\/\/.*$/",
        r"syntax region kfastComment start=/\/\*/ end=/\*\//",
        *(f"highlight default link {name} {group}" for name, group in (
            ("kfastWord", "Constant"), ("kfastColour", "Constant"), ("kfastProperty", "Identifier"),
            ("kfastNode", "Statement"), ("kfastNumber", "Number"), ("kfastUnit", "Type"), ("kfastTruth", "Boolean"),
            ("kfastString", "String"), ("kfastComment", "Comment"))),
        "let b:current_syntax = 'kfast'", ""])


def snipmate(all_snippets):
    lines = []
    for snippet in all_snippets.values():
        lines.append(f"snippet {snippet['prefix']} {snippet['description']}")
        lines += ["\t" + line for line in snippet["body"]]
    return "\n".join(lines) + "\n"


def ultisnips(all_snippets):
    lines = []
    for snippet in all_snippets.values():
        description = snippet["description"].replace('"', "'")
        lines += [f"snippet {snippet['prefix']} \"{description}\"", *snippet["body"], "endsnippet", ""]
    return "\n".join(lines)


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def as_json(content):
    return json.dumps(content, indent=4, ensure_ascii=False) + "\n"


def add(archive, name, text):
    """Without the time, so that the same words make the same archive."""
    entry = zipfile.ZipInfo(str(name))
    entry.external_attr = 0o644 << 16
    archive.writestr(entry, text, zipfile.ZIP_DEFLATED)


def write_vsix(folder, path, package):
    with zipfile.ZipFile(path, "w") as archive:
        add(archive, "extension.vsixmanifest", MANIFEST.format(**package))
        add(archive, "[Content_Types].xml", CONTENT_TYPES)
        for file in sorted(folder.rglob("*.json")):
            add(archive, pathlib.Path("extension") / file.relative_to(folder), file.read_bytes())


def make(kfast, folder):
    vocabulary = json.loads(subprocess.run([kfast, "schema", "--json"], check=True, capture_output=True).stdout)
    version = subprocess.run([kfast, "--version"], check=True, capture_output=True, text=True).stdout.split()[1]
    for editor in ("vscode", "vim"):
        shutil.copytree(EDITORS / editor, folder / editor, dirs_exist_ok=True)
    package = {**json.loads((EDITORS / "vscode/package.json").read_text(encoding="utf-8")), "version": version}
    all_snippets = snippets(vocabulary)
    write(folder / "vscode/package.json", as_json(package))
    write(folder / "vscode/syntaxes/kfast.tmLanguage.json", as_json(grammar(vocabulary)))
    write(folder / "vscode/snippets/kfast.json", as_json(all_snippets))
    write_vsix(folder / "vscode", folder / "kfast.vsix", package)
    write(folder / "vim/syntax/kfast.vim", vim_syntax(vocabulary))
    write(folder / "vim/snippets/kfast.snippets", snipmate(all_snippets))
    write(folder / "vim/UltiSnips/kfast.snippets", ultisnips(all_snippets))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    make(sys.argv[1], pathlib.Path(sys.argv[2]))
