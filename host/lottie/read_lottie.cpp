#include "host/lottie/read_lottie.hpp"

#include "host/lottie/layers/background.hpp"
#include "host/lottie/layers/camera.hpp"
#include "host/lottie/layers/composition.hpp"
#include "host/lottie/values/json_text.hpp"

#include <utility>

namespace kfast::lottie {
namespace {

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

art::Document read_document(const Json& root, art::Losses& losses)
{
    Animation animation = begin(root, losses);
    read_assets(animation);
    art::Document document;
    document.width = animation.width;
    document.height = animation.height;
    document.frame_rate = animation.frame_rate;
    document.frames = std::max(1.0, animation.frames);
    document.camera = read_camera(animation);
    const Reading reading{animation.budget, losses, {-animation.first, 1}, "", 0};
    document.nodes =
        read_composition({array_at(root, "layers"), nullptr, {0, document.frames}}, animation, reading);
    document.markers = read_markers(animation);
    lift_background(document);
    return document;
}

}

art::Document read_lottie(const SourceText& source, art::Losses& losses)
{
    const Json root = parse_json(source);
    try {
        return read_document(root, losses);
    } catch (const WrongMember& wrong) {
        const std::string path = path_to(root, wrong.place());
        throw Failure(source.name + ": " + (path.empty() ? "" : path + ": ") + wrong.what());
    } catch (const Failure& failure) {
        throw Failure(source.name + ": " + failure.what());
    }
}

}
