#include "host/preview/scene_layers.hpp"

namespace kfast {

SceneLayers::SceneLayers(OpenedScene& scene) : scene_{scene}
{
    std::size_t item = 0;
    for (const std::string& name : scene.scene.item_names)
        table_.rows.push_back({item++, name, 0, {}});
}

const Overlay& SceneLayers::overlay(const Playback&, const ViewOptions&, double)
{
    static const Overlay none;
    return none;
}

std::optional<std::size_t> SceneLayers::item_at(const Playback&, PanelSpot) { return std::nullopt; }

const Picture& SceneLayers::onion_skin(const Playback& playback)
{
    static Picture picture;
    picture = widen(show(*scene_.source, playback));
    return picture;
}

std::optional<std::span<const FitLine>> SceneLayers::fit_report() { return std::nullopt; }

}
