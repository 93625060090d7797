"""The figures of docs/import.md, made anew: what `kfast import` tells of files of the tests.

    documented_figures_test.py KFAST
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TOLERANCES = ("0", "0.03125", "0.25")


def imported(kfast, file, folder, *options):
    command = [kfast, "import", file, "-o", pathlib.Path(folder) / "scene.kfast", *options]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, timeout=120).stdout


def at_tolerance(kfast, file, folder, tolerance):
    report = json.loads(imported(kfast, file, folder, "--json", "--tolerance", tolerance))
    return f"{report['keys']:,}, {report['points']:,}, {report['bytes']:,}"


def lines(kfast, page, folder):
    """What stands in the page, and what should."""
    eyes = imported(kfast, ROOT / "tests/accuracy/lottie/eyes.json", folder).splitlines()[0]
    yield re.search(r"eyes\.kfast: .*(?=\n)", page)[0], "eyes.kfast:" + eyes.split(":", 1)[1]
    for row, name in re.findall(r"(\| `((?:lottie|svg|synfig)/\S+)` \|.*)", page):
        file = ROOT / "tests/import" / name
        figures = [at_tolerance(kfast, file, folder, tolerance) for tolerance in TOLERANCES]
        yield row, f"| `{name}` | {' | '.join(figures)} |"


def main(kfast):
    page = (ROOT / "docs/import.md").read_text()
    with tempfile.TemporaryDirectory() as folder:
        wrong = [pair for pair in lines(kfast, page, folder) if pair[0] != pair[1]]
    for found, expected in wrong:
        print(f"docs/import.md has\n    {found}\nbut it is\n    {expected}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
