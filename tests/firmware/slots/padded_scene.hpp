#pragma once

#include "core/bytes/crc32.hpp"
#include "tests/compiled.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace kfast::test {

/// A scene that plays, with the inputs "gaze" and "lid" and the clip "rise".
inline std::vector<std::byte> playable_scene(const std::string& radius)
{
    return compiled("kfast 1\ncanvas 64 48 frames=60\ninput gaze min=-1 max=1\ninput lid min=0 max=1\n"
                    "object sun fill=yellow { circle 10 24 r=" +
                    radius +
                    "; track x input=gaze { at -1 0; at 1 40 } }\n"
                    "object lid fill=red { rect 1 1 9 9; track y input=lid { at 0 0; at 1 30 } }\n"
                    "clip rise from=10 to=30\n");
}

/// Such a scene, another one for seeds that follow each other, and behind it random bytes, which belong to no
/// scene, up to `size` bytes; less than the scene itself are not possible.
inline std::vector<std::byte> padded_scene(std::size_t size, std::uint32_t seed)
{
    static const std::array scenes{playable_scene("8"), playable_scene("9"), playable_scene("7")};
    std::vector<std::byte> bytes = scenes[seed % scenes.size()];
    std::mt19937 random{seed};
    while (bytes.size() < size)
        bytes.push_back(static_cast<std::byte>(random() & 255));
    return bytes;
}

inline std::uint32_t crc_of(std::span<const std::byte> bytes)
{
    Crc32 crc;
    crc.add(bytes);
    return crc.value();
}

}
