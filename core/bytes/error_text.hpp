#pragma once

#include "core/bytes/result.hpp"

#include <string_view>

namespace kfast {

/// The name of an error and what it means, for people, with a 0 behind it: "bad_magic: not a compiled scene".
constexpr std::string_view error_text(Error error)
{
    using namespace std::string_view_literals; // of known length: nothing calls strlen
    switch (error) {
    case Error::truncated:
        return "truncated: the bytes end before the scene does"sv;
    case Error::bad_magic:
        return "bad_magic: not a compiled scene"sv;
    case Error::unsupported_version:
        return "unsupported_version: compiled for another version of the format"sv;
    case Error::bad_checksum:
        return "bad_checksum: the scene was damaged on the way"sv;
    case Error::bad_scene:
        return "bad_scene: a value is out of its range or refers to nothing"sv;
    case Error::block_too_small:
        return "block_too_small: the scene needs more memory than the board lends"sv;
    case Error::too_slow:
        return "too_slow: a picture of the scene takes longer than a second"sv;
    case Error::needs_strokes:
        return "needs_strokes: the program was built without strokes"sv;
    case Error::needs_tweens:
        return "needs_tweens: the program was built without tweens"sv;
    case Error::needs_bones:
        return "needs_bones: the program was built without bones"sv;
    case Error::needs_backbones:
        return "needs_backbones: the program was built without backbones"sv;
    case Error::needs_depth:
        return "needs_depth: the program was built without depth"sv;
    case Error::needs_wires:
        return "needs_wires: the program was built without wire frames"sv;
    case Error::needs_paths:
        return "needs_paths: the program was built without paths"sv;
    case Error::needs_smooth:
        return "needs_smooth: the program was built without smooth tracks"sv;
    case Error::needs_texts:
        return "needs_texts: the program was built without texts"sv;
    case Error::needs_drawings:
        return "needs_drawings: the program was built without drawings as inputs"sv;
    }
    return ""sv;
}

}
