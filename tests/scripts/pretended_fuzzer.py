"""A program with the options of libFuzzer that fuzzes nothing, for fuzz_test.py. What it does stands in the file NAME.does
beside it, and what it is called with goes to NAME.calls.

    pretended_fuzzer.py NAME [OPTION]... [PATH]...


    well    finds an input, and ends at once
    long    the same, but ends by SIGINT alone
    slow    the same, and takes a second to begin
    deaf    like long, but does not even hear that
    crash   leaves an input that makes it fail
    hang    never ends with such an input
    die     fails without one
    clash   fuzzes well, and cannot minimize
"""

import pathlib
import shutil
import signal
import sys
import time

BEGIN = "#3\tINITED cov: 10 ft: 20 corp: 2/5b exec/s: 0 rss: 40Mb\n#50\tNEW    cov: 12 ft: 25 corp: 3/9b lim: 4 exec/s: 50"
END = "#100\tDONE   cov: 12 ft: 26 corp: 3/9b lim: 4 exec/s: 100 rss: 40Mb\nstat::number_of_executed_units: 101"


def merge(new, *old):
    """Without what is there twice."""
    known = set()
    for file in sorted(file for folder in old for file in folder.iterdir()):
        if file.read_bytes() not in known:
            known.add(file.read_bytes())
            shutil.copy(file, new / file.name)


def fuzz(does, corpus, artifacts):
    signal.signal(signal.SIGINT, signal.SIG_IGN if does == "deaf" else lambda *_: sys.exit(print(END, flush=True) or 72))
    time.sleep(1 if does == "slow" else 0)
    print(BEGIN, flush=True)
    (corpus / "found").write_text("found", encoding="utf-8")
    if does == "die":
        sys.exit(1)
    if does == "crash":
        pathlib.Path(artifacts + "crash-1").write_text("bad", encoding="utf-8")
        sys.exit(77)
    while does in ("long", "slow", "deaf"):
        time.sleep(0.05)
    print(END)


def main(program, *arguments):
    program = pathlib.Path(program)
    with program.with_suffix(".calls").open("a", encoding="utf-8") as calls:
        print(*arguments, file=calls)
    does = program.with_suffix(".does").read_text(encoding="utf-8")
    options = dict(word[1:].split("=", 1) for word in arguments if word.startswith("-"))
    paths = [pathlib.Path(word) for word in arguments if not word.startswith("-")]
    if paths[0].is_file() and does == "hang":
        time.sleep(60)
    if paths[0].is_file():
        sys.exit(77 if paths[0].read_text(encoding="utf-8") == "bad" and does == "crash" else 0)
    if "merge" in options:
        sys.exit(1) if does == "clash" else merge(*paths)
    else:
        fuzz(does, paths[0], options["artifact_prefix"])


main(*sys.argv[1:])
