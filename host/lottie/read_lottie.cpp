#include "host/lottie/read_lottie.hpp"

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/extent.hpp"
#include "host/lottie/layers/composition.hpp"
#include "host/lottie/layers/layer.hpp"
#include "host/lottie/shapes/transform.hpp"
#include "host/lottie/values/json.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace kfast::lottie {

namespace {

bool is_still(const art::Transform& transform)
{
    return !transform.path &&
           std::ranges::all_of(
               std::initializer_list<const art::Channel*>{
                   &transform.anchor_x, &transform.anchor_y, &transform.x, &transform.y, &transform.z,
                   &transform.scale_x, &transform.scale_y, &transform.rotate, &transform.rotate_x,
                   &transform.rotate_y, &transform.skew, &transform.skew_axis},
               [](const art::Channel* channel) { return steady_value(*channel).has_value(); }) &&
           is_flat(transform);
}

bool is_plain(const art::Node& node)
{
    return is_still(node.transform) && steady_value(node.opacity) == 1.0 &&
           node.shown == std::vector<art::Span>{{}};
}

/// The colour of a shape that is a background.
std::optional<art::Rgb> background_of(const art::Node& node, const art::Document& document,
                                      const art::Affine& matrix = {})
{
    if (!is_plain(node))
        return std::nullopt;
    const art::Affine inner = matrix * matrix_at(node.transform, 0);
    if (std::holds_alternative<art::Use>(node.content))
        return std::nullopt;
    if (const auto* group = std::get_if<art::Group>(&node.content))
        return group->nodes.size() == 1 ? background_of(group->nodes.front(), document, inner) : std::nullopt;
    const auto& shape = std::get<art::Shape>(node.content);
    if (!shape.drawing.is_still() || shape.drawing.value().outlines.size() != 1 || !shape.fill ||
        shape.stroke || !shape.fill->colour.is_still() || steady_value(shape.fill->opacity) != 1.0)
        return std::nullopt;
    const auto corners = Box{0, 0, document.width, document.height}.corners();
    if (!contains({{inner.of(shape.drawing.value().outlines.front())}}, corners))
        return std::nullopt;
    return shape.fill->colour.value();
}

/// A lowest node of one colour that covers the canvas and never changes becomes the background instead.
void lift_background(art::Document& document)
{
    if (document.nodes.empty())
        return;
    document.background = background_of(document.nodes.front(), document);
    if (document.background)
        document.nodes.erase(document.nodes.begin());
}

constexpr double nearly = 0.01;

/// The value of what never changes; nothing for others.
std::optional<double> still(const Json& ks, const char* name, std::size_t index, double default_value,
                            Animation& animation)
{
    return steady_value(read_channel(ks, name, index, default_value, 1, {}, animation.budget));
}

bool is_at(const Json& ks, const char* name, std::size_t index, double value, Animation& animation)
{
    const auto found = still(ks, name, index, value, animation);
    return found && std::abs(*found - value) <= nearly;
}

bool looks_straight(const Json& camera, double distance, Animation& animation)
{
    const Json* const ks = find_member(camera, "ks");
    if (!ks || find_member(camera, "parent"))
        return false;
    const double x = animation.width / 2;
    const double y = animation.height / 2;
    for (const char* const turn : {"rx", "ry", "rz", "r"})
        if (!is_at(*ks, turn, 0, 0, animation))
            return false;
    for (const std::size_t axis : {0U, 1U, 2U})
        if (!is_at(*ks, "or", axis, 0, animation))
            return false;
    return is_at(*ks, "p", 0, x, animation) && is_at(*ks, "p", 1, y, animation) &&
           is_at(*ks, "p", 2, -distance, animation) && is_at(*ks, "a", 0, x, animation) &&
           is_at(*ks, "a", 1, y, animation);
}

/// The distance of the viewer, in pixels, by the camera of the file if there is one: it has to look straight
/// at the middle of the canvas and stay there. For others there is a loss, and only their distance is used.
std::optional<double> read_camera(Animation& animation)
{
    const Json& layers = array_at(animation.root, "layers");
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Json& layer = layers[i];
        if (!layer.is_object() || kind_of(layer) != LayerKind::camera || truth_at(layer, "hd", false))
            continue;
        const art::Channel distance = read_channel(layer, "pe", 0, 0, 1, {}, animation.budget);
        const double first = distance.keys.front().value;
        if (!steady_value(distance) || !looks_straight(layer, first, animation))
            animation.losses.add({"camera", name_of(layer, i), std::nullopt,
                                  "one that stands still and looks at the middle of the canvas"});
        if (first > 0)
            return first;
    }
    return std::nullopt;
}

constexpr double longest = 1'000'000; ///< frames of a scene
constexpr double highest_rate = 1000;

double positive(const Json& root, const char* name)
{
    const double number = number_at(root, name);
    if (!(number > 0))
        throw WrongMember(root[name], "is not above 0");
    return number;
}

Animation begin(const Json& root, art::Losses& losses)
{
    if (!root.is_object() || !find_member(root, "layers"))
        throw WrongMember(root, "this is no animation of Lottie: it has no \"layers\"");
    Animation animation{root, losses};
    animation.width = positive(root, "w");
    animation.height = positive(root, "h");
    animation.frame_rate = positive(root, "fr");
    animation.first = number_at(root, "ip", 0);
    animation.frames = number_at(root, "op") - animation.first;
    if (animation.frame_rate > highest_rate)
        throw WrongMember(root["fr"], "is above 1000 frames per second");
    if (!(animation.frames > 0))
        throw WrongMember(root["op"], "ends before it begins: \"op\" is above \"ip\"");
    if (animation.frames > longest)
        throw WrongMember(root["op"], "lasts more than 1000000 frames: set the end of the animation");
    return animation;
}

void read_assets(Animation& animation)
{
    if (!find_member(animation.root, "assets"))
        return;
    for (const Json& asset : array_at(animation.root, "assets")) {
        animation.assets.emplace(identifier_at(asset, "id"), &asset);
    }
}

/// The composition that a layer names; null for others. What is wrong with it is found when it is read.
const Json* composition_of(const Json& layer, Animation& animation)
{
    const Json* const id = find_member(layer, "refId");
    if (!id || !(id->is_string() || id->is_number()))
        return nullptr;
    const auto asset = animation.assets.find(identifier_at(layer, "refId"));
    return asset == animation.assets.end() ? nullptr : find_member(*asset->second, "layers");
}

/// Counts the layers that show each composition, those of a composition once.
void count_uses(Animation& animation)
{
    std::vector<const Json*> found{find_member(animation.root, "layers")};
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i]->is_array())
            continue;
        for (const Json& layer : *found[i])
            if (const Json* const layers = composition_of(layer, animation); layers)
                if (++animation.uses[layers] == 1)
                    found.push_back(layers);
    }
}

std::vector<art::Marker> read_markers(const Animation& animation)
{
    std::vector<art::Marker> markers;
    if (!find_member(animation.root, "markers"))
        return markers;
    for (const Json& marker : array_at(animation.root, "markers"))
        markers.push_back({name_at(marker, "cm"), number_at(marker, "tm", 0) - animation.first,
                           std::max(0.0, number_at(marker, "dr", 0))});
    return markers;
}

art::Document read_document(const Json& root, art::Losses& losses, Repeated repeated)
{
    Animation animation = begin(root, losses);
    read_assets(animation);
    count_uses(animation);
    art::Document document;
    document.width = animation.width;
    document.height = animation.height;
    document.frame_rate = animation.frame_rate;
    document.frames = std::max(1.0, animation.frames);
    document.camera = read_camera(animation);
    const Reading reading{animation.budget,
                          losses,
                          {.start = -animation.first},
                          "",
                          0,
                          repeated == Repeated::as_symbols ? &animation.symbols : nullptr};
    document.nodes =
        read_composition({array_at(root, "layers"), nullptr, {0, document.frames}}, animation, reading);
    document.symbols = std::move(animation.symbols.list);
    document.markers = read_markers(animation);
    lift_background(document);
    return document;
}

}

art::Document read_lottie(const SourceText& source, art::Losses& losses, Repeated repeated)
{
    const Json root = parse_json(source);
    try {
        return read_document(root, losses, repeated);
    } catch (const WrongMember& wrong) {
        const std::string path = path_to(root, wrong.place());
        throw Failure(source.name + ": " + (path.empty() ? "" : path + ": ") + wrong.what());
    } catch (const Failure& failure) {
        throw Failure(source.name + ": " + failure.what());
    }
}

}
