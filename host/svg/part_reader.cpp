#include "host/svg/part_reader.hpp"

#include "host/failure.hpp"
#include "host/scene/shape.hpp"
#include "host/svg/clip_cover.hpp"
#include "host/svg/element_outlines.hpp"
#include "host/svg/paint.hpp"
#include "host/svg/pen_reader.hpp"
#include "host/svg/shortened.hpp"
#include "host/svg/svg_text.hpp"
#include "host/svg/transform_list.hpp"
#include "host/svg/transform_origin.hpp"
#include "host/svg/unread_element.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kfast::svg {
namespace {

using art::Affine;
using scene::Spot;

/// The corners of a rectangle.
std::array<Spot, 4> corners_of(Spot least, Spot most)
{
    return {least, Spot{most.x, least.y}, most, Spot{least.x, most.y}};
}

art::Drawing seen_through(const Affine& affine, const art::Drawing& drawing)
{
    art::Drawing result;
    for (const scene::Outline& outline : drawing.outlines)
        result.outlines.push_back(affine.of(outline));
    return result;
}

/// Lines alone have no inside.
bool has_inside(const art::Drawing& drawing)
{
    return std::ranges::any_of(drawing.outlines, [](const scene::Outline& outline) {
        return outline.curves.size() > 1 || (outline.curves.size() == 1 && outline.curves.front().cubic);
    });
}

bool line_lies_below(std::string_view paint_order)
{
    const std::size_t line = paint_order.find("stroke");
    return line != paint_order.npos && line < paint_order.find("fill");
}

double opacity_of(const Style& style) { return std::clamp(share(style["opacity"]).value_or(1), 0.0, 1.0); }

/// A canvas of nothing, or of the size of a house, is one of a usual size.
double canvas_side(double side)
{
    constexpr double largest = 1e5;
    return side > 0 && side <= largest ? side : 100;
}

bool is_one_of_first(pugi::xml_node element)
{
    return !element_name(element).empty() && *element.attribute("requiredExtensions").value() == '\0';
}

/// What a "use" shows stands in its place, if there is nothing that only a group can do.
void take_place_of_use(Part& use)
{
    if (use.parts.size() != 1 || use.opacity < 1)
        return;
    Part shown = std::move(use.parts.front());
    shown.own = use.own * shown.own;
    shown.id = use.id;
    shown.label = use.label;
    shown.name = use.name;
    use = std::move(shown);
}

}

const std::vector<PartReader::ElementKind> PartReader::kinds{
    {"g", &PartReader::read_children},     {"a", &PartReader::read_children},
    {"switch", &PartReader::read_first},   {"use", &PartReader::read_use},
    {"svg", &PartReader::read_box},        {"symbol", &PartReader::read_box},
    {"rect", &PartReader::read_shape},     {"circle", &PartReader::read_shape},
    {"ellipse", &PartReader::read_shape},  {"line", &PartReader::read_shape},
    {"polyline", &PartReader::read_shape}, {"polygon", &PartReader::read_shape},
    {"path", &PartReader::read_shape}};

PartReader::PartReader(pugi::xml_node root, std::vector<pugi::xml_node> shown, art::Budget& budget,
                       art::Losses& losses)
    : root_{root}, shown_{std::move(shown)}, budget_{budget}, losses_{&losses}, index_{root}
{
    sheet_.add_elements(root, losses);
}

Picture PartReader::read()
{
    Around inside{.style = Style{{}, root_, sheet_}, .measure = {}, .to_canvas = {}, .layer = {}};
    inside.style.report({}, *losses_);
    report_attributes(root_, {}, *losses_);
    Part& root = picture_.root;
    root.is_group = true;
    root.kind = "svg";
    set_background(inside.style);
    inside.to_canvas = root.own = set_canvas(root_, inside.style);
    root.opacity = opacity_of(inside.style);
    const auto box = view_box(root_.attribute("viewBox").value());
    inside.measure = {box ? box->width : picture_.width, box ? box->height : picture_.height,
                      font_size(inside.style, {})};
    if (inside.style["display"] != "none")
        read_children(root_, root, inside);
    return std::move(picture_);
}

/// A colour of the page that browsers, or Inkscape's exports, show behind the drawing.
void PartReader::set_background(const Style& style)
{
    auto ink = colour(style.get("background-color", style["background"]));
    for (const pugi::xml_node child : root_.children())
        if (child.name() == std::string_view{"sodipodi:namedview"} &&
            number(child.attribute("inkscape:pageopacity").value()).value_or(0) > 0)
            ink = colour(child.attribute("pagecolor").value());
    if (ink && ink->opacity > 0)
        picture_.background = ink->colour;
}

/// From the coordinates of the drawing to pixels.
Affine PartReader::set_canvas(pugi::xml_node root, const Style& style)
{
    const auto box = view_box(root.attribute("viewBox").value());
    const Measure whole =
        box ? Measure{box->width, box->height} : Measure{300, 150}; // what CSS has for pictures
    const auto width = length(style["width"], Axis::x, whole);
    const auto height = length(style["height"], Axis::y, whole);
    const double ratio = whole.width / whole.height;
    picture_.width = canvas_side(width ? *width : height && box ? *height * ratio : whole.width);
    picture_.height = canvas_side(height ? *height : width && box ? *width / ratio : whole.height);
    if (!box)
        return {};
    return fitted(*box, picture_.width, picture_.height, root.attribute("preserveAspectRatio").value());
}

std::optional<Part> PartReader::read_element(pugi::xml_node element, const Around& around, bool used)
{
    const std::string_view name = element_name(element);
    const auto kind = std::ranges::find(kinds, name, &ElementKind::name);
    Around inside{.style = name.empty() ? Style{} : Style{around.style, element, sheet_},
                  .measure = around.measure,
                  .to_canvas = {},
                  .layer = {},
                  .depth = around.depth,
                  .width = around.width,
                  .height = around.height};
    const bool shown =
        inside.style["display"] != "none" || std::ranges::find(shown_, element) != shown_.end();
    if (name.empty() || !shown || (name == "symbol" && !used))
        return std::nullopt;
    if (kind == kinds.end()) {
        if (inside.style["visibility"] != "hidden")
            report_unread(element, around.layer, *losses_);
        return std::nullopt;
    }
    art::Budget::check_depth(around.depth);
    budget_.take_node();
    take_style(inside.style);

    Part part;
    part.id = shortened(element.attribute("id").value(), longest_name);
    part.label = shortened(element.attribute("inkscape:label").value(), longest_name);
    part.kind = name;
    part.name = !part.label.empty() ? part.label : !part.id.empty() ? part.id : part.kind;
    part.layer = around.layer.empty() ? part.name : around.layer + " / " + part.name;
    inside.layer = part.layer;
    inside.style.report(part.layer, *losses_);
    report_attributes(element, part.layer, *losses_);
    inside.measure.font_size = font_size(inside.style, around.measure);
    inside.style.set("font-size", std::to_string(inside.measure.font_size));
    part.own = own_affine(inside.style, around, part.layer);
    part.opacity = opacity_of(inside.style);
    inside.to_canvas = around.to_canvas * part.own;
    (this->*kind->read)(element, part, inside);
    if (part.is_group ? part.parts.empty() : !part.fill && !part.pen)
        return std::nullopt;
    if (turns_about_own_box(inside.style))
        part.own = about_own_box(part, inside.style);
    check_clip("clip-path", "drawn whole", part, inside);
    check_clip("mask", "drawn without it", part, inside);
    if (name == "use")
        take_place_of_use(part);
    return part;
}

/// What elements inherit is copied for each of them, and once more wherever they are used.
void PartReader::take_style(const Style& style)
{
    constexpr std::size_t most = std::size_t{1} << 29; // some seconds
    style_bytes_ += style.bytes();
    if (style_bytes_ > most)
        throw Failure(
            "styles and path data, counted wherever they are inherited or used, take more than 512 MB");
}

Affine PartReader::own_affine(const Style& style, const Around& around, const std::string& layer)
{
    const auto affine = transform_list(style["transform"]);
    if (!affine) {
        losses_->add({"transform \"" + shortened(style["transform"]) + '"', layer, {}, "it is ignored"});
        return {};
    }
    return turns_about_own_box(style) ? *affine : about_origin(*affine, style, around.measure);
}

void PartReader::read_children(pugi::xml_node element, Part& part, Around& inside)
{
    part.is_group = true;
    Around around = inside;
    around.width = around.height = std::nullopt;
    ++around.depth;
    for (const pugi::xml_node child : element.children())
        if (auto read = read_element(child, around))
            part.parts.push_back(std::move(*read));
}

void PartReader::read_first(pugi::xml_node element, Part& part, Around& inside)
{
    part.is_group = true;
    ++inside.depth;
    for (const pugi::xml_node child : element.children())
        if (is_one_of_first(child)) {
            if (auto read = read_element(child, inside))
                part.parts.push_back(std::move(*read));
            return;
        }
}

void PartReader::read_use(pugi::xml_node element, Part& part, Around& inside)
{
    part.is_group = true;
    report_content(element, part.layer, *losses_);
    const std::string_view id = referred_id(element);
    const pugi::xml_node referred = index_.find(id);
    if (!referred) {
        losses_->add({"use of \"" + shortened(id) + '"', part.layer, {}, "nothing: it is not in this file"});
        return;
    }
    if (part.label.empty() && part.id.empty())
        part.name = shortened(id, longest_name);
    const Affine place = art::moved(length(inside.style["x"], Axis::x, inside.measure).value_or(0),
                                    length(inside.style["y"], Axis::y, inside.measure).value_or(0));
    part.own = part.own * place;
    inside.to_canvas = inside.to_canvas * place;
    Around around = inside;
    around.width = length(inside.style["width"], Axis::x, inside.measure);
    around.height = length(inside.style["height"], Axis::y, inside.measure);
    ++around.depth;
    if (auto read = read_element(referred, around, true))
        part.parts.push_back(std::move(*read));
}

/// An "svg" inside of another, or a symbol.
void PartReader::read_box(pugi::xml_node element, Part& part, Around& inside)
{
    const Style& style = inside.style;
    const Measure& outer = inside.measure;
    const double width = inside.width.value_or(length(style["width"], Axis::x, outer).value_or(outer.width));
    const double height =
        inside.height.value_or(length(style["height"], Axis::y, outer).value_or(outer.height));
    part.is_group = true;
    if (!(width > 0) || !(height > 0))
        return;
    const auto box = view_box(element.attribute("viewBox").value());
    const Affine place =
        art::moved(length(style["x"], Axis::x, outer).value_or(0),
                   length(style["y"], Axis::y, outer).value_or(0)) *
        (box ? fitted(*box, width, height, element.attribute("preserveAspectRatio").value()) : Affine{});
    part.own = part.own * place;
    inside.to_canvas = inside.to_canvas * place;
    const ViewBox seen = box.value_or(ViewBox{0, 0, width, height});
    inside.measure.width = seen.width;
    inside.measure.height = seen.height;
    read_children(element, part, inside);
    if (style["overflow"] != "visible" && style["overflow"] != "auto")
        check_overflow(part, inside, seen);
}

void PartReader::read_shape(pugi::xml_node element, Part& part, Around& inside)
{
    const Style& style = inside.style;
    report_content(element, part.layer, *losses_);
    if (style["visibility"] == "hidden" || style["visibility"] == "collapse")
        return;
    part.drawing = outlines_of(element, style, inside.measure, part.layer, budget_, *losses_);
    if (part.drawing.outlines.empty())
        return;
    part.rule = style["fill-rule"] == "evenodd" ? FillRule::even_odd : FillRule::nonzero;
    if (has_inside(part.drawing))
        part.fill = paint("fill", style, index_, sheet_, part.layer, *losses_);
    if (const auto ink = paint("stroke", style, index_, sheet_, part.layer, *losses_))
        part.pen = pen(*ink, style, inside.measure, part.layer, *losses_);
    for (const char* marker : {"marker-start", "marker-mid", "marker-end"})
        if (index_.find(url_id(style[marker])))
            losses_->add({"marker", part.layer, {}, "the line without it"});
    if (!part.pen)
        return;
    const double scale = std::sqrt(std::abs(inside.to_canvas.determinant()));
    art::Drawing line = dashed_line(part.drawing, style, inside.measure,
                                    number(element.attribute("pathLength").value()).value_or(0),
                                    part.pen->keeps_width ? 1 : scale, part.layer, budget_, *losses_);
    const bool below = part.fill && line_lies_below(style["paint-order"]);
    if (!part.fill)
        part.drawing = std::move(line);
    else if (below || !(line == part.drawing))
        split_line(part, line, below);
}

/// A figure has one drawing, and its line over its fill.
void PartReader::split_line(Part& part, const art::Drawing& line, bool below)
{
    budget_.take_node();
    Part fill = part;
    fill.pen.reset();
    fill.own = {};
    fill.opacity = 1;
    Part stroke = fill;
    fill.kind += " fill";
    stroke.kind += " line";
    stroke.name += " line";
    stroke.id = stroke.id.empty() ? "" : stroke.id + " line";
    stroke.label = stroke.label.empty() ? "" : stroke.label + " line";
    stroke.fill.reset();
    stroke.pen = std::exchange(part.pen, std::nullopt);
    stroke.drawing = line;
    part.fill.reset();
    part.drawing = {};
    part.is_group = true;
    part.parts = below ? std::vector{stroke, fill} : std::vector{fill, stroke};
}

void PartReader::check_clip(const char* property, const char* instead, const Part& part, const Around& inside)
{
    const std::string_view value = inside.style[property];
    if (value.empty() || value == "none")
        return;
    const pugi::xml_node clip = index_.find(url_id(value));
    if (value.starts_with("url(") && !clip)
        return;
    if (!clip || !shows_whole(clip, part, inside))
        losses_->add({property, part.layer, {}, instead});
}

/// Whether a clip or a mask takes nothing away from a part.
bool PartReader::shows_whole(pugi::xml_node clip, const Part& part, const Around& inside)
{
    const auto box = box_with_lines(part, {});
    const bool is_mask = element_name(clip) == "mask";
    const char* units = clip.attribute(is_mask ? "maskContentUnits" : "clipPathUnits").value();
    const auto clip_affine = transform_list(clip.attribute("transform").value());
    if (!box || !clip_affine || clip.attribute("clip-path"))
        return !box;
    Affine affine = *clip_affine;
    if (units == std::string_view{"objectBoundingBox"}) {
        const Box inner = *box_of(part, {});
        affine = art::moved(inner.least.x, inner.least.y) *
                 art::grown(inner.most.x - inner.least.x, inner.most.y - inner.least.y) * affine;
    }

    Part area;
    Around around = inside;
    around.style = Style{{}, clip, sheet_};
    art::Losses of_no_interest;
    art::Losses* const losses = std::exchange(losses_, &of_no_interest);
    read_children(clip, area, around);
    losses_ = losses;
    if (area.parts.size() != 1 || area.parts.front().is_group)
        return false;
    const Part& shape = area.parts.front();
    const bool is_light =
        shape.fill && shape.fill->opacity >= 1 && shape.opacity >= 1 &&
        (shape.fill->colour == art::Rgb{1, 1, 1} || Style{{}, clip, sheet_}["mask-type"] == "alpha");
    if (is_mask && !is_light)
        return false;
    const art::Drawing here = seen_through(affine * shape.own, shape.drawing);
    return covers(here, corners_of(box->least, box->most)) ||
           covers(seen_through(inside.to_canvas, here),
                  corners_of({0, 0}, {picture_.width, picture_.height}));
}

void PartReader::check_overflow(const Part& part, const Around& inside, const ViewBox& seen)
{
    const auto box = box_with_lines(part, {});
    const art::Drawing area{
        {scene::polyline(corners_of({seen.x, seen.y}, {seen.x + seen.width, seen.y + seen.height}), true)}};
    if (box && !covers(area, corners_of(box->least, box->most)) &&
        !covers(seen_through(inside.to_canvas, area), corners_of({0, 0}, {picture_.width, picture_.height})))
        losses_->add({"overflow hidden", part.layer, {}, "seen beyond the box as well"});
}

}
