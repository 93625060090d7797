"""What instructions of an image come from."""

import dataclasses
import subprocess


@dataclasses.dataclass(frozen=True)
class Place:
    """A function and a line of it."""
    function: str
    file: str  # without folder
    line: str


def source_places(image, addresses):
    """For each address the functions that it lies in: the innermost of the inlined ones first, the compiled one last."""
    listing = subprocess.run(["arm-none-eabi-addr2line", "--addresses", "--functions", "--inlines", "--demangle",
                              "--exe", image], input="\n".join(map(hex, addresses)), check=True,
                             stdout=subprocess.PIPE, text=True, timeout=120).stdout
    places = {}
    lines = iter(listing.splitlines())
    for line in lines:
        if line.startswith("0x"):
            chain = places[int(line, 16)] = []
        else:
            file, number = next(lines).split(" ")[0].rsplit("/", 1)[-1].rsplit(":", 1)
            chain.append(Place(short_name(line), file, number))
    return places


def short_name(function):
    """Without namespaces of ours and without parameters."""
    name = function.replace("(anonymous namespace)::", "").replace("kfast::", "")
    depth = 0
    for place, letter in enumerate(name):
        depth += (letter == "<") - (letter == ">")
        if letter == "(" and depth == 0 and not name.endswith("operator", 0, place):
            return name[:place]
    return name
