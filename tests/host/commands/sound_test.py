"""Sound for oscilloscopes, as a file and as it is played: sound_test.py <kfast>."""

import unittest
import wave

from command_case import CommandTest

SCENE = """kfast 1
canvas 100 100 fps=30 loop=repeat
object a stroke="#ffffff" width=1 {
    key 0 { line 10 10 90 10 90 70 }
    key 30 { line 30 90 20 40 90 20 }
}
object b stroke="#ffffff" width=1 { line 40 50 60 50 }
"""
STILL = """kfast 1
canvas 100 100 fps=30 loop=repeat
object a stroke="#ffffff" width=1 { line 10 10 90 10 90 70 }
object b stroke="#ffffff" width=1 { line 40 50 60 50 }
"""
TRAVEL = 6554  # units of the field in a sample: sound_profile


def points_of(data, size):
    """Of samples of so many bytes, as pairs."""
    values = [int.from_bytes(data[at:at + size], "little", signed=True) for at in range(0, len(data), size)]
    return list(zip(values[0::2], values[1::2]))


def longest_step(points):
    return max(((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5 for a, b in zip(points, points[1:]))


class Sounds(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "scene.kfast").write_text(SCENE)
        (self.folder / "still.kfast").write_text(STILL)

    def wave(self, scene, *arguments):
        """The points, and what was said."""
        told = self.run_kfast("export", "--wav", f"{scene}.kfast", "-o", "a.wav", *arguments)
        with wave.open(str(self.folder / "a.wav")) as sound:
            self.assertEqual(sound.getnchannels(), 2)
            self.rate, self.bytes = sound.getframerate(), sound.getsampwidth()
            return points_of(sound.readframes(sound.getnframes()), self.bytes), told


class ExportedTest(Sounds):
    def test_rate_bits_and_length(self):
        for rate, bits in ((44100, 16), (48000, 24), (96000, 16), (192000, 24)):
            with self.subTest(rate=rate, bits=bits):
                points, told = self.wave("scene", "--sample-rate", rate, "--bits", bits)
                self.assertEqual((self.rate, self.bytes), (rate, bits // 8))
                self.assertEqual(len(points), rate)
                self.assertIn("a.wav: 1 s, ", told.stdout)
        self.assertEqual(len(self.wave("scene", "--seconds", "2.5")[0]), 120000)
        self.assertEqual(len(self.wave("scene", "--speed", "0.5")[0]), 96000)
        self.assertEqual(len(self.wave("marked", "--clip", "blink")[0]), 8000, "the end is held for a frame")

    def test_nothing_clicks_within_nor_from_the_end_to_the_beginning(self):
        for arguments in ((), ("--sample-rate", 96000), ("--seconds", "1.7")):
            points, _ = self.wave("scene", *arguments)
            self.assertLess(longest_step(points + points[:1]), TRAVEL + 2)

    def test_x_is_left_and_right_is_positive_and_y_is_right_and_up_is_positive(self):
        points, _ = self.wave("still")
        xs, ys = zip(*points)
        self.assertAlmostEqual(min(xs), -0.4 * 65536, delta=300)
        self.assertAlmostEqual(max(xs), 0.4 * 65536, delta=300)
        self.assertAlmostEqual(min(ys), -0.2 * 65536, delta=300)
        self.assertAlmostEqual(max(ys), 0.4 * 65536, delta=300)

    def test_swap_invert_and_gain(self):
        plain, _ = self.wave("scene")
        self.assertTrue(self.wave("scene", "--swap")[0] == [(y, x) for x, y in plain])
        self.assertTrue(self.wave("scene", "--mirror", "x")[0] == [(-x, y) for x, y in plain])
        self.assertTrue(self.wave("scene", "--mirror", "y")[0] == [(x, -y) for x, y in plain])
        self.assertTrue(self.wave("scene", "--mirror", "both", "--swap")[0] == [(-y, -x) for x, y in plain])
        for (x, y), (half_x, half_y) in zip(plain, self.wave("scene", "--gain", "0.5")[0]):
            self.assertLessEqual(max(abs(x / 2 - half_x), abs(y / 2 - half_y)), 0.5)

    def test_the_middle_is_told_for_cards_that_do_not_pass_it(self):
        points, told = self.wave("still")
        x, y = (sum(values) / len(values) / 655.36 for values in zip(*points))
        self.assertIn(f"middle at {round(x, 1):g} % {round(y, 1):g} %", told.stdout)

    def test_wrong_usage(self):
        for arguments, says in ((("--sample-rate", "7999"), "--sample-rate"), (("--bits", "8"), "--bits"), (("--gain", "0"), "--gain"),
                                (("--mirror", "z"), "--mirror"), (("--seconds", "nan"), "--seconds"),
                                (("--ilda-format", "5"), "--ilda-format requires --ild"), (("--size", "9x9"), "--size")):
            with self.subTest(says=says):
                self.refuse("export", "--wav", "still.kfast", *arguments, status=2, says=says)
        self.refuse("export", "--wav", "still.kfast", "--seconds", "86400", status=1, says="less --seconds")
        self.refuse("export", "--wav", "still.kfast", "-o", "still.kfast", status=1, says="overwrite the scene")

    def test_a_full_disk_leaves_what_was_there(self):
        (self.folder / "a.wav").write_text("before")
        self.refuse("export", "--wav", "still.kfast", "-o", "a.wav", status=1, says="a.wav", limit=1000)
        self.assertEqual((self.folder / "a.wav").read_text(), "before")


class HeardTest(Sounds):
    """What is played, written to a file by SDL instead."""

    def heard(self, scene, *arguments):
        self.run_kfast("preview", f"{scene}.kfast", "--audio", "--loops", 1, *arguments, environment={
            "SDL_AUDIODRIVER": "disk", "SDL_DISKAUDIOFILE": str(self.folder / "heard"), "SDL_VIDEODRIVER": "dummy"})
        return points_of((self.folder / "heard").read_bytes(), 4)

    def test_a_still_scene_is_heard_as_it_is_exported(self):
        (self.folder / "still.kfast").write_text(STILL.replace("fps=30", "fps=1"))
        for arguments in ((), ("--swap", "--mirror", "y", "--gain", "0.5", "--sample-rate", "44100")):
            heard = [(x + 0x8000 >> 16, y + 0x8000 >> 16) for x, y in self.heard("still", *arguments)]
            exported, _ = self.wave("still", "--seconds", "60", *arguments)
            begin = heard.index(exported[0])
            self.assertGreater(len(heard) - begin, 2000)
            self.assertTrue(heard[begin:] == exported[:len(heard) - begin], "a wave of its own")

    def test_another_profile_is_heard_and_seen(self):
        heard = [(x / 65536, y / 65536) for x, y in self.heard("scene", "--beam", "crt")]
        self.assertLess(longest_step(heard), 2048 * 2 + 2)  # in haste, for there are fewer points in a second
        self.assertGreater(len(set(heard)), 300)  # one picture at least, on however busy a computer

    def test_nothing_clicks_while_pictures_change(self):
        heard = [(x / 65536, y / 65536) for x, y in self.heard("scene")]
        self.assertGreater(len(set(heard)), 1000)
        self.assertLess(longest_step(heard), TRAVEL + 2)

    def test_without_a_sound_card(self):
        nowhere = {"SDL_AUDIODRIVER": "none-such"}
        self.refuse("preview", "still.kfast", "--audio", status=1, says="there is no sound", environment=nowhere)
        self.refuse("preview", "--audio-devices", status=1, says="there is no sound", environment=nowhere)

    def test_devices(self):
        dummy = {"SDL_AUDIODRIVER": "dummy", "SDL_VIDEODRIVER": "dummy"}
        names = self.run_kfast("preview", "--audio-devices", environment=dummy).stdout.splitlines()
        self.assertEqual(len(names), 1)
        self.run_kfast("preview", "still.kfast", "--audio", "--loops", 1, "--audio-device", names[0], environment=dummy)

    def test_wrong_usage(self):
        self.refuse("preview", "still.kfast", "--sample-rate", "48000", status=2, says="--sample-rate requires --audio")
        self.refuse("preview", "still.kfast", "--audio", "--headless", status=2, says="excludes")


if __name__ == "__main__":
    unittest.main()
