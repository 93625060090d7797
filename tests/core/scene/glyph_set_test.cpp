#include "core/scene/input_view.hpp"

#include "core/bytes/code_point.hpp"
#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>
#include <optional>
#include <string>

namespace kfast::test {
namespace {

/// A set of `count` glyphs, and the bytes that it borrows.
struct RawGlyphs {
    Bytes bytes;
    GlyphSet set;

    RawGlyphs(int count, const std::vector<std::pair<std::uint32_t, char32_t>>& stretches)
    {
        ByteWriter writer;
        writer.u8(static_cast<std::uint32_t>(count));
        writer.u8(static_cast<std::uint32_t>(stretches.size()));
        for (const auto& [glyph, character] : stretches)
            writer.u32(glyph | std::uint32_t{character} << 8);
        bytes = writer.bytes();
        ByteReader reader{bytes};
        set = GlyphSet::take(reader);
        CHECK_FALSE(reader.overrun());
        CHECK(reader.left() == 0);
    }
};

bool is_valid(int count, const std::vector<std::pair<std::uint32_t, char32_t>>& stretches)
{
    return RawGlyphs{count, stretches}.set.is_valid();
}

}

TEST_CASE("a character is found by its stretch, and what lies between stretches is none")
{
    const RawGlyphs raw{15, {{0, U' '}, {1, U'%'}, {2, U'0'}, {13, U'ä'}, {14, U'\U0001F600'}}};
    const GlyphSet& set = raw.set;
    REQUIRE(set.is_valid());
    CHECK(set.count() == 15);
    const std::u32string characters = U" %0123456789:ä\U0001F600";
    for (std::uint32_t glyph = 0; glyph < set.count(); ++glyph) {
        CHECK(set.glyph(characters[glyph]) == glyph);
        CHECK(set.character(glyph) == characters[glyph]);
    }
    for (const char32_t other : {U'\0', U'\x1F', U'!', U'$', U'&', U'/', U';', U'a', U'å', last_code_point})
        CHECK_FALSE(set.glyph(other));
}

TEST_CASE("stretches rise and do not overlap")
{
    CHECK(is_valid(1, {{0, U'a'}}));
    CHECK(is_valid(3, {{0, U'a'}, {2, U'c'}}));
    CHECK(is_valid(1, {{0, last_code_point}}));
    CHECK_FALSE(is_valid(0, {}));
    CHECK_FALSE(is_valid(1, {}));
    CHECK_FALSE(is_valid(0, {{0, U'a'}}));
    CHECK_FALSE(is_valid(2, {{1, U'a'}}));
    CHECK_FALSE(is_valid(3, {{0, U'a'}, {2, U'b'}}));
    CHECK_FALSE(is_valid(3, {{0, U'c'}, {2, U'a'}}));
    CHECK_FALSE(is_valid(2, {{0, U'a'}, {2, U'c'}}));
    CHECK_FALSE(is_valid(3, {{0, U'a'}, {2, U'c'}, {2, U'e'}}));
    CHECK_FALSE(is_valid(2, {{0, last_code_point}}));
    CHECK_FALSE(is_valid(1, {{0, last_code_point + 1}}));
    CHECK_FALSE(is_valid(255, {{0, 0xFFFFFF}}));
}

}
