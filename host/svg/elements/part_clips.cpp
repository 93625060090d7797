#include "host/geometry/shape.hpp"
#include "host/svg/elements/part_reader.hpp"
#include "host/svg/elements/style_reader.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/markup/transform_list.hpp"
#include "host/svg/parts/clipped_part.hpp"

#include <utility>

/// What clips, masks and the edges of boxes do to the parts that a PartReader reads.
namespace kfast::svg {

using art::Affine;
using scene::Vec2;

/// False where nothing of the part is left.
bool PartReader::apply_clip(const char* property, const char* instead, Part& part, const Around& inside)
{
    const std::string_view value = inside.style[property];
    if (value.empty() || value == "none")
        return true;
    const pugi::xml_node clip = index_.find(url_id(value));
    const bool is_clip = element_name(clip) == (property == std::string_view{"mask"} ? "mask" : "clipPath");
    if (value.starts_with("url(") && !is_clip)
        return true; // an error, as if there were none
    const auto area = clip ? clip_area(clip, part, inside) : std::nullopt;
    if (!area) {
        if (box_with_lines(part, {}))
            losses_->add({property, part.layer, {}, instead});
        return true;
    }
    return clip_to(*area, property, part, inside);
}

/// Clips the part to an area; returns whether anything of it is left.
bool PartReader::clip_to(const art::Drawing& area, const char* feature, Part& part, const Around& inside)
{
    if (area.outlines.empty())
        return false;
    if (covers(seen_through(inside.to_canvas, area), corners_of({{0, 0}, {picture_.width, picture_.height}})))
        return true;
    if (!convex_corners(area))
        return true; // too far away for numbers to distinguish its sides; so is what is in it
    Clip clip{area, budget_};
    const bool is_left = clip.apply(part, inside.place);
    for (const std::string& layer : clip.whole_lines())
        losses_->add({feature, layer, {}, "the line is drawn whole"});
    return is_left;
}

/// What a clip or a mask lets through, in the coordinates of the part's element: one convex outline, or none
/// where nothing is visible. Nothing where it is anything else.
std::optional<art::Drawing> PartReader::clip_area(pugi::xml_node clip, const Part& part, const Around& inside)
{
    const Style style{{}, clip, sheet_};
    const bool is_mask = element_name(clip) == "mask";
    const auto box = box_of(part, inside.place);
    const auto is_set = [&](const char* name) { return !style.get(name, "none").starts_with("none"); };
    if (!box || is_set("clip-path") || is_set("mask") || (is_mask && !region_covers(clip, part, inside)))
        return std::nullopt;
    const auto own = transform_list(is_mask ? "" : style["transform"]);
    if (!own)
        return std::nullopt;
    Affine affine = about_origin(*own, style, inside.measure);
    const char* units = clip.attribute(is_mask ? "maskContentUnits" : "clipPathUnits").value();
    if (units == std::string_view{"objectBoundingBox"})
        affine = affine * art::moved(box->min.x, box->min.y) *
                 art::grown(box->max.x - box->min.x, box->max.y - box->min.y);

    const auto shape = only_shape(clip, style, inside);
    if (!shape)
        return std::nullopt;
    const bool is_light = shape->drawing.outlines.empty() || !is_mask ||
                          (shape->fill && shape->fill->opacity >= 1 && shape->opacity >= 1 &&
                           (shape->fill->colour == art::Rgb{1, 1, 1} || style["mask-type"] == "alpha"));
    art::Drawing area = seen_through(affine * shape->own, shape->drawing);
    if (!is_light || !(area.outlines.empty() || convex_corners(area)))
        return std::nullopt;
    return area;
}

/// The shape of a clip or a mask; without outlines if it has none. Nothing where it has several, or others.
std::optional<Part> PartReader::only_shape(pugi::xml_node clip, const Style& style, const Around& inside)
{
    Part area;
    Around around = inside;
    around.style = style;
    art::Losses lost;
    art::Losses* const losses = std::exchange(losses_, &lost);
    const bool reads_clip = std::exchange(reads_clip_, element_name(clip) == "clipPath");
    read_children(clip, area, around);
    losses_ = losses;
    reads_clip_ = reads_clip;
    if (!lost.empty() || area.parts.size() > 1)
        return std::nullopt;
    if (area.parts.empty())
        return Part{};
    return area.parts.front().is_group || area.parts.front().pen ? std::nullopt
                                                                 : std::optional{area.parts.front()};
}

/// Whether the rectangle that a mask has takes nothing away by itself.
bool PartReader::region_covers(pugi::xml_node mask, const Part& part, const Around& inside)
{
    const auto box = box_of(part, inside.place);
    const auto seen = box_with_lines(part, inside.place);
    const bool is_of_box = mask.attribute("maskUnits").value() != std::string_view{"userSpaceOnUse"};
    const Measure whole = is_of_box ? Measure{1, 1} : inside.measure;
    const auto side = [&](const char* name, const char* default_value, Axis axis) {
        const auto attribute = mask.attribute(name);
        return length(attribute ? attribute.value() : default_value, axis, whole).value_or(0);
    };
    Box region{{side("x", "-10%", Axis::x), side("y", "-10%", Axis::y)}, {}};
    region.max = region.min + Vec2{side("width", "120%", Axis::x), side("height", "120%", Axis::y)};
    if (is_of_box) {
        const Vec2 size = box->max - box->min;
        const auto in_box = [&](Vec2 spot) { return box->min + Vec2{spot.x * size.x, spot.y * size.y}; };
        region = {in_box(region.min), in_box(region.max)};
    }
    return covers(outline_of(region), corners_of(*seen));
}

/// The edge of a nested drawing or of a symbol, in the coordinates of its element.
void PartReader::clip_to_box(Part& part, const Around& inside, const Box& edge)
{
    if (!clip_to(outline_of(edge), "overflow hidden", part, inside))
        part.parts.clear();
}

}
