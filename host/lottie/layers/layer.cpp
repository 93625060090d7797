#include "host/lottie/layers/layer.hpp"

#include "host/geometry/shape.hpp"
#include "host/text/characters.hpp"

#include <charconv>
#include <utility>

namespace kfast::lottie {

namespace {

void report(const Layer& layer, const std::string& feature, const char* instead)
{
    layer.reading.losses.add({feature, layer.reading.layer, std::nullopt, instead});
}

std::vector<art::Node> read_solid(const Layer& layer)
{
    layer.reading.budget.take_node();
    layer.reading.budget.take_points(5);
    art::Shape shape;
    shape.drawing = solid_drawing(layer.json);
    if (shape.drawing.value().outlines.empty())
        return {};
    const auto colour = solid_colour(layer.json);
    if (!colour)
        report(layer, "solid of the colour " + in_quotes(text_at(layer.json, "sc")), "black");
    shape.fill.emplace().colour = colour.value_or(art::Rgb{});
    art::Node node;
    node.content = std::move(shape);
    return {std::move(node)};
}

/// The first text of a text layer.
std::string words(const Json& layer)
{
    const Json* const text = find_member(layer, "t");
    const Json* const document = text ? find_member(*text, "d") : nullptr;
    const Json* const keys = document ? find_member(*document, "k") : nullptr;
    const Json* value = keys && keys->is_array() && !keys->empty() ? &keys->front() : keys;
    if (value && find_member(*value, "s"))
        value = find_member(*value, "s");
    const Json* const said = value ? find_member(*value, "t") : nullptr;
    if (!said || !said->is_string())
        return {};
    return std::string{" "} + in_quotes(said->get<std::string>());
}

std::string image_name(const Layer& layer, const Animation& animation)
{
    const auto asset = animation.assets.find(identifier_at(layer.json, "refId"));
    if (asset == animation.assets.end())
        return "image";
    const Json* const file = find_member(*asset->second, "p");
    const bool is_name =
        file && file->is_string() && !file->get_ref<const std::string&>().starts_with("data:");
    return is_name ? std::string{"image "} + in_quotes(file->get<std::string>()) : std::string{"image"};
}

void report_undrawn(const Layer& layer, const Animation& animation)
{
    switch (kind_of(layer.json)) {
    case LayerKind::image:
        return report(layer, image_name(layer, animation), "nothing: trace it into shapes");
    case LayerKind::text:
        return report(layer, std::string{"text"} + words(layer.json),
                      "nothing: turn it into shapes in the editor");
    case LayerKind::audio:
        return report(layer, "sound", "silence");
    case LayerKind::video:
        return report(layer, "video", "nothing");
    case LayerKind::adjustment:
        return report(layer, "adjustment layer", "what lies below stays as it is");
    case LayerKind::light:
        return report(layer, "light", "colours stay as they are");
    case LayerKind::null:
    case LayerKind::guide:
    case LayerKind::camera:
    case LayerKind::precomposition:
    case LayerKind::solid:
    case LayerKind::shapes:
        return;
    }
    report(layer, std::string{"layer of the type "} + std::to_string(whole_at(layer.json, "ty", -1)),
           "nothing");
}

}

LayerKind kind_of(const Json& layer) { return LayerKind{whole_at(layer, "ty", -1)}; }

std::string given_name(const Json& layer) { return name_at(layer, "nm"); }

std::string name_of(const Json& layer, std::size_t index)
{
    const std::string name = given_name(layer);
    return name.empty()
               ? std::string{"layer "} + std::to_string(whole_at(layer, "ind", static_cast<int>(index) + 1))
               : name;
}

art::Span span_of(const Json& layer, const LayerTime& time, const art::Span& seen)
{
    constexpr double endless = largest_number;
    double from = time.scene_frame(number_at(layer, "ip", time.stretch > 0 ? -endless : endless));
    double to = time.scene_frame(number_at(layer, "op", time.stretch > 0 ? endless : -endless));
    if (time.stretch < 0)
        std::swap(from, to);
    if (from <= seen.from)
        from = -std::numeric_limits<double>::infinity();
    if (to >= seen.to)
        to = std::numeric_limits<double>::infinity();
    return {from, to};
}

std::vector<art::Node> read_content(const Layer& layer, Animation& animation)
{
    switch (kind_of(layer.json)) {
    case LayerKind::shapes:
        return find_member(layer.json, "shapes") ? read_shapes(array_at(layer.json, "shapes"), layer.reading)
                                                 : std::vector<art::Node>{};
    case LayerKind::solid:
        return read_solid(layer);
    case LayerKind::precomposition:
        return read_precomposition(layer, animation);
    default:
        report_undrawn(layer, animation);
        return {};
    }
}

namespace {

/// #rgb as #rrggbb, and without an opacity, which solids do not have.
std::string six_digits(const std::string& text)
{
    if (text.size() == 4)
        return {text[0], text[1], text[1], text[2], text[2], text[3], text[3]};
    return text.size() == 9 ? text.substr(0, 7) : text;
}

}

art::Drawing solid_drawing(const Json& solid)
{
    const double width = number_at(solid, "sw");
    const double height = number_at(solid, "sh");
    if (!(width > 0 && height > 0))
        return {};
    return {{scene::rectangle({0, 0}, width, height, 0)}};
}

std::optional<art::Rgb> solid_colour(const Json& solid)
{
    const std::string text = six_digits(text_at(solid, "sc"));
    unsigned value = 0;
    const char* const end = text.data() + text.size();
    if (text.size() != 7 || text[0] != '#' || std::from_chars(text.data() + 1, end, value, 16).ptr != end)
        return std::nullopt;
    const auto channel = [&](unsigned shift) { return (value >> shift & 0xff) / 255.0; };
    return art::Rgb{channel(16), channel(8), channel(0)};
}

}
