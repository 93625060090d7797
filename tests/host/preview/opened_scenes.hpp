#pragma once

#include "host/picture/player_source.hpp"
#include "host/preview/viewer/opened_scene.hpp"
#include "host/program/failure.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <utility>

namespace kfast::test {

/// As a preview opens a scene file, on a panel of the size of its canvas.
inline std::unique_ptr<OpenedScene> open_scene(const std::filesystem::path& file)
{
    std::ostringstream found;
    try {
        FileWatch read{{file}};
        SceneFile scene = load_scene(file, {}, found);
        const SceneView view = scene.view;
        auto source = std::make_unique<PlayerSource>(view, view.canvas(), Fit::contain, PixelFormat::rgb565);
        return std::make_unique<OpenedScene>(OpenedScene{.file = file,
                                                         .scene = std::move(scene),
                                                         .source = std::move(source),
                                                         .playback_setup = playback_setup_of(view),
                                                         .panel = view.canvas(),
                                                         .read = std::move(read),
                                                         .warnings = found.str()});
    } catch (const Failure& failure) {
        throw Failure(found.str() + failure.what());
    }
}

}
