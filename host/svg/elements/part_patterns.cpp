#include "host/svg/elements/part_reader.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/parts/mean_ink.hpp"
#include "host/svg/style/paint.hpp"

#include <algorithm>
#include <utility>

/// What a PartReader paints shapes with.
namespace kfast::svg {
namespace {

/// The first of a pattern and those it refers to for which that holds.
template <typename Holds>
pugi::xml_node first_of(pugi::xml_node pattern, const ElementIndex& index, const Holds& holds)
{
    constexpr int longest_chain = 32;
    for (int link = 0; pattern && link < longest_chain; ++link) {
        if (holds(pattern))
            return pattern;
        pattern = index.find(referred_id(pattern));
    }
    return {};
}

}

std::optional<Ink> PartReader::ink(const char* property, const Part& part, const Around& inside)
{
    const pugi::xml_node server = index_.find(url_id(inside.style[property]));
    if (element_name(server) == "pattern" && std::ranges::find(open_, server) == open_.end())
        if (auto mean = pattern_ink(server, part, inside)) {
            losses_->add({"pattern", part.layer, {}, "its mean colour"});
            const double opacity = share(inside.style[std::string{property} + "-opacity"]).value_or(1);
            mean->opacity *= std::clamp(opacity, 0.0, 1.0);
            return mean->opacity > 0 ? mean : std::nullopt;
        }
    return paint(property, inside.style, index_, sheet_, part.layer, *losses_);
}

std::optional<Ink> PartReader::pattern_ink(pugi::xml_node pattern, const Part& part, const Around& inside)
{
    const pugi::xml_node source = first_of(pattern, index_, [](pugi::xml_node each) {
        return std::ranges::any_of(each.children(), [](auto child) { return !element_name(child).empty(); });
    });
    const double tile = tile_area(pattern, part, inside);
    if (!source || !(tile > 0))
        return std::nullopt;
    Part drawn;
    Around around = inside;
    around.style = Style{{}, source, sheet_};
    art::Losses lost; // it is no picture of the pattern anyway
    art::Losses* const losses = std::exchange(losses_, &lost);
    open_.push_back(pattern);
    read_children(source, drawn, around);
    open_.pop_back();
    losses_ = losses;
    return mean_ink(drawn.parts, tile);
}

/// In the units of what is drawn on it.
double PartReader::tile_area(pugi::xml_node pattern, const Part& part, const Around& inside)
{
    const auto value = [&](const char* name) {
        return first_of(pattern, index_, [name](pugi::xml_node each) { return !!each.attribute(name); })
            .attribute(name)
            .value();
    };
    if (const auto box = view_box(value("viewBox")))
        return box->width * box->height;
    if (value("patternUnits") == std::string_view{"userSpaceOnUse"})
        return length(value("width"), Axis::x, inside.measure).value_or(0) *
               length(value("height"), Axis::y, inside.measure).value_or(0);
    const double part_of_box = share(value("width")).value_or(0) * share(value("height")).value_or(0);
    const auto box = box_of(part, {});
    if (!box || value("patternContentUnits") == std::string_view{"objectBoundingBox"})
        return part_of_box;
    return part_of_box * (box->max.x - box->min.x) * (box->max.y - box->min.y);
}

}
