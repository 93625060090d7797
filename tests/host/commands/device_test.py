"""Devices and what they play, through the real command and boards behind sockets."""

import json
import os
import pty
import re
import signal
import subprocess
import time
import unittest

from command_case import KFAST, ROOT
from device_case import (BEGIN, BOOT, CANCEL, CHOOSE, COMMIT, DATA, INTERRUPTED, NO_DEVICE, NO_ROOM, PLAY, REFUSED, SPEED,
                         TIMED_OUT, UNPLUGGED, WRONG_VERSION, DeviceTest)

OBJECT = 'object o{number} fill=red {{ key 0 {{ path "M {points}" }} }}\n'


def large_scene(points):
    """A scene text of about so many bytes once compiled."""
    text = "kfast 1\ncanvas 2000 2000 frames=60\n"
    for number in range(points // 1000):
        places = " L ".join(f"{(at * 7919 + number * 31) % 2000} {(at * 6007 + number * 17) % 2000}" for at in range(1000))
        text += OBJECT.format(number=number, points=places)
    return text


class ListTest(DeviceTest):
    def test_a_device_tells_what_it_is(self):
        self.board()
        [device] = self.told("devices")
        self.assertEqual(device["device"], "A")
        self.assertEqual(device["board"], "pico")
        self.assertEqual(device["panel"], {"name": "st7789", "width": 240, "height": 135})
        self.assertEqual(device["slots"], 8)
        self.assertEqual(device["playing"]["home"], "built-in")
        text = self.ask("devices").stdout
        self.assertIn("1000 shown, 3 of them late, 1 coarser for want of room, 2 left out", text)
        for words in ("A\n", "pico, firmware 0.1.0", "st7789, 240x135", "20000 bytes in RAM", "the built-in scene"):
            self.assertIn(words, text)
        self.assertEqual(self.ask("devices", "--quiet").stdout, "")

    def test_a_device_tells_that_its_watchdog_has_restarted_it(self):
        for word, text, fact in (
                (0x4B461102, "once, while it played slot 2\n",
                 {"restarts": 1, "home": "slot", "slot": 2, "safe_mode": False}),
                (0x4B462102, "twice in a row, at last while it played slot 2\n"
                             "  safe mode   plays its built-in scene, if any; 'kfast choose' what plays at its start, or 'kfast erase 2'\n",
                 {"restarts": 2, "home": "slot", "slot": 2, "safe_mode": True}),
                (0x4B4630FF, "3 times in a row, at last while it played the built-in scene\n"
                             "  safe mode   plays nothing by itself; 'kfast choose' what plays at its start\n",
                 {"restarts": 3, "home": "built-in", "slot": None, "safe_mode": True}),
                (0x4B4614FF, "once, before anything played\n",
                 {"restarts": 1, "home": None, "slot": None, "safe_mode": False})):
            self.device = ()
            self.board(f"A{word}", "--restarts", word)
            self.assertEqual(self.told("devices")[0]["watchdog"], fact)
            self.assertIn(f"  restarted   by its watchdog {text}", self.ask("devices").stdout)

    def test_a_device_that_nothing_has_restarted_says_nothing(self):
        self.board()
        self.assertIsNone(self.told("devices")[0]["watchdog"])
        self.assertNotIn("watchdog", self.ask("devices").stdout)

    def test_the_rule_of_udev(self):
        rule = self.run_kfast("devices", "--udev-rule").stdout
        self.assertRegex(rule, r'(?m)^SUBSYSTEM=="hidraw", ATTRS\{idVendor\}=="[0-9a-f]{4}", ATTRS\{idProduct\}=="[0-9a-f]{4}"')

    def test_exit_statuses_are_told_the_same_everywhere(self):
        told = re.findall(r"(?m)^  (\d+) +(\S.*)$", self.run_kfast("--help").stdout.split("Exit status:")[1])
        self.assertEqual(len(told), 13)
        document = (ROOT / "docs/devices.md").read_text()
        self.assertEqual(re.findall(r"(?m)^\| (\d+) \| (.*?) \|", document), told)


class WrongDeviceTest(DeviceTest):
    def test_no_device(self):
        for command in (["pause"], ["devices"], ["play", "knobs.kfast"], ["slots", "--device", "NONE"],
                        ["pause", "--device", "all"]):
            self.refuse(*command, status=NO_DEVICE, says="attached")
        self.refuse("pause", "--device", "sim:/nowhere/at.sock", status=NO_DEVICE, says="kfast simulate")
        self.refuse("pause", "--device", "sim:" + "x" * 200, status=NO_DEVICE, says="too long")

    def test_another_version_of_the_link(self):
        self.board("A", "--protocol", 3)
        self.refused("pause", status=WRONG_VERSION, says="version 3 of the link, and this kfast version 2: update kfast")
        self.refused("devices", status=WRONG_VERSION, says="A.sock")

    def test_a_device_that_does_not_answer(self):
        self.board("A", "--silent-after", 0)
        self.refused("pause", "--timeout", "0.3", status=TIMED_OUT, says="has not answered")

    def test_a_device_that_falls_silent_in_an_upload(self):
        self.board("A", "--silent-after", 3)
        self.refused("play", "knobs.kfast", "--timeout", "0.3", status=TIMED_OUT, says="A: the device has not answered")

    def test_unplugged(self):
        self.board("A", "--unplugged-after", 3)
        self.refused("play", "knobs.kfast", status=UNPLUGGED, says="A: the device is gone")

    def test_a_device_that_cannot_be_asked_does_not_hide_the_others(self):
        self.board("A", "--protocol", 3)
        self.board("B")
        result = self.ask("devices", "--json", status=WRONG_VERSION)
        self.assertEqual([device["device"] for device in json.loads(result.stdout)], ["B"])


class PlayTest(DeviceTest):
    def test_a_scene_goes_into_ram_and_plays(self):
        board = self.board()
        [told] = self.told("play", "knobs.kfast", "--clip", "rise", "--speed", "-0.5")
        playing = told["playing"]
        self.assertEqual((playing["home"], playing["clip"], playing["speed"]), ("RAM", "rise", -0.5))
        self.assertEqual((playing["frames"], playing["fps"], playing["inputs"]), (60, 30, 2))
        self.run_kfast("compile", "knobs.kfast")
        scene = (self.folder / "knobs.kfb").read_bytes()
        blocks = board.reports(DATA)
        self.assertEqual(b"".join(block[4:] for block in blocks)[:len(scene)], scene)
        self.assertEqual(len(blocks), -(-len(scene) // 60))
        self.ask("play", "knobs.kfb")

    def test_what_else_can_be_played(self):
        board = self.board()
        self.ask("upload", "knobs.kfast", "--slot", 3)
        self.assertEqual(self.told("play", "--slot", 3)[0]["playing"]["slot"], 3)
        self.assertEqual(self.told("play", "--clip", "rise")[0]["playing"]["clip"], "rise")
        self.assertEqual(self.told("play", "--built-in")[0]["playing"]["home"], "built-in")
        self.ask("choose", 3)
        self.assertEqual(self.told("play", "--start")[0]["playing"]["slot"], 3)
        self.assertEqual([report[2] for report in board.reports(PLAY)], [1, 3, 0, 4])
        self.assertEqual(board.reports(SPEED), [])

    def test_wrong_plays(self):
        board = self.board()
        self.refused("play", "knobs.kfast", "--clip", "rize", status=2, says='did you mean "rise"?')
        self.refused("play", "knobs.kfast", "--slot", 3, status=2, says="excludes")
        self.refused("play", "--clip", "x" * 25, status=2, says="at most 24 bytes")
        self.assertEqual(board.reports(PLAY, BEGIN), [])
        self.refused("play", "--slot", 3, status=REFUSED, says="the slot holds no scene")
        self.refused("play", "--slot", 9, status=REFUSED, says="they go from 0 to 7")
        self.refused("play", "--clip", "rize", status=REFUSED, says="no clip of that name")
        self.refused("play", "nothing.kfast", status=1, says="no such file")

    def test_a_scene_that_is_too_large(self):
        board = self.board()
        (self.folder / "large.kfast").write_text(large_scene(30_000))
        self.refused("play", "large.kfast", status=NO_ROOM, says="it holds 20000 bytes")
        self.refused("upload", "large.kfast", status=NO_ROOM, says="there is room for")
        self.assertEqual(board.reports(DATA), [])

    def test_several_devices_start_together(self):
        boards = [self.board(name) for name in "ABC"]
        told = self.told("play", "knobs.kfast")
        self.assertEqual([device["device"] for device in told], ["A", "B", "C"])
        self.assertTrue(all(device["playing"]["home"] == "RAM" for device in told))
        self.assertTrue(all(len(board.reports(PLAY)) == 1 for board in boards))
        self.assertEqual(self.ask("pause").stdout.count("paused"), 3)

    def test_none_plays_if_one_has_not_got_the_scene(self):
        whole = self.board("A")
        self.board("B", "--unplugged-after", 3)
        self.refused("play", "knobs.kfast", status=UNPLUGGED, says="B: the device is gone")
        self.assertEqual(len(whole.reports(COMMIT)), 1)
        self.assertEqual(whole.reports(PLAY), [])
        self.assertEqual([report[1] for report in whole.reports(CANCEL)], [whole.reports(BEGIN)[0][1]],
                         "what gave way to it plays again")


class SlotTest(DeviceTest):
    def slots(self):
        return {slot["slot"]: (slot["name"], slot["chosen"]) for slot in self.told("slots")[0]["slots"]}

    def test_slots_are_filled_by_name(self):
        self.board()
        self.assertEqual(self.slots(), {})
        self.assertEqual(self.told("upload", "knobs.kfast")[0]["slot"], 0)
        self.assertEqual(self.told("upload", "repeat.kfast", "--name", "döt")[0]["slot"], 1)
        self.assertEqual(self.told("upload", "once.kfast", "--slot", 5, "--choose")[0]["slot"], 5)
        self.assertEqual(self.told("upload", "knobs.kfast")[0]["slot"], 0)
        self.assertEqual(self.slots(), {0: ("knobs", False), 1: ("döt", False), 5: ("once", True)})
        text = self.ask("slots").stdout
        self.assertIn("  5  once, ", text)
        self.assertIn("plays from the start on", text)
        self.assertIn("  7  empty\n", text)

    def test_choose_and_erase(self):
        board = self.board()
        for name in ("knobs", "once", "repeat"):
            self.ask("upload", f"{name}.kfast")
        self.ask("choose", 1)
        self.assertEqual(self.slots()[1], ("once", True))
        self.ask("choose", "built-in")
        self.assertEqual(self.slots()[1], ("once", False))
        self.assertEqual([report[2] for report in board.reports(CHOOSE)], [1, 255])
        self.ask("erase", 0, 2)
        self.assertEqual(self.slots(), {1: ("once", False)})
        self.refused("erase", 0, status=REFUSED, says="the slot holds no scene")
        self.refused("choose", 0, status=REFUSED, says="the slot holds no scene")
        self.refused("choose", 8, status=REFUSED, says="they go from 0 to 7")
        for word in ("x", "1x", "255", ""):
            self.refused("choose", word, status=2, says="is no slot")

    def test_what_would_keep_the_board_too_long_is_not_sent(self):
        board = self.board()
        star = " L ".join(f"{i} {9 * (i % 2)}" for i in range(10))
        leaves = "\n".join(f'object o{i} fill=red {{ path "M {star} Z" }}' for i in range(50))
        uses = "\n".join(f"use leaves {i % 64} {i % 48}" for i in range(200))
        (self.folder / "heavy.kfast").write_text(f"kfast 1\ncanvas 64 48\nsymbol leaves {{\n{leaves}\n}}\n{uses}\n")
        self.assertIn("longer than a second", self.ask("upload", "heavy.kfast", "--choose", status=1).stderr)
        self.assertEqual(board.reports(BEGIN, CHOOSE), [])

    def test_upload_and_play(self):
        self.board()
        self.ask("upload", "knobs.kfast", "--play")
        self.assertEqual(self.told("devices")[0]["playing"]["slot"], 0)

    def test_all_slots_are_taken(self):
        self.board()
        for number in range(8):
            self.ask("upload", "once.kfast", "--name", f"n{number}")
        self.refused("upload", "once.kfast", status=NO_ROOM, says="all slots are taken")
        self.ask("upload", "once.kfast", "--name", "n3")

    def test_names_that_are_too_long(self):
        self.board()
        (self.folder / ("ä" * 20 + ".kfast")).write_text((self.folder / "once.kfast").read_text())
        self.assertEqual(self.told("upload", "ä" * 20 + ".kfast")[0]["name"], "ä" * 12)
        self.refused("upload", "once.kfast", "--name", "x" * 25, status=2, says="24 bytes")
        self.refused("upload", "once.kfast", "--name", "", status=2, says="is empty")


class SteerTest(DeviceTest):
    def setUp(self):
        super().setUp()
        self.log = self.board()
        self.ask("play", "knobs.kfast")

    def playing(self):
        return self.told("devices")[0]["playing"]

    def test_steering(self):
        self.assertTrue(self.told("pause")[0]["playing"]["paused"])
        self.assertIn("paused", self.ask("pause").stdout)
        self.assertFalse(self.told("resume")[0]["playing"]["paused"])
        self.assertEqual(self.ask("pause", "--quiet").stdout, "")
        for text, frame in (("12.5", 12.5), ("1.5s", 45), ("500ms", 15), ("0", 0)):
            self.assertEqual(self.told("seek", text)[0]["playing"]["frame"], frame)
        for text, speed in (("0.5", 0.5), ("-1", -1), ("16", 16)):
            self.assertEqual(self.told("speed", text)[0]["playing"]["speed"], speed)
        for text, brightness in (("0", 0), ("255", 255), ("40%", 102)):
            self.assertEqual(self.told("brightness", text)[0]["playing"]["brightness"], brightness)
        self.assertEqual(self.ask("boot").stdout, "A: enters its boot loader\n")
        self.assertEqual(self.told("boot"), [{"device": "A"}])
        self.assertEqual(len(self.log.reports(BOOT)), 2)

    def test_wrong_steering(self):
        for command, text, says in (("seek", "later", "is no moment"), ("seek", "-1", "is no moment"),
                                    ("speed", "17", "is no speed"), ("speed", "fast", "is no speed"),
                                    ("brightness", "256", "is no brightness"), ("brightness", "101%", "is no brightness"),
                                    ("brightness", "-1", "is no brightness"), ("brightness", "%", "is no brightness")):
            self.refused(command, text, status=2, says=says)
        self.refused("seek", status=2, says="MOMENT is required")
        for seconds in ("nan", "inf", "0.01", "1e9", "1s"):
            self.refused("pause", "--timeout", seconds, status=2, says="is not a number from 0.1 to")


class ProgressTest(DeviceTest):
    def on_a_terminal(self, *arguments):
        """What a command writes to standard error, which is a terminal."""
        ours, theirs = pty.openpty()
        process = subprocess.Popen([KFAST, *map(str, arguments), *self.device], cwd=self.folder, stderr=theirs,
                                   stdout=subprocess.DEVNULL)
        os.close(theirs)
        written = b""
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError:
                break
            if not part:
                break
            written += part
        os.close(ours)
        self.assertEqual(process.wait(60), 0)
        return written.decode()

    def test_a_bar_on_a_terminal(self):
        self.board("A", "--microseconds", 3000)
        (self.folder / "some.kfast").write_text(large_scene(4000))
        bar = self.on_a_terminal("play", "some.kfast")
        self.assertRegex(bar, r"\r\[ {20}\]    0 %")
        self.assertRegex(bar, r"\r\[#+ +\]  +\d+ %  \d+\.\d KB/s  \d+ s left")
        self.assertRegex(bar, r"\r\[#{20}\]  100 %")
        self.assertTrue(re.search(r"\r +\r$", bar), "it goes away")
        for silent in ("--json", "--quiet"):
            self.assertEqual(self.on_a_terminal("play", "some.kfast", silent), "")

    def test_none_elsewhere(self):
        self.board()
        self.assertEqual(self.ask("play", "knobs.kfast").stderr, "")


class InterruptionTest(DeviceTest):
    def test_an_upload_that_is_interrupted_is_cancelled(self):
        board = self.board("A", "--microseconds", 20_000)
        (self.folder / "some.kfast").write_text(large_scene(4000))
        process = self.start("upload", "some.kfast")
        deadline = time.monotonic() + 60
        while len(board.reports(DATA)) < 5 and time.monotonic() < deadline:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output, errors), (INTERRUPTED, "", "kfast: interrupted\n"))
        while "gone" not in board.lines() and time.monotonic() < deadline:
            time.sleep(0.05)
        reports = board.reports()
        self.assertEqual(reports[-1][0], CANCEL)
        self.assertEqual(reports[-1][1], board.reports(BEGIN)[0][1])
        self.assertEqual(self.told("slots")[0]["slots"], [])
        self.ask("upload", "knobs.kfast")


if __name__ == "__main__":
    unittest.main()
