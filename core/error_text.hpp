#pragma once

#include "core/result.hpp"

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
    }
    return ""sv;
}

}
