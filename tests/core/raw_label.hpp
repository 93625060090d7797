#pragma once

#include "tests/core/raw_scene.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace kfast::test {

/// Two glyphs and what is added between them.
struct RawPair {
    int left = 0;
    int right = 0;
    std::int32_t by = 0;
};

/// How a label writes a number.
struct RawFormat {
    int decimals = 0;
    int digits = 1;
    int places = 0;
    std::vector<int> before = {};
    std::vector<int> behind = {};

    Bytes bytes() const
    {
        ByteWriter writer;
        writer.u8(static_cast<std::uint32_t>(decimals));
        writer.u8(static_cast<std::uint32_t>(digits + 16 * places));
        for (const std::vector<int>* glyphs : {&before, &behind}) {
            writer.u8(static_cast<std::uint32_t>(glyphs->size()));
            for (const int glyph : *glyphs)
                writer.u8(static_cast<std::uint32_t>(glyph));
        }
        return writer.bytes();
    }
};

/// A label put together by hand, of as many glyphs as it has drawings and advances.
struct RawLabel {
    int align = 0; ///< and other bits of the first byte
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t spacing = 0;
    std::vector<std::int32_t> drawings;
    std::vector<std::int32_t> advances;
    std::vector<RawPair> pairs = {};
    std::optional<RawFormat> format = {};

    Bytes bytes() const
    {
        ByteWriter writer;
        writer.u8(static_cast<std::uint32_t>(align + (format ? 4 : 0)));
        for (const std::int32_t value : {x, y, spacing})
            writer.signed_varint(value);
        writer.u8(static_cast<std::uint32_t>(drawings.size()));
        writer.append(value_bytes(drawings));
        writer.append(value_bytes(advances));
        writer.u16(static_cast<std::uint32_t>(pairs.size()));
        std::vector<std::int32_t> kerning;
        for (const RawPair& pair : pairs) {
            writer.u16(static_cast<std::uint32_t>(pair.left) << 8 | static_cast<std::uint32_t>(pair.right));
            kerning.push_back(pair.by);
        }
        if (!kerning.empty())
            writer.append(value_bytes(kerning));
        if (format)
            writer.append(format->bytes());
        return writer.bytes();
    }

    /// A filled item that shows the input.
    Bytes item(int input = 0) const { return joined({test::bytes({0x0B, 1, input, 1}), block(bytes())}); }
};

/// An input that is a text of `count` characters from `first` on.
inline Bytes text_input_bytes(std::string_view name, int max, int count, char32_t first,
                              std::initializer_list<int> default_value = {})
{
    ByteWriter writer;
    writer.u8(1);
    writer.u8(static_cast<std::uint32_t>(name.size()));
    for (const char letter : name)
        writer.u8(static_cast<std::uint8_t>(letter));
    writer.u8(static_cast<std::uint32_t>(max));
    writer.u8(static_cast<std::uint32_t>(count));
    writer.u8(1);
    writer.u32(std::uint32_t{first} << 8);
    writer.u8(static_cast<std::uint32_t>(default_value.size()));
    writer.append(bytes(default_value));
    return writer.bytes();
}

}
