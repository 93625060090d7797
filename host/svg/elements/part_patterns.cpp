/// What a PartReader paints shapes with.

#include "host/art/geometry/curves.hpp"
#include "host/svg/elements/part_reader.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/parts/part.hpp"
#include "host/svg/style/paint.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace kfast::svg {

namespace {

using art::Affine;
using scene::Vec2;

/// Twice the area, signed by its direction; curves as 8 lines.
double signed_area(const scene::Outline& outline)
{
    constexpr int steps = 8;
    double sum = 0;
    Vec2 last = outline.from;
    Vec2 from = outline.from;
    for (const scene::Curve& curve : outline.curves) {
        for (int step = 1; step <= steps; ++step) {
            const Vec2 next = art::spot_on(from, curve, static_cast<double>(step) / steps);
            sum += scene::cross(last - outline.from, next - outline.from);
            last = next;
        }
        from = curve.to;
    }
    return sum;
}

double fill_area(const art::Drawing& drawing)
{
    double sum = 0;
    for (const scene::Outline& outline : drawing.outlines)
        sum += signed_area(outline);
    return std::abs(sum) / 2;
}

double line_area(const art::Drawing& drawing, double width)
{
    double length = 0;
    for (const scene::Outline& outline : drawing.outlines)
        length += art::outline_length(outline);
    return length * width;
}

double drawn_share(const Dashes& dashes)
{
    double drawn = 0;
    double sum = 0;
    for (std::size_t i = 0; i < dashes.lengths.size(); ++i) {
        drawn += i % 2 == 0 ? dashes.lengths[i] : 0;
        sum += dashes.lengths[i];
    }
    return sum > 0 ? drawn / sum : 1;
}

class Spread {
public:
    explicit Spread(double tile) : tile_{tile} {}

    void add(const Part& part, double area_factor, double opacity)
    {
        area_factor *= std::abs(part.own.determinant());
        opacity *= part.opacity;
        if (part.fill)
            add(*part.fill, area_factor * fill_area(part.drawing), opacity);
        if (part.pen)
            add(part.pen->ink,
                area_factor * line_area(part.drawing, part.pen->width) * drawn_share(part.pen->dashes),
                opacity);
        for (const Part& inner : part.parts)
            add(inner, area_factor, opacity);
    }

    const Ink& ink() const { return ink_; }

private:
    /// Adds ink over what is there.
    void add(const Ink& ink, double area, double opacity)
    {
        const double share = std::min(area / tile_, 1.0) * ink.opacity * opacity;
        const double sum = share + ink_.opacity * (1 - share);
        if (!(sum > 0))
            return;
        ink_ = {art::mixed(ink_.colour, ink.colour, share / sum), std::min(sum, 1.0)};
    }

    double tile_;
    Ink ink_{{}, 0};
};

/// What parts look like from far away, drawn once on each tile of an area, in their units squared: as if each
/// of them were spread evenly. Nothing where nothing is visible.
std::optional<Ink> mean_ink(std::span<const Part> parts, double tile)
{
    Spread spread{tile};
    for (const Part& part : parts)
        spread.add(part, 1, 1);
    return tile > 0 && spread.ink().opacity > 0 ? std::optional{spread.ink()} : std::nullopt;
}

/// The first of a pattern and those it refers to for which `holds` is true.
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

/// The area of a tile in the units of what is drawn on it.
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
