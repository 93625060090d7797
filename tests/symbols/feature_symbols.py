"""Checks that an image has only the features it names: feature_symbols.py <nm> <image without features> <image with all>

What is called by its name from anywhere else would be linked all the same (docs/design.md, "What a program leaves out")."""

import re
import subprocess
import sys
import unittest

NM, BARE, WHOLE = sys.argv[1:4]

# Of each feature something that nothing else may have.
CODE = {
    "strokes": r"kfast::StrokeOutline::|kfast::to_polar",
    "tweens": r"kfast::(EqualizedPair|BrokenDrawing|PosedStrokes|TweenWriter)\b|kfast::trace_kept",
    "bones": r"kfast::PosedBone::pose|kfast::pose_bones|kfast::are_bones_valid|kfast::SkinReader::next",
    "backbones": r"kfast::PosedBackbones::|kfast::SceneCheck::check_backbones",
    "depth": r"kfast::Projection::|kfast::tilted|kfast::product_in_depth",
    "wires": r"kfast::PosedWires::|kfast::SceneCheck::check_depths",
    "paths": r"kfast::place_on|kfast::SceneCheck::check_path",
    "smooth": r"kfast::hermite|kfast::PreparedScene::smooth_value",
    "texts": r"kfast::LabelTrace::|kfast::is_label_valid|kfast::LabelLayout::",
    "drawings": r"kfast::trace_live_strokes|kfast::InputDrawings::show_default",
    "trims": r"kfast::StrokeTrimmer::|kfast::trace_trimmed",
    "springs": r"kfast::spring_progress",
}


def symbols(image):
    return subprocess.run([NM, "-C", image], check=True, capture_output=True, text=True, timeout=60).stdout


class Features(unittest.TestCase):
    def test_without_features_nothing_of_their_code_is_linked(self):
        bare, whole = symbols(BARE), symbols(WHOLE)
        for feature, pattern in CODE.items():
            with self.subTest(feature=feature):
                self.assertNotEqual([], re.findall(pattern, whole))
                self.assertEqual([], re.findall(pattern, bare))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
