#pragma once

#include "core/bytes/expects.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace kfast {

/// Everything the device side can refuse. Each function lists which of these it returns. Boards show the
/// number, so it stays what it is.
enum class Error : std::uint8_t {
    truncated = 1,       ///< the bytes end before the scene does
    bad_magic,           ///< not a compiled scene
    unsupported_version, ///< compiled for another version of the format
    bad_checksum,        ///< the bytes were damaged on the way
    bad_scene,           ///< a value in the scene is out of its range, or refers to nothing
    block_too_small,     ///< the caller lent less memory than the scene needs
    too_slow, ///< a picture of the scene takes longer than a second (core/scene/check/picture_cost.hpp)
    // The scene needs a feature that the program was built without (core/features.hpp), in their order.
    needs_strokes = 64,
    needs_tweens,
    needs_bones,
    needs_backbones,
    needs_depth,
    needs_wires,
    needs_paths,
    needs_smooth,
    needs_texts,
    needs_drawings,
    needs_trims,
    needs_springs,
};

/// A value or the reason why there is none; the part of std::expected (C++23) that KFAST needs.
template <class T>
class [[nodiscard]] Result {
public:
    constexpr Result(T value) : value_{std::move(value)} {}
    constexpr Result(Error error) : error_{error} {}
    /// Constructs the value in place, as a small stack may have no room to copy it.
    template <class... Arguments>
    constexpr explicit Result(std::in_place_t, Arguments&&... arguments)
        : value_{std::in_place, std::forward<Arguments>(arguments)...}
    {
    }

    constexpr explicit operator bool() const { return value_.has_value(); }

    /// Only when the result holds a value.
    constexpr T& operator*() { return *operator->(); }
    constexpr const T& operator*() const { return *operator->(); }
    constexpr T* operator->()
    {
        expects(value_.has_value());
        return &*value_;
    }
    constexpr const T* operator->() const
    {
        expects(value_.has_value());
        return &*value_;
    }

    /// Only when the result holds no value.
    constexpr Error error() const
    {
        expects(!value_.has_value());
        return error_;
    }
    /// From now on there is no value.
    constexpr void fail(Error error)
    {
        value_.reset();
        error_ = error;
    }

private:
    std::optional<T> value_;
    Error error_{};
};

/// The name of an error and what it means, for people, followed by a 0: "bad_magic: not a compiled scene".
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
    case Error::needs_trims:
        return "needs_trims: the program was built without strokes that are drawn in part or dashed"sv;
    case Error::needs_springs:
        return "needs_springs: the program was built without springs and bounces"sv;
    }
    return ""sv;
}

}
