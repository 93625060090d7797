"""Runs of libFuzzer, and what its log tells of them."""

import dataclasses
import os
import re
import signal
import subprocess
import threading
import time

LIMITS = ["-rss_limit_mb=2048", "-timeout=30"]
ENDED_WELL = (0, 72)  # 72: interrupted
PATIENCE = 3  # seconds for what is interrupted

STATE = re.compile(r"^#(\d+)\s+(\w+)\s+cov: (\d+) ft: (\d+)", re.MULTILINE)
EXECUTED = re.compile(r"^stat::number_of_executed_units:\s*(\d+)", re.MULTILINE)


@dataclasses.dataclass
class Figures:
    """Of one run, or of several of a target."""
    seconds: float = 0
    executions: int = 0
    coverage: tuple | None = None  # in the beginning, with all that is known, and in the end
    features: tuple | None = None
    failures: list = dataclasses.field(default_factory=list)  # sentences about runs that ended otherwise

    def add(self, other):
        self.seconds += other.seconds
        self.executions += other.executions
        self.coverage = joined(self.coverage, other.coverage)
        self.features = joined(self.features, other.features)
        self.failures += other.failures


def joined(first, second):
    if first is None or second is None:
        return first or second
    return min(first[0], second[0]), max(first[1], second[1])


def figures_of(log):
    """Of a log of libFuzzer, as far as that has come."""
    states = [(int(number), word, int(coverage), int(features)) for number, word, coverage, features in STATE.findall(log)]
    loaded = next((index for index, state in enumerate(states) if state[1] == "INITED"), None)
    executed = EXECUTED.findall(log)
    figures = Figures(executions=int(executed[-1]) if executed else max((state[0] for state in states), default=0))
    if loaded is not None:
        figures.coverage = states[loaded][2], states[-1][2]
        figures.features = states[loaded][3], states[-1][3]
    return figures


class Processes:
    """Those that run, so that all of them can be stopped."""

    def __init__(self):
        self._running = set()
        self._lock = threading.Lock()
        self.is_stopped = False

    def run(self, command, log, seconds=None):
        """Its status; none if all were stopped before it began. libFuzzer is interrupted when it has fuzzed for so many
        seconds, however long it took to read its corpora."""
        with log.open("wb") as output, self._lock:
            if self.is_stopped:
                return None
            process = subprocess.Popen(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=output,
                                       stderr=subprocess.STDOUT, start_new_session=True)
            self._running.add(process)
        try:
            if seconds is not None:
                end_after(process, log, seconds)
            return process.wait()
        finally:
            with self._lock:
                self._running.remove(process)

    def stop(self, how=signal.SIGINT):
        with self._lock:
            self.is_stopped = True
            for process in self._running:
                tell(process, how)


def end_after(process, log, seconds):
    """libFuzzer tells its figures before it ends, by SIGINT."""
    while process.poll() is None and b"\tINITED" not in log.read_bytes():
        time.sleep(0.1)
    for patience, how in ((seconds, signal.SIGINT), (PATIENCE, signal.SIGKILL)):
        try:
            process.wait(patience)
        except subprocess.TimeoutExpired:
            tell(process, how)


def tell(process, how):
    try:
        os.killpg(process.pid, how)  # merging is done by processes of its own
    except ProcessLookupError:
        pass
