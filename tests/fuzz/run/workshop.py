"""What is kept from one time of fuzzing to the next: corpora and finds."""

import fcntl
import shutil
import subprocess
import time

from runs import ENDED_WELL, LIMITS, Figures, figures_of

REPLAY_SECONDS = 120


class InUse(Exception):
    pass


class Workshop:
    """A folder with corpora, finds and logs. One program at a time has it."""

    def __init__(self, folder, processes):
        self._folder = folder
        self._processes = processes
        for name in ("corpora", "finds", "logs"):
            (folder / name).mkdir(parents=True, exist_ok=True)
        self._lock = (folder / "lock").open("w")
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as failure:
            raise InUse(f"another scripts/fuzz is at work in {folder}") from failure

    def prepare(self, target):
        """Its folders. Ends what a replacement may have begun."""
        corpus, new, old = self._corpus(target), self._new(target), self._old(target)
        shutil.rmtree(new, ignore_errors=True)
        if old.exists() and not corpus.exists():
            old.rename(corpus)
        shutil.rmtree(old, ignore_errors=True)
        corpus.mkdir(exist_ok=True)
        (self._folder / "finds" / target.name).mkdir(exist_ok=True)

    def try_again(self, target):
        """A find that fails no more is an input like others."""
        for find in self.finds(target):
            if not self._fails(target, find):
                shutil.move(find, self._corpus(target) / find.name)

    def finds(self, target):
        """Inputs that made it fail. Slow ones are no failures."""
        folder = self._folder / "finds" / target.name
        return sorted(file for file in folder.iterdir() if not file.name.startswith("slow-unit-"))

    def kept(self, target):
        return sum(1 for _ in self._corpus(target).iterdir())

    def run(self, target, seconds, number):
        """Fuzzes it, which is its run of that number. What is new goes into the first corpus that libFuzzer is told."""
        log = self._folder / "logs" / f"{target.name}-{number}.log"
        before = len(self.finds(target))
        begin = time.monotonic()
        status = self._processes.run(
            [target.program, *LIMITS, *words_of(target), "-print_final_stats=1",
             f"-artifact_prefix={self._folder / 'finds' / target.name}/", self._corpus(target), *target.seeds], log, seconds)
        if status is None:
            return Figures()
        figures = figures_of(log.read_text(encoding="utf-8", errors="replace"))
        figures.seconds = time.monotonic() - begin
        if status not in ENDED_WELL and not self._processes.is_stopped and len(self.finds(target)) == before:
            figures.failures.append(f"{target.name} ended with status {status}, and left no input: {log} has its words")
        return figures

    def minimize(self, target):
        """Keeps of its corpus and the seeds the fewest and smallest inputs that reach as much. Returns what failed, and
        then the corpus is as it was."""
        corpus, new, old = self._corpus(target), self._new(target), self._old(target)
        log = self._folder / "logs" / f"{target.name}-minimized.log"
        new.mkdir()
        status = self._processes.run([target.program, *LIMITS, "-merge=1", new, corpus, *target.seeds], log)
        if self._processes.is_stopped or status != 0:
            shutil.rmtree(new)
            return None if self._processes.is_stopped else f"the corpus of {target.name} is not minimized: {log} has why"
        corpus.rename(old)
        new.rename(corpus)
        shutil.rmtree(old)
        return None

    def _fails(self, target, find):
        try:
            done = subprocess.run([target.program, *LIMITS, find], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL, timeout=REPLAY_SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return True
        return done.returncode != 0

    def _corpus(self, target):
        return self._folder / "corpora" / target.name

    def _new(self, target):
        return self._folder / "corpora" / f"{target.name}.new"

    def _old(self, target):
        return self._folder / "corpora" / f"{target.name}.old"


def words_of(target):
    return [f"-dict={target.dictionary}"] if target.dictionary else []
