#include "host/walk/input_text.hpp"

#include "core/scene/input_view.hpp"
#include "host/text/characters.hpp"
#include "host/walk/every_item.hpp"

namespace kfast {
namespace {

std::size_t point_count(PackedDrawing drawing)
{
    std::size_t points = drawing.strokes();
    for (std::uint32_t left = drawing.strokes(); left > 0; --left) {
        std::uint32_t segments = drawing.next_stroke();
        points += segments;
        for (; segments > 0; --segments)
            drawing.next_segment();
    }
    return points;
}

}

std::string default_text(const TextInput& input)
{
    std::string text;
    for (const std::byte glyph : input.default_value)
        append_utf8(text, input.glyphs.character(std::to_integer<std::uint32_t>(glyph)));
    return text;
}

std::string full_text(const TextInput& input, std::uint32_t glyph)
{
    std::string text;
    for (std::uint32_t i = 0; i < input.max; ++i)
        append_utf8(text, input.glyphs.character(glyph));
    return text;
}

std::vector<std::size_t> glyph_points(const SceneView& scene, std::uint32_t number, const TextInput& input)
{
    std::vector<std::size_t> points(input.glyphs.count());
    every_item(scene, [&](const ItemView& item) {
        if (item.kind != ItemKind::live || item.live.kind != InputLeaf::label || item.live.input != number)
            return;
        const LabelView label = LabelView::of(item.live.label);
        for (std::uint32_t glyph = 0; glyph < label.glyph_count; ++glyph)
            points[glyph] += point_count(scene.drawing(static_cast<std::uint32_t>(label.drawings[glyph])));
    });
    return points;
}

}
