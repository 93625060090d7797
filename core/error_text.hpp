#pragma once

#include "core/result.hpp"

namespace kfast {

/// The name of an error and what it means, for people: "bad_magic: not a compiled scene".
constexpr const char* error_text(Error error)
{
    switch (error) {
    case Error::truncated:
        return "truncated: the bytes end before the scene does";
    case Error::bad_magic:
        return "bad_magic: not a compiled scene";
    case Error::unsupported_version:
        return "unsupported_version: compiled for another version of the format";
    case Error::bad_checksum:
        return "bad_checksum: the scene was damaged on the way";
    case Error::bad_scene:
        return "bad_scene: a value is out of its range or refers to nothing";
    case Error::block_too_small:
        return "block_too_small: the scene needs more memory than the board lends";
    }
    return "";
}

}
