#include "host/walk/input_text.hpp"

#include "core/scene/input_view.hpp"
#include "core/scene/number_text.hpp"
#include "host/text/characters.hpp"
#include "host/walk/every_item.hpp"

#include <algorithm>

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

namespace {

std::vector<LabelView> labels_of(const SceneView& scene, std::uint32_t input)
{
    std::vector<LabelView> labels;
    every_item(scene, [&](const ItemView& item) {
        if (item.kind == ItemKind::live && item.live.kind == InputLeaf::label && item.live.input == input)
            labels.push_back(LabelView::of(item.live.label));
    });
    return labels;
}

std::size_t points_of_glyph(const SceneView& scene, const LabelView& label, std::uint32_t glyph)
{
    return point_count(scene.drawing(static_cast<std::uint32_t>(label.drawings[glyph])));
}

}

std::vector<std::size_t> glyph_points(const SceneView& scene, std::uint32_t number, const TextInput& input)
{
    std::vector<std::size_t> points(input.glyphs.count());
    for (const LabelView& label : labels_of(scene, number))
        for (std::uint32_t glyph = 0; glyph < label.glyph_count; ++glyph)
            points[glyph] += points_of_glyph(scene, label, glyph);
    return points;
}

std::optional<Time> largest_number_place(const SceneView& scene, std::uint32_t number)
{
    const InputView input = scene.input(number);
    std::vector<std::size_t> points(static_cast<std::size_t>(whole_input.ticks) + 1);
    const std::vector<LabelView> labels = labels_of(scene, number);
    for (const LabelView& label : labels) {
        std::vector<std::size_t> of_glyphs;
        for (std::uint32_t glyph = 0; glyph < label.glyph_count; ++glyph)
            of_glyphs.push_back(points_of_glyph(scene, label, glyph));
        for (std::size_t place = 0; place < points.size(); ++place) {
            const NumberText text{label.format, input, {static_cast<std::int32_t>(place)}};
            for (const std::byte glyph : text.glyphs())
                points[place] += of_glyphs[std::to_integer<std::size_t>(glyph)];
        }
    }
    if (labels.empty())
        return std::nullopt;
    return Time{static_cast<std::int32_t>(std::ranges::max_element(points) - points.begin())};
}

}
