#include "host/svg/elements/part_reader.hpp"

#include "host/geometry/shape.hpp"
#include "host/program/failure.hpp"
#include "host/svg/elements/element_outlines.hpp"
#include "host/svg/elements/style_reader.hpp"
#include "host/svg/elements/unread_element.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/markup/transform_list.hpp"
#include "host/svg/parts/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kfast::svg {
namespace {

using art::Affine;
using scene::Vec2;

/// Whether it has an inside: straight lines alone have none.
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

/// A canvas of size 0, or of the size of a house, gets a default size.
double canvas_side(double side, art::Losses& losses)
{
    constexpr double largest = 1e5;
    if (side > 0 && side <= largest)
        return side;
    losses.add({"width or height of the drawing, not within 0 and 100000", {}, {}, "100 pixels"});
    return 100;
}

/// Takes an element out of a list of those that are being read when it ends.
class Reading {
public:
    Reading(std::vector<pugi::xml_node>& open, pugi::xml_node element) : open_{open}
    {
        open.push_back(element);
    }
    ~Reading() { open_.pop_back(); }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

private:
    std::vector<pugi::xml_node>& open_;
};

/// The content of a "use" replaces it, if there is nothing that only a group can do.
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
    const double font = font_size(inside.style, {});
    inside.measure = {box ? box->width : picture_.width, box ? box->height : picture_.height, font, font};
    if (inside.style["display"] != "none" && is_for_here(root_, {}))
        read_children(root_, root, inside);
    if (!inside.style["transform"].empty())
        losses_->add({"transform of the outermost svg", {}, {}, "it is ignored"});
    if (!apply_clip("clip-path", "drawn whole", root, inside) ||
        !apply_clip("mask", "drawn without it", root, inside))
        root.parts.clear();
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
        picture_.background = art::mixed(art::Rgb{1, 1, 1}, ink->colour, ink->opacity); // pages are white
}

/// The matrix from the coordinates of the drawing to pixels.
Affine PartReader::set_canvas(pugi::xml_node root, const Style& style)
{
    const auto box = view_box(root.attribute("viewBox").value());
    const Measure whole =
        box ? Measure{box->width, box->height} : Measure{300, 150}; // CSS's default for pictures
    const auto width = length(style["width"], Axis::x, whole);
    const auto height = length(style["height"], Axis::y, whole);
    const double ratio = whole.width / whole.height;
    picture_.width = canvas_side(width ? *width : height && box ? *height * ratio : whole.width, *losses_);
    picture_.height = canvas_side(height ? *height : width && box ? *width / ratio : whole.height, *losses_);
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
    if (!is_for_here(element, around.layer) || is_inside_of_itself(element, around.layer))
        return std::nullopt;
    art::Budget::check_depth(around.depth);
    budget_.take_node();
    take_style(inside.style);
    const Reading reading{open_, element};

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
    const Affine outside_of_place = inside.to_canvas;
    (this->*kind->read)(element, part, inside);
    if (part.is_group ? part.parts.empty() : !part.fill && !part.pen)
        return std::nullopt;
    if (turns_about_own_box(inside.style))
        part.own = about_own_box(part, inside.style);
    inside.to_canvas = outside_of_place;
    if (!apply_clip("clip-path", "drawn whole", part, inside) ||
        !apply_clip("mask", "drawn without it", part, inside))
        return std::nullopt;
    if (name == "use")
        take_place_of_use(part);
    return part;
}

bool PartReader::is_for_here(pugi::xml_node element, const std::string& layer)
{
    const std::string condition = unmet_condition(element);
    if (!condition.empty())
        losses_->add(
            {condition, layer, {}, "nothing: kfast draws what is for English, and without extensions"});
    return condition.empty();
}

/// By a use, or by a clip, of an element that contains it. In SVG that one is not drawn.
bool PartReader::is_inside_of_itself(pugi::xml_node element, const std::string& layer)
{
    if (std::ranges::find(open_, element) == open_.end())
        return false;
    losses_->add(
        {'"' + shortened(element.attribute("id").value()) + "\" inside of itself", layer, {}, "nothing"});
    return true;
}

/// What elements inherit is copied for each of them, and once more wherever they are used.
void PartReader::take_style(const Style& style)
{
    constexpr std::size_t max = std::size_t{1} << 29; // some seconds
    style_bytes_ += style.bytes();
    if (style_bytes_ > max)
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
    for (const pugi::xml_node child : element.children()) {
        if (element_name(child).empty() || !unmet_condition(child).empty())
            continue;
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
    inside.place = place;
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
    const Vec2 corner{length(style["x"], Axis::x, outer).value_or(0),
                      length(style["y"], Axis::y, outer).value_or(0)};
    const Affine outside = inside.to_canvas;
    const Affine place =
        art::moved(corner.x, corner.y) *
        (box ? fitted(*box, width, height, element.attribute("preserveAspectRatio").value()) : Affine{});
    part.own = part.own * place;
    inside.place = place;
    inside.to_canvas = outside * place;
    inside.measure.width = box ? box->width : width;
    inside.measure.height = box ? box->height : height;
    read_children(element, part, inside);
    inside.to_canvas = outside;
    if (style["overflow"] != "visible" && style["overflow"] != "auto")
        clip_to_box(part, inside, {corner, corner + Vec2{width, height}});
}

/// Gives the pen its dashes. Where scenes have none such, they are what is returned, else the whole line.
art::Drawing PartReader::dash(pugi::xml_node element, Part& part, const Around& inside)
{
    const double canvas_scale = std::sqrt(std::abs(inside.to_canvas.determinant()));
    const double scale = part.pen->keeps_width ? 1 : canvas_scale;
    Dashes dashes =
        dashes_of(part.drawing, inside.style, inside.measure,
                  number(element.attribute("pathLength").value()).value_or(0), scale, part.layer, *losses_);
    if (dashes.lengths.empty())
        return part.drawing;
    if (!is_even(inside.to_canvas) || !are_of_scenes(dashes, part.drawing))
        return art::dashed(part.drawing, dashes.lengths, dashes.offset, budget_);
    draw_whole_line(dashes, part.drawing, scale);
    part.pen->dashes = std::move(dashes);
    return part.drawing;
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
    if (reads_clip_) {
        if (has_inside(part.drawing))
            part.fill = Ink{};
        return;
    }
    if (has_inside(part.drawing))
        part.fill = ink("fill", part, inside);
    if (const auto painted = ink("stroke", part, inside))
        part.pen = pen(*painted, style, inside.measure, part.layer, *losses_);
    for (const char* marker : {"marker-start", "marker-mid", "marker-end"})
        if (index_.find(url_id(style[marker])))
            losses_->add({"marker", part.layer, {}, "the line without it"});
    if (!part.pen)
        return;
    art::Drawing line = dash(element, part, inside);
    const bool below = part.fill && line_lies_below(style["paint-order"]);
    if (!part.fill)
        part.drawing = std::move(line);
    else if (below || !(line == part.drawing)) {
        budget_.take_node();
        split_line(part, line, below);
    }
}

}
