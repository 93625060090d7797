"""The scenes that are measured: the references and every example."""

import dataclasses
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
REFERENCES = ("eyes", "walker", "morph")


@dataclasses.dataclass(frozen=True)
class Scene:
    name: str
    text: pathlib.Path
    compiled: pathlib.Path

    @property
    def size(self):
        return self.compiled.stat().st_size


def scene_texts():
    """Name and file of each scene, the references first."""
    references = {name: ROOT / "examples" / "reference" / f"{name}.kfast" for name in REFERENCES}
    return references | {path.stem: path for path in sorted((ROOT / "examples").glob("*.kfast"))}


def compile_scenes(kfast, names, folder):
    texts = scene_texts()
    unknown = [name for name in names if name not in texts]
    if unknown:
        raise SystemExit(f"bench: there is no scene {', '.join(unknown)}; there are {', '.join(texts)}")
    return [compile_scene(kfast, name, texts[name], folder) for name in names or texts]


def compile_scene(kfast, name, text, folder):
    scene = Scene(name, text, pathlib.Path(folder, f"{name}.kfb"))
    subprocess.run([kfast, "compile", text, "-o", scene.compiled], check=True, stdout=subprocess.DEVNULL, timeout=120)
    return scene
