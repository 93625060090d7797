"""Shows that the bench counts the same twice and notices growth; times nothing:

    bench_test.py <folder of kfast and bench_player> <folder of the bench images>
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import report
import results

BENCH = pathlib.Path(__file__).with_name("bench.py")
HOST, IMAGES = sys.argv[1:3]
SCENE, CPU = "robot-eyes", "cortex-m0"


def bench(folder, *arguments):
    """Status, what is printed, and the results of one scene on one CPU."""
    output = pathlib.Path(folder, "results.json")
    done = subprocess.run([sys.executable, BENCH, "--host", HOST, "--images", IMAGES, "--output", output,
                           "--recorded", pathlib.Path(folder, "recorded.json"), "--cpu", CPU, *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300, check=False)
    return done.returncode, done.stdout, output.read_text() if output.exists() else ""


def play(folder, *arguments):
    return bench(folder, "--scene", SCENE, "--instructions-only", *arguments)


class Bench(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory(prefix="kfast")
        cls.folder = cls._folder.name
        cls.status, cls.told, cls.first = play(cls.folder, "--record")

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    def setUp(self):
        self.assertEqual(0, self.status, self.told)

    def test_counts_the_same_twice_and_finds_nothing_grown(self):
        status, told, second = play(self.folder, "--compare")
        self.assertEqual(self.first, second)
        self.assertEqual(0, status, told)
        self.assertIn("Nothing has grown", told)

    def test_refuses_to_compare_with_nothing_before_it_measures(self):
        with tempfile.TemporaryDirectory(prefix="kfast") as empty:
            status, told, found = play(empty, "--compare")
        self.assertEqual((1, "nothing is recorded yet: scripts/bench --record\n", ""), (status, told, found))

    def test_finds_what_has_grown(self):
        recorded = pathlib.Path(self.folder, "recorded.json")
        before = recorded.read_text()
        smaller = json.loads(before)
        smaller["instructions"][CPU][SCENE]["worst"] -= smaller["instructions"][CPU][SCENE]["worst"] // 20
        recorded.write_text(json.dumps(smaller))
        status, told, _ = play(self.folder, "--compare")
        recorded.write_text(before)
        self.assertEqual(1, status, told)
        self.assertIn(f"instructions.{CPU}.{SCENE}.worst", told)
        self.assertEqual(1, told.count(" -> "), told)

    def test_results_have_their_shape(self):
        found = json.loads(self.first)
        frame = found["instructions"][CPU][SCENE]
        self.assertTrue(0 < frame["median"] <= frame["worst"])
        for part in ("update", "draw", "send"):
            self.assertTrue(0 < frame[part]["median"] <= frame[part]["worst"])
        for section, name in (("flash_bytes", CPU), ("ram_bytes", CPU), ("ram_bytes", SCENE), ("stack_bytes", CPU),
                              ("kfb_bytes", SCENE)):
            self.assertGreater(found[section][name], 0, section)
        sent = found["sent_bytes"][SCENE]
        self.assertLessEqual(sent["least"]["worst"], sent["worst"])

    def test_profile_names_functions(self):
        status, told, _ = bench(self.folder, "--profile", SCENE)
        self.assertEqual(0, status, told)
        self.assertRegex(told, r"Renderer|Band|LayerRow")

    def test_names_an_unknown_scene(self):
        status, told, _ = bench(self.folder, "--scene", "nothing")
        self.assertEqual(1, status)
        self.assertIn("there is no scene nothing", told)

    def test_keeps_what_is_written_by_hand(self):
        document = pathlib.Path(self.folder, "benchmarks.md")
        document.write_text(f"By hand.\n{report.BEGIN}old figures\n{report.END}Also by hand.\n")
        for _ in range(2):
            report.write_into(document, json.loads(self.first))
            text = document.read_text()
            self.assertTrue(text.startswith(f"By hand.\n{report.BEGIN}"))
            self.assertTrue(text.endswith(f"{report.END}Also by hand.\n"))
            self.assertNotIn("old figures", text)
            self.assertIn(f"| {SCENE} |", text)
        report.write_into(document, json.loads(self.first))
        self.assertEqual(text, document.read_text())


class Pico(unittest.TestCase):
    def test_figures_stand_in_tables(self):
        scenes = report.pico_section({"eyes": {"frames_per_second": 59.0, "shown": 59, "late": 1, "bus_share": 0.0321}})
        self.assertIn("| eyes | 59.0 | 1 of 60 | 3.2 % |", scenes)
        buses = report.pico_bus_section({"SPI": {"bytes_per_second": 7768439, "bus_share": 0.9949,
                                                 "bus_share_when_all_changes": 0.99}})
        self.assertIn("| SPI | 7.77 | 99.5 % | 99.0 % |", buses)


class Growth(unittest.TestCase):
    def test_two_percent_is_let_pass(self):
        self.assertEqual([], results.growth({"kfb_bytes": {"eyes": 1000}}, {"kfb_bytes": {"eyes": 1020}}))
        self.assertEqual(["kfb_bytes.eyes: 1000 -> 1021, +2.1 %"],
                         results.growth({"kfb_bytes": {"eyes": 1000}}, {"kfb_bytes": {"eyes": 1021}}))

    def test_what_is_measured_for_the_first_time_has_not_grown(self):
        self.assertEqual([], results.growth({}, {"kfb_bytes": {"eyes": 1000}}))

    def test_changed_pixels_are_not_ours(self):
        self.assertEqual([], results.growth({"sent_bytes": {"eyes": {"least": {"mean": 10}}}},
                                            {"sent_bytes": {"eyes": {"least": {"mean": 20}}}}))

    def test_something_instead_of_nothing_has_grown(self):
        self.assertEqual(["sent_bytes.a.median: 0 -> 11"],
                         results.growth({"sent_bytes": {"a": {"median": 0}}}, {"sent_bytes": {"a": {"median": 11}}}))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
