"""scripts/assemble: manifests and sources are whole, and agree with the project."""

import json
import pathlib
import re
import shutil
import subprocess
import unittest
import zipfile

from assembled import ROOT, assembled, output_of, temporary_folder

PROJECT = json.loads((ROOT / "packages/project.json").read_text(encoding="utf-8"))
VERSION = PROJECT["version"]
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)

# https://arduino.github.io/arduino-cli/latest/library-specification/#library-metadata
ARDUINO_FIELDS = {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures"}
ADDRESSES = {"mail": "lamp@example.org", "url": "https://example.org/lamp"}
# https://docs.platformio.org/en/latest/manifests/library-json: the fields, and those that there must be.
PLATFORMIO_FIELDS = {"$schema", "name", "version", "description", "keywords", "homepage", "repository", "authors", "license",
                     "frameworks", "platforms", "headers", "examples", "dependencies", "export", "scripts", "build"}
PLATFORMIO_REQUIRED = {"name", "version"}
PLATFORMIO_BUILD = {"flags", "unflags", "includeDir", "srcDir", "srcFilter", "extraScript", "libArchive", "libLDFMode",
                    "libCompatMode", "builder"}


class Assemble(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = temporary_folder(cls)
        cls.made = {kind: assembled(kind, cls.folder / kind) for kind in ("arduino", "platformio", "esp-idf")}

    def test_every_include_is_found_and_every_source_is_there(self):
        wanted = {str(path.relative_to(ROOT)) for folder in ("core", "library") for path in (ROOT / folder).rglob("*.[ch]*")}
        for kind, folder in self.made.items():
            sources = {str(path.relative_to(folder / "src")) for path in (folder / "src").rglob("*.*")}
            self.assertEqual(set(), {name for name in wanted if not name.endswith(".cmake")} - sources, kind)
            for name in sources - {"kfast_language.h"}:
                for included in INCLUDE.findall((folder / "src" / name).read_text()):
                    self.assertIn(included, sources, f"{kind}: {name}")

    def test_nothing_is_left_to_be_filled_in(self):
        for folder in self.made.values():
            for path in folder.glob("*.*"):
                self.assertIsNone(re.search(r"@[A-Z]+@", path.read_text()), path)

    def test_arduino_has_all_fields(self):
        lines = (self.made["arduino"] / "library.properties").read_text().splitlines()
        fields = dict(line.split("=", 1) for line in lines)
        self.assertLessEqual(ARDUINO_FIELDS - set(fields), {"url"} if PROJECT["url"] is None else set())
        self.assertTrue(all(fields.values()))
        self.assertEqual(VERSION, fields["version"])
        self.assertTrue((self.made["arduino"] / "src" / fields["includes"]).is_file())

    def test_arduino_knows_the_words_of_the_player(self):
        header = "".join((ROOT / "library" / name).read_text() for name in ("kfast_player.hpp", "kfast.h"))
        lines = (self.made["arduino"] / "keywords.txt").read_text().splitlines()
        self.assertGreater(len(lines), 10)
        for line in lines:
            word, kind = line.split("\t")
            self.assertRegex(header, rf"\b{word}\b")
            self.assertIn(kind, {"KEYWORD1", "KEYWORD2", "LITERAL1"})

    def test_every_sketch_has_the_name_of_its_folder_and_its_scene(self):
        sketches = sorted((self.made["arduino"] / "examples").iterdir())
        self.assertGreater(len(sketches), 3)
        for sketch in sketches:
            self.assertTrue((sketch / f"{sketch.name}.ino").is_file())
            self.assertTrue((sketch / "robot_eyes.h").is_file())

    def test_platformio_has_only_fields_that_there_are(self):
        manifest = json.loads((self.made["platformio"] / "library.json").read_text())
        self.assertEqual(set(), set(manifest) - PLATFORMIO_FIELDS)
        self.assertEqual(set(), PLATFORMIO_REQUIRED - set(manifest))
        self.assertEqual(set(), set(manifest["build"]) - PLATFORMIO_BUILD)
        self.assertEqual(VERSION, manifest["version"])
        for header in manifest["headers"]:
            self.assertTrue((self.made["platformio"] / "src" / header).is_file())

    def test_the_component_registers_every_source(self):
        script = self.folder / "register.cmake"
        script.write_text("""
            function(idf_component_register)
                cmake_parse_arguments(PARSE_ARGV 0 COMPONENT "" "" "SRCS;INCLUDE_DIRS")
                list(JOIN COMPONENT_SRCS "\\n" ALL)
                file(WRITE ${ROOT}/../registered "${ALL}\\n${COMPONENT_INCLUDE_DIRS}")
            endfunction()
            include(${ROOT}/CMakeLists.txt)
        """)
        folder = self.made["esp-idf"]
        output_of("cmake", f"-DROOT={folder}", "-P", script)
        *sources, includes = (folder.parent / "registered").read_text().splitlines()
        self.assertEqual(sorted(map(str, (folder / "src").rglob("*.cpp"))), sorted(sources))
        self.assertEqual("src", includes)
        self.assertIn(f'version: "{VERSION}"\n', (folder / "idf_component.yml").read_text())

    def test_examples_for_the_esp32_ask_for_enough_stack(self):
        bound = int(re.search(r"stack_bound = (\d+);", (ROOT / "host/fit/scene_needs.cpp").read_text()).group(1))
        settings = (self.made["esp-idf"] / "examples/robot_eyes/sdkconfig.defaults").read_text()
        told = [int(re.search(r"(?m)^CONFIG_ESP_MAIN_TASK_STACK_SIZE=(\d+)$", settings).group(1))]
        for sketch in (self.made["arduino"] / "examples").rglob("*.ino"):
            kilobytes = re.search(r"(?m)^SET_LOOP_TASK_STACK_SIZE\((\d+) \* 1024\);", sketch.read_text())
            told.append(1024 * int(kilobytes.group(1)))
        self.assertGreater(min(told), 3 * bound // 2)

    def test_what_is_there_is_not_written_over(self):
        again = subprocess.run([ROOT / "scripts/assemble", "arduino", self.folder / "arduino"], capture_output=True, text=True)
        self.assertEqual(1, again.returncode)
        self.assertIn("exists already", again.stderr)

    def project_with(self, name, *files, **facts):
        """A copy of what scripts/assemble needs, with other facts in packages/project.json."""
        project = self.folder / name
        for folder in ("core", "library", "packages", "examples", "scripts"):
            shutil.copytree(ROOT / folder, project / folder)
        for file in files:
            shutil.copy(ROOT / file, project)
        (project / "packages/project.json").write_text(json.dumps(PROJECT | facts), encoding="utf-8")
        return project

    def manifests(self, project):
        texts = {}
        for kind, name in ("arduino", "library.properties"), ("platformio", "library.json"), ("esp-idf", "idf_component.yml"):
            made = output_of(project / "scripts/assemble", kind, project / "made" / kind, text=True).strip()
            texts[name] = (pathlib.Path(made) / name).read_text(encoding="utf-8")
        return texts

    def test_addresses_of_the_project_are_those_of_one_file(self):
        texts = self.manifests(self.project_with("addressed", "LICENSE", **ADDRESSES))
        self.assertIn("\nurl=https://example.org/lamp\n", texts["library.properties"])
        self.assertIn("\nmaintainer=The KFAST authors <lamp@example.org>\n", texts["library.properties"])
        manifest = json.loads(texts["library.json"])
        self.assertEqual(ADDRESSES["url"], manifest["homepage"])
        self.assertEqual(ADDRESSES["mail"], manifest["authors"][0]["email"])
        self.assertIn('\nurl: "https://example.org/lamp"\n', texts["idf_component.yml"])
        self.assertIn('\n  - "The KFAST authors <lamp@example.org>"\n', texts["idf_component.yml"])

    def test_addresses_that_are_not_set_are_left_out(self):
        texts = self.manifests(self.project_with("without", "LICENSE", mail=None, url=None))
        self.assertNotRegex("".join(texts.values()), r"(?m)^ *\W?(url|homepage|email)\b|@|None|invalid")
        self.assertIn("\nmaintainer=The KFAST authors\n", texts["library.properties"])
        self.assertEqual([{"name": "The KFAST authors", "maintainer": True}], json.loads(texts["library.json"])["authors"])

    def test_an_address_that_is_none_is_refused(self):
        project = self.project_with("refused", "LICENSE")
        for name, value in ("url", "example.org"), ("mail", "lamp"), ("version", None), ("lamp", "lit"):
            (project / "packages/project.json").write_text(json.dumps(PROJECT | {name: value}), encoding="utf-8")
            result = subprocess.run([project / "scripts/assemble", "arduino", project / "made"], capture_output=True, text=True)
            self.assertEqual(1, result.returncode)
            self.assertIn("packages/project.json: ", result.stderr)
            self.assertIn(name, result.stderr)

    def test_nothing_is_left_of_what_fails(self):
        project = self.project_with("project")  # and no LICENSE
        for kind in self.made:
            result = subprocess.run([project / "scripts/assemble", kind, project / "made", "--zip"], capture_output=True, text=True)
            self.assertNotEqual(0, result.returncode)
            self.assertIn("LICENSE", result.stderr)
            self.assertEqual([], list((project / "made").iterdir()))

    def test_a_zip_holds_the_folder(self):
        _, name = output_of(ROOT / "scripts/assemble", "arduino", self.folder / "zipped", "--zip", text=True).splitlines()
        with zipfile.ZipFile(name) as archive:
            self.assertIn("KFAST/library.properties", archive.namelist())
            self.assertIn("KFAST/src/core/player.cpp", archive.namelist())


if __name__ == "__main__":
    unittest.main()
