#include "host/compiler/write/inputs_and_marks.hpp"

#include "core/scene/format.hpp"
#include "host/compiler/write/header.hpp"

#include <utility>
#include <vector>

namespace kfast {

namespace {

/// Characters that follow each other, from glyph and character on.
using GlyphRange = std::pair<std::size_t, char32_t>;

std::vector<GlyphRange> glyph_ranges_of(const std::u32string& glyphs)
{
    std::vector<GlyphRange> ranges;
    for (std::size_t i = 0; i < glyphs.size(); ++i)
        if (i == 0 || glyphs[i] != glyphs[i - 1] + 1)
            ranges.emplace_back(i, glyphs[i]);
    return ranges;
}

void write_glyphs(const std::u32string& glyphs, ByteWriter& bytes)
{
    const std::vector<GlyphRange> ranges = glyph_ranges_of(glyphs);
    bytes.u8(static_cast<std::uint32_t>(glyphs.size()));
    bytes.u8(static_cast<std::uint32_t>(ranges.size()));
    for (const auto& [glyph, character] : ranges)
        bytes.u32(kfb::glyph_range::glyph.put(glyph) | kfb::glyph_range::character.put(character));
}

void write_text(const scene::TextInput& text, ByteWriter& bytes)
{
    bytes.u8(text.max);
    write_glyphs(text.glyphs, bytes);
    bytes.u8(static_cast<std::uint32_t>(text.default_value.size()));
    for (const char32_t character : text.default_value)
        bytes.u8(static_cast<std::uint32_t>(text.glyphs.find(character)));
}

void write_number(const scene::Input& input, ByteWriter& bytes)
{
    for (const std::int32_t value : {input.min, input.max, input.default_value})
        bytes.signed_varint(value);
}

void write_drawing(const scene::DrawingInput& drawing, DrawingPool& drawings, ByteWriter& bytes)
{
    bytes.varint(static_cast<std::uint32_t>(drawing.strokes));
    bytes.varint(static_cast<std::uint32_t>(drawing.points));
    bytes.varint(static_cast<std::uint32_t>(drawings.offset_of(drawing.default_value)));
}

}

void write_inputs(const std::vector<scene::Input>& inputs, DrawingPool& drawings, ByteWriter& bytes)
{
    for (const scene::Input& input : inputs) {
        bytes.u8(static_cast<std::uint32_t>(input.type));
        write_name(input.name, bytes);
        switch (input.type) {
        case InputType::number:
            write_number(input, bytes);
            break;
        case InputType::text:
            write_text(input.text, bytes);
            break;
        case InputType::drawing:
            write_drawing(input.drawing, drawings, bytes);
            break;
        }
    }
}

namespace {

void write_clock(const Clock& clock, ByteWriter& bytes)
{
    bytes.u8(clock.driver.number);
    bytes.u8(kfb::clock::loop.put(clock.loop));
    bytes.signed_varint(clock.delay.ticks);
    bytes.signed_varint(clock.speed);
    bytes.varint(time_code(clock.length));
}

void write_clip(const scene::Clip& clip, ByteWriter& bytes)
{
    write_name(clip.name, bytes);
    bytes.varint(time_code(clip.begin));
    bytes.varint(time_code(clip.end - clip.begin));
    bytes.u8(static_cast<std::uint32_t>(clip.loop));
}

}

void write_marks(const scene::Scene& scene, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(scene.clocks.size()));
    for (const Clock& clock : scene.clocks)
        write_clock(clock, bytes);
    bytes.u8(static_cast<std::uint32_t>(scene.clips.size()));
    for (const scene::Clip& clip : scene.clips)
        write_clip(clip, bytes);
    Time before;
    for (const scene::Event& event : scene.events) {
        bytes.varint(time_code(event.time - before));
        write_name(event.name, bytes);
        before = event.time;
    }
}

}
