"""Whether kfast draws a Lottie animation as rlottie does:

    lottie_pictures_test.py KFAST RLOTTIE_FRAMES ANIMATION.json [FOLDER_FOR_PICTURES]

Where an animation NAME_by_hand.json lies beside it, rlottie draws that instead. It shows the same without a feature that
rlottie 0.1 has not, or has otherwise than the format and its first player, lottie-web, have it: it turns stars twice as
far, draws parts of points that a star has not whole, lets the first copy of a repeater lie lowest in any case, leaves out
the last one while their number is none, counts their opacity to one copy more than there are, and knows no skew, no
rounded corners, and no dashes without length; corners of polygons it rounds as far whatever their number. It measures
curves and slanting lines roughly, and does not join the dashes where a closed path begins: dashes are compared along other
lines. Gradients are compared with the colours that stand in for them."""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import compare_pictures  # noqa: E402

SHARES = (0, 1 / 6, 1 / 3, 1 / 2, 3 / 4, 1)

# Limits other than those of compare_pictures, each with its reason.
NOTCHES = "rlottie leaves a notch on the inner side of a corner that is next to the end of a line"
HALF_LEVELS = "rlottie cuts 127.5 to 127, kfast rounds it to 128: another level of RGB565"
CHORDS = "rlottie's caps at a cut stand across the chord that was cut, kfast's across the curve"
LEANS = "rlottie's polygons lean a little, and their sides differ"
LIMITS = {
    "polystars": ({"worst": 28, "near": 0.985}, LEANS),
    "trim": ({"worst": 20}, CHORDS),
    "trim_several": ({"worst": 40}, NOTCHES),
    "moving_dashes": ({"worst": 40}, NOTCHES),
    "fill_colours": ({"mean": 3}, HALF_LEVELS),
}


def frames_of(animation):
    """Whole frames, for rlottie draws no others."""
    last = animation["op"] - animation["ip"] - 1
    return sorted({round(share * last) for share in SHARES})


def run(*arguments):
    finished = subprocess.run([str(argument) for argument in arguments], capture_output=True, text=True)
    if finished.returncode != 0:
        sys.exit(f"{' '.join(map(str, arguments))}: {finished.stderr}")


def reference_for(animation):
    by_hand = animation.with_name(animation.stem + "_by_hand.json")
    return by_hand if by_hand.exists() else animation


def main(kfast, rlottie_frames, animation, folder):
    content = json.loads(animation.read_text())
    frames = frames_of(content)
    references = {frame: folder / f"{animation.stem}-{frame:02}-rlottie.png" for frame in frames}
    run(rlottie_frames, reference_for(animation), content["w"], content["h"],
        *(word for frame, picture in references.items() for word in (frame, picture)))
    wrong = False
    for frame, reference in references.items():
        picture = folder / f"{animation.stem}-{frame:02}-kfast.png"
        run(kfast, "render", animation, "--frame", frame, "-o", picture)
        difference = compare_pictures.compare(picture, reference)
        problems = difference.problems(**LIMITS.get(animation.stem, ({}, ""))[0])
        print(f"{animation.stem} at {frame}: {difference}", *problems, sep="\n    ")
        wrong = wrong or bool(problems)
    return 1 if wrong else 0


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        sys.exit(main(sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]),
                      pathlib.Path(sys.argv[4] if len(sys.argv) > 4 else temporary)))
