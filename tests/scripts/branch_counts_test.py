"""scripts/branch_counts.py, with what llvm-cov exports of small sources: one written down, and one that clang compiles."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

from branch_counts import Room, measured, places, table  # noqa: E402 (lies there)

GATE = """\
bool opens(int key, bool is_locked)
{
    expects(key != 0 || (key > 1 && is_locked));
    if constexpr (sizeof(int) == 4)
        key += 1;
    return key > 2 &&
           !is_locked;
}
bool operator==(Key, Key) = default;
"""
PROGRAM = """\
template <int limit>
bool is_below(int value)
{
    if (value < limit)
        return true;
    return false;
}
int digit(char letter)
{
    switch (letter) {
    case '0':
        return 0;
    case '1':
        return 1;
    default:
        return -1;
    }
}
bool is_dot(char letter)
{
    switch (letter) {
    case '.':
        return true;
    }
    return false;
}
int main() { return is_below<1>(0) && !is_below<9>(10) && digit('1') == 1 && is_dot('.') ? 0 : 1; }
"""


class BranchCountsTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name).resolve()

    def add(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        return str(file)

    def measured(self, *functions, room="room"):
        """Of functions, each of which is its file with its branches: line, columns of the condition, how often it was
        true and false."""
        files = sorted({file for file, _ in functions})
        export = {
            "files": [{"filename": file, "summary": {"lines": {"count": 10, "covered": 9}}} for file in files],
            "functions": [{"filenames": [file], "branches": [[line, begin, line, end, true, false, 0, 0, 4]
                                                             for line, begin, end, true, false in branches]}
                          for file, branches in functions]}
        return measured([export], self.root, [room])[0]

    def test_an_outcome_that_was_never_seen_is_named_with_its_condition(self):
        file = self.add("room/gate.cpp", GATE)
        room = self.measured((file, [(6, 12, 19, 3, 2), (7, 12, 22, 0, 3)]))
        self.assertEqual((4, [("room/gate.cpp", 7, "never true: !is_locked")]), (room.branches, room.missing))
        self.assertEqual(["room/gate.cpp:7: never true: !is_locked"], list(places([room])))
        self.assertEqual(75.0, room.share())

    def test_what_is_compiled_several_times_counts_once_and_together(self):
        file = self.add("room/gate.cpp", GATE)
        room = self.measured((file, [(6, 12, 19, 3, 0)]), (file, [(6, 12, 19, 0, 1)]))
        self.assertEqual((2, []), (room.branches, room.missing))

    def test_contracts_and_what_the_compiler_decides_are_no_branches(self):
        file = self.add("room/gate.cpp", GATE)
        room = self.measured((file, [(3, 13, 21, 1, 0), (3, 26, 33, 0, 0), (3, 37, 46, 0, 0), (4, 19, 35, 0, 0), (9, 24, 25, 3, 0)]))
        self.assertEqual((0, [], 100.0), (room.branches, room.missing, room.share()))

    def test_a_room_is_its_folder_alone(self):
        inside, below, beside, outside = (self.add(name, GATE) for name in
                                          ("room/a.cpp", "room/more/b.cpp", "c.cpp", "../elsewhere.cpp"))
        self.addCleanup(pathlib.Path(outside).unlink)
        missed = [(6, 12, 19, 1, 0)]
        room = self.measured((inside, missed), (below, missed), (beside, missed), (str(pathlib.Path(outside).resolve()), missed))
        self.assertEqual([("room/a.cpp", 6, "never false: key > 2")], room.missing)
        self.assertEqual((9, 10), (room.covered_lines, room.lines))

    def test_the_table_does_not_round_up(self):
        rooms = [Room("room", 200, 199, 10_000, [()] * 501), Room("another/room", 4, 4, 0, [])]
        self.assertEqual(["               lines    branches  not taken",
                          "room           99.5 %   94.9 % of 10000    501",
                          "another/room  100.0 %  100.0 % of    0      0"], list(table(rooms)))

    def test_what_clang_14_counts_is_understood(self):
        source = self.add("room/program.cpp", PROGRAM)
        program, raw, data = (self.root / name for name in ("program", "raw", "data"))
        for command in (["clang++", "-std=c++20", "-fprofile-instr-generate", "-fcoverage-mapping", source, "-o", program],
                        ["env", f"LLVM_PROFILE_FILE={raw}", program],
                        ["llvm-profdata-14", "merge", "-o", data, raw]):
            subprocess.run(command, check=True)
        told = subprocess.run(["llvm-cov-14", "export", f"-instr-profile={data}", program], check=True, capture_output=True)
        room = measured([json.loads(told.stdout)["data"][0]], self.root, ["room"])[0]
        self.assertEqual([("room/program.cpp", 11, "never here: case '0'"), ("room/program.cpp", 15, "never here: default"),
                          ("room/program.cpp", 21, "never without a case: switch (letter)")], room.missing[:3])
        self.assertEqual(2 + 3 + 2 + 8, room.branches)


if __name__ == "__main__":
    unittest.main()
