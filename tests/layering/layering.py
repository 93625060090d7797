"""Checks that every include respects the layers: layering.py <root of the repository>."""

import pathlib
import re
import sys

# Each folder may include itself and what is named here.
MAY_INCLUDE = {
    "core": {"core"},
    "firmware": {"firmware", "core"},
    "boards": {"boards", "firmware", "core"},
    "library": {"library", "core"},
    "host": {"host", "library", "firmware", "core"},
    "examples": {"core"},
    "tests": {"tests", "host", "library", "boards", "firmware", "core"},
}

# The only headers in angle brackets for what runs on every device. <cstdlib> is for std::abs, <new> to place a player in
# lent memory; the heap of both is watched by device_symbols.py.
FREESTANDING = {
    "algorithm", "array", "bit", "compare", "concepts", "cstddef", "cstdint", "cstdlib", "limits", "new", "optional",
    "span", "stddef.h", "stdint.h", "string_view", "type_traits", "utility",
}
FREESTANDING_FOLDERS = {"core", "firmware", "library"}

# Libraries that one file each hides from the rest, or one for each of its versions: name_v1.cpp, name_v2.cpp. Tests of what
# stands in for them use them as well.
HIDDEN = {
    "SDL": r"SDL.*", "libsndfile": r"sndfile\.hh?", "hidapi": r"hidapi.*", "libusb": r"libusb.*", "libgpiod": r"gpiod.*",
    "FreeType": r"freetype\.h|ft\w+\.h", "libzip": r"zip\.h", "zlib": r"zlib\.h",
}

# Of one library, what several files hide has nothing to do with each other: windows and sound; the outlines of fonts, the
# letters of a window and its polygons.
PARTS = {"SDL": 2, "FreeType": 3}

# Libraries that stay in a few folders.
WITHIN = {"pugixml": (r"pugi(xml|config)\.hpp", {"host/svg", "host/synfig"})}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def sources(root):
    for folder in MAY_INCLUDE:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in {".hpp", ".cpp", ".h", ".c", ".in"}:
                yield folder, path


def quoted_mistake(folder, included):
    if ".." in pathlib.PurePosixPath(included).parts:
        return "climbs out of its folder"
    if folder == "examples" and "/" not in included:
        return None  # a project of its own, with its header beside it
    layer = included.split("/")[0]
    if layer not in MAY_INCLUDE:
        return "is not written from the root of the repository"
    if layer not in MAY_INCLUDE[folder]:
        return f"reaches from {folder}/ into {layer}/"
    return None


def angle_mistake(folder, included):
    if folder in FREESTANDING_FOLDERS and included not in FREESTANDING:
        return f"is no freestanding header, as {folder}/ needs"
    return None


def hidden_library(included):
    name = included.split("/")[-1]
    return next((library for library, pattern in HIDDEN.items() if re.fullmatch(pattern, name)), None)


def strayed_library(place, included):
    for library, (pattern, folders) in WITHIN.items():
        if re.fullmatch(pattern, included.split("/")[-1]) and str(place.parent) not in folders:
            return f"is of {library}, which belongs into {', '.join(sorted(folders))}"
    return None


def check(root):
    """All violations below `root`, one line each."""
    mistakes = []
    users = {library: set() for library in HIDDEN}
    for folder, path in sources(root):
        for kind, included in INCLUDE.findall(path.read_text(encoding="utf-8")):
            place = path.relative_to(root)
            mistake = (quoted_mistake if kind == '"' else angle_mistake)(folder, included)
            if not mistake and folder != "tests":
                mistake = strayed_library(place, included)
            if mistake:
                mistakes.append(f"{place}: {included} {mistake}")
            if folder != "tests" and (library := hidden_library(included)):
                users[library].add(place)
    for library, places in users.items():
        names = {re.sub(r"_v\d$", "", str(place.with_suffix(""))) for place in places}
        if len(names) > PARTS.get(library, 1) or any(place.suffix != ".cpp" for place in places):
            files = "one .cpp" if library not in PARTS else f"{PARTS[library]} .cpp"
            mistakes.append(f"{library} must be included by {files} alone: {', '.join(map(str, sorted(places)))}")
    return mistakes


if __name__ == "__main__":
    found = check(pathlib.Path(sys.argv[1]))
    print("\n".join(found) or "every include respects the layers")
    sys.exit(1 if found else 0)
