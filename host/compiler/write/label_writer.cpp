#include "host/compiler/write/label_writer.hpp"

#include "host/compiler/pack/value_writer.hpp"

#include <vector>

namespace kfast {

void write_label(const scene::Label& label, DrawingPool& drawings, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(label.align));
    for (const std::int32_t value : {std::int32_t{label.at.x}, std::int32_t{label.at.y}, label.spacing})
        bytes.signed_varint(value);
    std::vector<std::int32_t> offsets;
    std::vector<std::int32_t> advances;
    for (const scene::LabelGlyph& glyph : label.glyphs) {
        offsets.push_back(drawings.offset_of(glyph.drawing));
        advances.push_back(glyph.advance);
    }
    bytes.u8(static_cast<std::uint32_t>(label.glyphs.size()));
    write_values(offsets, bytes);
    write_values(advances, bytes);
    std::vector<std::int32_t> kerning;
    bytes.u16(static_cast<std::uint32_t>(label.kerning.size()));
    for (const scene::Kerning& pair : label.kerning) {
        bytes.u16(std::uint32_t{pair.left} << 8 | pair.right);
        kerning.push_back(pair.by);
    }
    if (!kerning.empty())
        write_values(kerning, bytes);
}

}
