"""scripts/fuzz with fuzzers that fuzz nothing: fuzz_test.py"""

import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FUZZ = ROOT / "tests/fuzz/run/fuzz.py"
FUZZER = pathlib.Path(__file__).with_name("pretended_fuzzer.py")

sys.path.insert(0, str(FUZZ.parent))
from runs import figures_of
from targets import shares


class FuzzTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.corpora = self.folder / "kept/corpora"

    def targets(self, **what_they_do):
        rows = []
        for name, does in what_they_do.items():
            program, seeds = self.folder / f"{name}_fuzz", self.folder / "seeds" / name
            program.write_text(f'#!/bin/sh\nexec {sys.executable} {FUZZER} "$0" "$@"\n', encoding="utf-8")
            program.chmod(0o755)
            program.with_suffix(".does").write_text(does, encoding="utf-8")
            seeds.mkdir(parents=True, exist_ok=True)
            (seeds / "seed").write_text("seed", encoding="utf-8")
            rows.append({"name": name, "program": str(program), "seeds": [str(seeds)]})
        (self.folder / "targets.json").write_text(json.dumps(rows), encoding="utf-8")

    def command(self, *arguments):
        return [sys.executable, FUZZ, "--targets", self.folder / "targets.json", "--folder", self.folder / "kept", "--jobs", "2",
                *arguments]

    def fuzz(self, *arguments, status=0):
        done = subprocess.run(self.command(*arguments), capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(status, done.returncode, done.stdout + done.stderr)
        return done

    def begin(self, *arguments):
        """Returns when all fuzz."""
        count = len(list(self.folder.glob("*.does")))
        process = subprocess.Popen(self.command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 30
        while len(list(self.corpora.glob("*/found"))) < count:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        return process

    def calls(self, name):
        calls = self.folder / f"{name}_fuzz.calls"
        return calls.read_text(encoding="utf-8").splitlines() if calls.exists() else []

    def kept(self, name):
        return sorted(file.name for file in (self.corpora / name).iterdir())

    def test_all_targets_get_the_same_share(self):
        self.assertEqual(([("a", 0), ("b", 0), ("c", 0)], 5), shares("abc", 2, 10))
        self.assertEqual(([("a", 0), ("b", 0)], 10), shares("ab", 2, 10))
        self.assertEqual(([("a", 0), ("b", 0), ("a", 1), ("b", 1)], 10), shares("ab", 5, 10))
        self.assertEqual(0, shares("abc", 1, 2)[1])

    def test_a_share_begins_when_the_corpus_is_read(self):
        self.targets(one="slow", two="long")
        seconds = [int(line.split()[1]) for line in self.fuzz("0.02").stdout.splitlines()[1:]]
        self.assertGreaterEqual(seconds[0], 2)
        self.assertGreaterEqual(seconds[1], 1)

    def test_chosen_targets_are_run_alone(self):
        self.targets(one="well", two="well")
        printed = self.fuzz("0.1", "two").stdout
        self.assertEqual([], self.calls("one"))
        self.assertNotIn("one", printed)

    def test_figures_are_told_for_each_target(self):
        self.targets(one="well")
        self.assertRegex(self.fuzz("0.1").stdout, r"(?m)^one +\d+ +202 +\d+ +10 -> 12 +20 -> 26 +2 +0$")

    def test_what_is_found_goes_to_the_corpus_that_is_kept_and_not_to_the_seeds(self):
        self.targets(one="well")
        self.fuzz("0.1")
        folders = [word for word in self.calls("one")[0].split() if not word.startswith("-")]
        self.assertEqual([str(self.corpora.resolve() / "one"), str(self.folder / "seeds/one")], folders)
        self.assertEqual(["seed"], [file.name for file in (self.folder / "seeds/one").iterdir()])

    def test_the_corpus_is_minimized_and_used_again(self):
        self.targets(one="well")
        (self.corpora / "one").mkdir(parents=True)
        (self.corpora / "one/same").write_text("found", encoding="utf-8")
        self.fuzz("0.1")
        self.assertEqual(["found", "seed"], self.kept("one"))
        self.fuzz("0.1")
        self.assertEqual(["found", "seed"], self.kept("one"))
        self.assertEqual(["one"], [folder.name for folder in self.corpora.iterdir()])

    def test_a_corpus_that_cannot_be_minimized_stays(self):
        self.targets(one="clash")
        self.assertIn("the corpus of one is not minimized", self.fuzz("0.1", status=1).stderr)
        self.assertEqual(["found"], self.kept("one"))

    def test_a_corpus_that_was_being_replaced_is_there_again(self):
        self.targets(one="well")
        for folder in ("one.old", "one.new"):
            (self.corpora / folder).mkdir(parents=True)
            (self.corpora / folder / folder).write_text(folder, encoding="utf-8")
        self.fuzz("0.1")
        self.assertEqual(["found", "one.old", "seed"], self.kept("one"))

    def test_a_find_is_told_with_what_repeats_it_until_it_is_mended(self):
        self.targets(one="crash", two="well")
        repeats = f"{self.folder}/one_fuzz {self.folder.resolve()}/kept/finds/one/crash-1"
        for _ in range(2):
            printed = self.fuzz("0.1", status=1).stdout
            self.assertIn(repeats, printed)
            self.assertRegex(printed, r"(?m)^one .* 1$")
        self.targets(one="well", two="well")
        self.assertNotIn("Found", self.fuzz("0.1").stdout)
        self.assertIn("crash-1", self.kept("one"))

    def test_a_fuzzer_that_dies_is_told(self):
        self.targets(one="die")
        self.assertIn("one ended with status 1, and left no input", self.fuzz("0.1", status=1).stderr)

    def test_ctrl_c_stops_all_and_keeps_what_was_found(self):
        self.targets(one="long", two="long")
        process = self.begin("5")
        process.send_signal(signal.SIGINT)
        printed, errors = process.communicate(timeout=30)
        self.assertEqual(130, process.returncode, errors)
        self.assertRegex(printed, r"(?m)^one +\d+ +101 ")
        self.assertEqual(["found"], self.kept("one"))
        self.assertFalse([call for call in self.calls("one") if "-merge" in call])

    def test_ctrl_c_while_finds_are_tried_again(self):
        self.targets(one="crash", two="well")
        self.fuzz("0.1", status=1)
        self.targets(one="hang", two="well", three="well")
        called = len(self.calls("one"))
        process = subprocess.Popen(self.command("5"), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 30
        while len(self.calls("one")) == called:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        printed, errors = process.communicate(timeout=30)
        self.assertEqual("", errors)
        self.assertEqual(1, process.returncode)
        self.assertIn("crash-1", printed)

    def test_who_does_not_hear_ctrl_c_is_killed(self):
        self.targets(one="deaf")
        process = self.begin("5")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)
        self.assertEqual(130, process.returncode)

    def test_two_at_a_time_do_not_share_a_folder(self):
        self.targets(one="long")
        process = self.begin("5")
        self.assertIn("another scripts/fuzz is at work", self.fuzz("0.1", status=1).stderr)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)

    def test_wrong_usage_runs_nothing(self):
        self.targets(one="well")
        for arguments, words in ((["2", "tow"], "there is no target 'tow', but one"), (["0.001"], "too few minutes"), (["nan"], "no target 'nan'"),
                                 (["-1"], ""), (["0.1", "--jobs", "0"], "at least")):
            with self.subTest(arguments):
                self.assertIn(words, self.fuzz(*arguments, status=2).stderr)
                self.assertEqual([], self.calls("one"))

    def test_figures_of_a_log_that_breaks_off_are_those_of_its_last_line(self):
        figures = figures_of("INFO: Seed: 1\n#7\tINITED cov: 5 ft: 9 corp: 1/1b\n#64\tpulse  cov: 6 ft: 11 corp: 2/3b lim: 4\n")
        self.assertEqual((64, (5, 6), (9, 11)), (figures.executions, figures.coverage, figures.features))
        self.assertIsNone(figures_of("no log").coverage)

    def test_the_script_tells_mistakes_before_it_builds(self):
        done = subprocess.run([ROOT / "scripts/fuzz", "1", "kld"], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(2, done.returncode)
        self.assertIn("there is no target 'kld', but archive, ", done.stderr)
        shown = subprocess.run([ROOT / "scripts/fuzz", "--help"], capture_output=True, text=True, timeout=60, check=True).stdout
        self.assertTrue(shown.startswith("usage: scripts/fuzz"), shown)


if __name__ == "__main__":
    unittest.main()
