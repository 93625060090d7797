"""`kfast completions`: what bash offers is what there is; zsh and fish at least read their scripts."""

import re
import shutil
import subprocess
import unittest

from command_case import CommandTest

PRINT = "COMP_WORDS=({words})\nCOMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))\n_kfast\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"\n"


class CompletionsTest(CommandTest):
    def script(self, shell):
        return self.run_kfast("completions", shell).stdout

    def offered_lines(self, *words):
        """What bash offers for the last of the words."""
        quoted = " ".join(f"'{word}'" for word in ("kfast", *words))
        program = self.script("bash") + PRINT.format(words=quoted)
        result = subprocess.run(["bash", "--norc", "-c", program], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout.splitlines()

    def offered(self, *words):
        return {word for line in self.offered_lines(*words) for word in line.split()}

    def commands(self, *before):
        return set(re.findall(r"^  ([a-z][a-z0-9-]*) {2,}", self.run_kfast(*before, "--help").stdout, re.MULTILINE))

    def test_commands(self):
        self.assertLessEqual(self.commands(), self.offered(""))
        self.assertEqual(self.offered("ren"), {"render"})
        self.assertEqual(self.offered("uf2", "") - {"-h", "--help"}, {"pack", "unpack", "info"})

    def test_options_without_a_command(self):
        for name in ("--help", "--version"):
            self.assertIn(name, self.offered("--"))
            self.assertIn(f"        '{name}:", self.script("zsh"))
            self.assertIn(f"-n '__fish_use_subcommand' -l {name[2:]} ", re.sub(r" -s \w", "", self.script("fish")))

    def test_all_options_of_all_commands(self):
        ways = [(command,) for command in sorted(self.commands() - {"uf2"})]
        ways += [("uf2", command) for command in ("pack", "unpack", "info")]
        self.assertGreater(len(ways), 30)
        for way in ways:
            with self.subTest(command=way):
                shown = set(re.findall(r"^ +(?:-\w, )*(--[a-z-]+)", self.run_kfast(*way, "--help").stdout, re.MULTILINE))
                self.assertEqual({name for name in self.offered(*way, "--") if name.startswith("--")}, shown)

    def test_choices(self):
        self.assertEqual(self.offered("render", "a.kfast", "--panel", "ssd13"), {"ssd1306", "ssd1351"})
        self.assertEqual(self.offered("render", "a.kfast", "--panel", "=", "ssd13"), {"ssd1306", "ssd1351"})
        self.assertEqual(self.offered("fit", "a.kfast", "--board", "pico", "--panel", "ssd13"), {"ssd1306", "ssd1322", "ssd1351"})
        self.assertIn("rgb565_be", self.offered("preview", "--format", ""))
        self.assertIn("pico-xy", self.offered("fit", "--board", "pi"))
        self.assertIn("pico-st7789", self.offered("wiring", ""))
        self.assertEqual(self.offered("new", "a.kfast", "--like", "wea"), {"weather"})
        self.assertEqual(self.offered("panel", "--rotation", ""), {"0", "90", "180", "270"})
        self.assertEqual(self.offered("completions", ""), {"bash", "zsh", "fish"})
        self.assertIn("galvo", self.offered("export", "--beam", ""))

    def test_files(self):
        for name in ("b.json", "b.txt", "b.uf2", "b c.kfast"):
            (self.folder / name).write_text("")
        (self.folder / "behind").mkdir()
        found = self.offered("preview", "b")
        self.assertLessEqual({"b.json", "behind", "c.kfast"}, found)
        self.assertTrue(found.isdisjoint({"b.txt", "b.uf2"}))
        self.assertIn("repeat.kfast", self.offered("check", ""))
        self.assertIn("b.txt", self.offered("render", "once.kfast", "-o", "b"))

    def test_bash_offers_names_as_they_are(self):
        for name in ("a.kfast", "[a].kfast", "b*.kfast", "bc.kfast", "two words.kfast"):
            (self.folder / name).write_text("")
        for typed, names in (("[", ["[a].kfast"]), ("b", ["b*.kfast", "bc.kfast"]), ("two", ["two words.kfast"])):
            self.assertEqual(sorted(self.offered_lines("check", typed)), names)
            self.assertEqual(sorted(self.offered_lines("render", "a.kfast", "-o", typed)), names)

    def check_syntax(self, shell):
        if shutil.which(shell) is None:
            self.skipTest(f"there is no {shell}")
        path = self.folder / "script"
        path.write_text(self.script(shell))
        result = subprocess.run([shell, "-n", path], capture_output=True, text=True, timeout=120)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_bash_reads_its_script(self):
        self.check_syntax("bash")

    def test_zsh_reads_its_script(self):
        self.check_syntax("zsh")
        program = "autoload -U compinit && compinit -D -u && source ./script && print $_comps[kfast]"
        result = subprocess.run(["zsh", "-f", "-c", program], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual((result.stdout, result.stderr), ("_kfast\n", ""))

    def test_fish_offers_what_bash_does(self):
        self.check_syntax("fish")
        self.assertLessEqual({"ssd1306", "ssd1351"}, self.fish_offers("render --panel ssd13"))
        self.assertIn("pack", self.fish_offers("uf2 "))
        self.assertNotIn("pack", self.fish_offers("uf2 info "))
        (self.folder / "b.txt").write_text("")
        (self.folder / "a.kfb").write_text("")
        (self.folder / "scenes").mkdir()
        offered = self.fish_offers("check ") | self.fish_offers("fit ")
        self.assertLessEqual({"repeat.kfast", "a.kfb", "scenes/"}, offered)
        self.assertNotIn("b.txt", offered)

    def fish_offers(self, words):
        result = subprocess.run(["fish", "--no-config", "-c", f"{self.script('fish')}complete -C 'kfast {words}'"],
                                cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(result.stderr, "")
        return {line.split("\t")[0] for line in result.stdout.splitlines()}

    def test_each_option_stands_in_every_script(self):
        for shell in ("zsh", "fish"):
            script = self.script(shell)
            for word in ("phosphor", "ssd1351", "rgb565_be", "pico-st7789", "unpack", "kfast"):
                self.assertIn(word, script)

    def test_wrong_usage(self):
        self.refuse("completions", "zhs", status=2, says='did you mean "zsh"?')
        self.refuse("completions", status=2, says="SHELL")


class ManTest(CommandTest):
    def test_pages_of_all_commands(self):
        self.run_kfast("man", "pages/man")
        names = {path.name for path in (self.folder / "pages/man").glob("man*/*")}
        commands = set(re.findall(r"^  ([a-z][a-z0-9-]*) {2,}", self.run_kfast("--help").stdout, re.MULTILINE))
        self.assertEqual(names, {"kfast.1", "kfast-scene.5", *(f"kfast-{name}.1" for name in commands),
                                 "kfast-uf2-pack.1", "kfast-uf2-unpack.1", "kfast-uf2-info.1"})
        self.assertEqual((self.folder / "pages/man/man1/kfast.1").read_text(), self.run_kfast("man").stdout)

    def test_groff_reads_them(self):
        if shutil.which("groff") is None:
            self.skipTest("there is no groff")
        self.run_kfast("man", "pages")
        for path in sorted((self.folder / "pages").glob("man*/*")):
            with self.subTest(page=path.name):
                result = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-Kutf8", "-z", path], capture_output=True, text=True,
                                        timeout=120)
                self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_they_say_what_the_help_says(self):
        self.run_kfast("man", "pages")
        text = (self.folder / "pages/man1/kfast-render.1").read_text().replace("\\-", "-").replace("\\fB", "").replace("\\fR", "")
        self.assertIn("--panel", text)
        self.assertEqual(text.count("--help"), 1)
        self.assertIn("A known panel: st7789", text)
        self.assertIn("kfast render eyes.kfast --time 1.5s -o eyes.png", text)
        scene = (self.folder / "pages/man5/kfast-scene.5").read_text()
        for words in ("circle CX CY r=RADIUS", "number, 0 to 4094 px", "steps(n)"):
            self.assertIn(words, scene)

    def test_a_folder_that_cannot_be(self):
        self.refuse("man", "repeat.kfast", status=1, says="repeat.kfast")


if __name__ == "__main__":
    unittest.main()
