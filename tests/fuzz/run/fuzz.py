"""Runs fuzz targets side by side, and keeps what they find; scripts/fuzz builds them and calls it."""

import argparse
import concurrent.futures
import os
import pathlib
import re
import signal
import sys
import threading

from runs import PATIENCE, Figures, Processes
from targets import BUILT, ROOT, names_in_sources, read_targets, shares
from workshop import InUse, Workshop

DEFAULT_MINUTES = 10


def options(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/fuzz", usage="%(prog)s [OPTION]... [MINUTES] [TARGET]...",
        description="Builds the fuzz targets and runs them side by side, each for the same share of the minutes (10, unless "
        "told otherwise) on all processors, once its corpus is read. What they learn is kept for the next time, and minimized. "
        "Status 1: something was found. Ctrl-C ends it early.")
    parser.add_argument("words", nargs="*", metavar="MINUTES and TARGETS", help="how long; which ones: all, if none is named")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="run N at a time: as there are processors")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build/fuzz",
                        help="where corpora, finds and logs are kept: build/fuzz, which goes with the build")
    parser.add_argument("--targets", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--check-options", action="store_true", help=argparse.SUPPRESS)
    chosen = parser.parse_args(arguments)
    chosen.seconds = round(60 * minutes_in(chosen.words))
    known = [target.name for target in read_targets(chosen.targets)] if chosen.targets else names_in_sources()
    unknown = [word for word in chosen.words if word not in known]
    if unknown:
        parser.error(f"there is no target '{unknown[0]}', but {', '.join(known)}")
    if chosen.jobs < 1:
        parser.error("one has to run at a time, at least")
    if shares(chosen.words or known, chosen.jobs, chosen.seconds)[1] < 1:
        parser.error("these are too few minutes: each target gets less than a second")
    return chosen


def minutes_in(words):
    """Takes them from the words, if they begin with a number."""
    if not words or not re.fullmatch(r"\d+(\.\d+)?", words[0]):
        return DEFAULT_MINUTES
    return float(words.pop(0))


class Campaign:
    """All targets, side by side, for a time."""

    def __init__(self, targets, workshop, processes, jobs):
        self._targets = targets
        self._workshop = workshop
        self._processes = processes
        self._jobs = jobs
        self.figures = {target.name: Figures() for target in targets}
        self._lock = threading.Lock()

    def run(self, seconds):
        runs, share = shares(self._targets, self._jobs, seconds)
        self._side_by_side(lambda run: self._run(*run, share), runs)

    def minimize(self):
        self._side_by_side(self._minimize, self._targets)

    def _run(self, target, number, seconds):
        figures = self._workshop.run(target, seconds, number)
        self._note(target, figures)
        print(f"{target.name}: {figures.seconds:.0f} s, coverage {growth(figures.coverage)}", file=sys.stderr, flush=True)

    def _minimize(self, target):
        failure = self._workshop.minimize(target)
        self._note(target, Figures(failures=[failure] if failure else []))

    def _note(self, target, figures):
        with self._lock:
            self.figures[target.name].add(figures)

    def _side_by_side(self, action, tasks):
        """Raises KeyboardInterrupt, and what an action has raised, when all have been stopped."""
        with concurrent.futures.ThreadPoolExecutor(self._jobs) as pool:
            futures = [pool.submit(action, task) for task in tasks]
            try:
                for future in concurrent.futures.as_completed(futures):
                    future.result()
            except BaseException:
                for future in futures:
                    future.cancel()
                self._processes.stop()
                concurrent.futures.wait(futures, PATIENCE)
                self._processes.stop(signal.SIGKILL)
                raise


def table(targets, figures, workshop):
    rows = [("target", "seconds", "executions", "a second", "coverage", "features", "kept", "finds")]
    for target in targets:
        found = figures[target.name]
        rows.append((target.name, f"{found.seconds:.0f}", str(found.executions),
                     f"{found.executions / found.seconds:.0f}" if found.seconds else "-", growth(found.coverage),
                     growth(found.features), str(workshop.kept(target)), str(len(workshop.finds(target)))))
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join("  ".join(cell.ljust(width) if number == 0 else cell.rjust(width)
                               for number, (cell, width) in enumerate(zip(row, widths))) for row in rows)


def growth(pair):
    return f"{pair[0]} -> {pair[1]}" if pair else "-"


def report(targets, figures, workshop):
    """Returns whether something was found."""
    print(table(targets, figures, workshop))
    finds = [(target, find) for target in targets for find in workshop.finds(target)]
    if finds:
        print("\nFound. Again, one by one:")
    for target, find in finds:
        print(f"    {target.program} {find}")
    failures = [failure for target in targets for failure in figures[target.name].failures]
    print(*failures, sep="\n", end="\n" if failures else "", file=sys.stderr)
    return bool(finds or failures)


def interrupt(*_):
    raise KeyboardInterrupt


def main(arguments):
    chosen = options(arguments)
    if chosen.check_options:
        return 0
    targets = [target for target in read_targets(chosen.targets or BUILT) if not chosen.words or target.name in chosen.words]
    signal.signal(signal.SIGTERM, interrupt)
    processes = Processes()
    try:
        workshop = Workshop(chosen.folder.resolve(), processes)
    except InUse as failure:
        sys.exit(str(failure))
    campaign = Campaign(targets, workshop, processes, chosen.jobs)
    is_interrupted = False
    for target in targets:
        workshop.prepare(target)
    try:
        for target in targets:
            workshop.try_again(target)
        campaign.run(chosen.seconds)
        campaign.minimize()
    except KeyboardInterrupt:
        is_interrupted = True
    is_found = report(targets, campaign.figures, workshop)
    return 1 if is_found else 130 if is_interrupted else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
