#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>
#include <limits>

namespace kfast {
namespace {

bool is_coordinate(std::int32_t sixteenths)
{
    return sixteenths >= std::numeric_limits<std::int16_t>::min() &&
           sixteenths <= std::numeric_limits<std::int16_t>::max();
}

bool is_width(std::int32_t width) { return width >= -kfb::max_text_width && width <= kfb::max_text_width; }

/// The largest of `count` values in either direction; beyond kfb::max_text_width it stays beyond it.
std::int32_t largest(const PackedValues& values, std::uint32_t count)
{
    std::int32_t max = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!is_width(values[i]))
            return kfb::max_text_width + 1;
        max = std::max(max, values[i] < 0 ? -values[i] : values[i]);
    }
    return max;
}

bool are_pairs_valid(const LabelView& label)
{
    for (std::uint32_t i = 0; i < label.pair_count(); ++i) {
        const std::uint32_t code = label.pair_code(i);
        if (code >> 8 >= label.glyph_count || (code & 0xFF) >= label.glyph_count ||
            (i != 0 && code <= label.pair_code(i - 1)))
            return false;
    }
    return true;
}

bool fits(const LabelView& label, const TextInput& text)
{
    if (!is_width(label.spacing))
        return false;
    const std::int32_t spacing = label.spacing < 0 ? -label.spacing : label.spacing;
    const std::int32_t step =
        largest(label.advances, label.glyph_count) + largest(label.kerning, label.pair_count()) + spacing;
    return static_cast<std::uint32_t>(step) <= std::uint32_t{kfb::max_text_width} / text.max;
}

}

bool is_label_valid(const LabelView& label, const TextInput& text)
{
    return label.is_whole && label.glyph_count == text.glyphs.count() && label.align <= Align::right &&
           is_coordinate(label.x) && is_coordinate(label.y) && are_pairs_valid(label) && fits(label, text);
}

}
