"""Reads KDL 2.0 as far as scenes and their schema go: independent of the reader of the compiler."""

import dataclasses
import re

TOKEN = re.compile(r"""
    (?P<blank>[^\S\n]+|\\[^\S\n]*(?://[^\n]*)?\n|//[^\n]*(?=\n|$)|/\*.*?\*/)
  | (?P<end>[\n;])
  | (?P<open>\{) | (?P<close>\})
  | (?P<out>/-)
  | (?P<type>\((?P<unit>[A-Za-z0-9_-]+)\))
  | (?P<many>\"\"\"\n(?P<lines>.*?)\n[^\S\n]*\"\"\")
  | (?P<raw>\#+"(?P<inside>.*?)"\#+)
  | (?P<text>"(?P<quoted>(?:[^"\\]|\\.)*)")
  | (?P<key>\#(?:true|false|null))
  | (?P<number>[-+]?\d[\d_]*(?:\.\d+)?(?:[eE][-+]?\d+)?(?=[\s;{}=]|$))
  | (?P<word>[^\s;{}()"=\\/\#]+)
  | (?P<equal>=)
""", re.VERBOSE | re.DOTALL)

ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\", "s": " ", "r": "\r", "b": "\b", "f": "\f"}


@dataclasses.dataclass
class Node:
    name: str
    arguments: list = dataclasses.field(default_factory=list)  # pairs of a unit and a value
    properties: dict = dataclasses.field(default_factory=dict)  # likewise
    nodes: list = dataclasses.field(default_factory=list)


def tokens_of(text):
    at = 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"no KDL at {text[at:at + 40]!r}")
        at = match.end()
        if match.lastgroup not in ("blank", None):
            kind = next(name for name in ("blank", "end", "open", "close", "out", "type", "many", "raw", "text", "key",
                                          "number", "word", "equal") if match[name] is not None)
            if kind != "blank":
                yield kind, match


def value_of(kind, match):
    if kind == "number":
        return float(match[0].replace("_", ""))
    if kind == "key":
        return {"#true": True, "#false": False, "#null": None}[match[0]]
    if kind == "many":
        return match["lines"]
    if kind == "raw":
        return match["inside"]
    if kind == "text":
        return re.sub(r"\\(u\{([0-9a-fA-F]+)\}|.)",
                      lambda m: chr(int(m[2], 16)) if m[2] else ESCAPES.get(m[1], m[1]), match["quoted"])
    return match["word"]


class Reader:
    def __init__(self, text):
        self.tokens = [*tokens_of(text), ("eof", None)]
        self.at = 0

    def kind(self, ahead=0):
        return self.tokens[min(self.at + ahead, len(self.tokens) - 1)][0]

    def take(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def nodes(self):
        found = []
        while self.kind() not in ("close", "eof"):
            if self.kind() == "end":
                self.take()
                continue
            out = self.kind() == "out"
            if out:
                self.take()
            node = self.node()
            if not out:
                found.append(node)
        return found

    def node(self):
        node = Node(value_of(*self.take()))
        while self.kind() not in ("end", "close", "eof"):
            out = self.kind() == "out"
            if out:
                self.take()
            if self.kind() == "open":
                self.take()
                inside = self.nodes()
                self.take()
                if not out:
                    node.nodes = inside
                continue
            self.entry(node, out)
        return node

    def entry(self, node, out):
        if self.kind(1) == "equal":
            name = value_of(*self.take())
            self.take()
            value = self.value()
            if not out:
                node.properties[name] = value
        else:
            value = self.value()
            if not out:
                node.arguments.append(value)

    def value(self):
        unit = self.take()[1]["unit"] if self.kind() == "type" else None
        return unit, value_of(*self.take())


def read(text):
    """The nodes of a document."""
    return Reader(text).nodes()
