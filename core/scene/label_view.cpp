#include "core/scene/label_view.hpp"

namespace kfast {

LabelView LabelView::of(ByteReader bytes)
{
    LabelView label;
    label.align = static_cast<Align>(bytes.u8());
    label.x = bytes.signed_varint();
    label.y = bytes.signed_varint();
    label.spacing = bytes.signed_varint();
    label.glyph_count = bytes.u8();
    label.drawings = PackedValues::take(bytes, label.glyph_count);
    label.advances = PackedValues::take(bytes, label.glyph_count);
    const std::size_t pairs = bytes.u16();
    label.pairs = bytes.take(2 * pairs).rest();
    if (pairs != 0)
        label.kerning = PackedValues::take(bytes, label.pair_count());
    label.is_whole = !bytes.overrun() && bytes.left() == 0;
    return label;
}

std::uint32_t LabelView::pair_code(std::uint32_t number) const
{
    return ByteReader{pairs.subspan(std::size_t{2} * number)}.u16();
}

std::int32_t LabelView::kerning_between(std::uint32_t left, std::uint32_t right) const
{
    const std::uint32_t code = left << 8 | right;
    std::uint32_t low = 0; // pairs before it come before `code`
    for (std::uint32_t high = pair_count(); low < high;) {
        const std::uint32_t middle = (low + high) / 2;
        if (pair_code(middle) < code)
            low = middle + 1;
        else
            high = middle;
    }
    return low < pair_count() && pair_code(low) == code ? kerning[low] : 0;
}

}
