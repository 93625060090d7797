#include "host/picture/panel_choice.hpp"

#include "host/picture/player_source.hpp"

#include <array>

namespace kfast {
namespace {

std::unique_ptr<FrameSource> open_ssd0323(const SceneView& scene, Fit fit)
{
    return std::make_unique<PlayerSource>(scene, Size{128, 64}, fit, PixelFormat::grey4);
}

constexpr std::array choices{
    PanelChoice{"ssd0323", {128, 64}, PixelFormat::grey4, open_ssd0323},
};

}

std::span<const PanelChoice> panel_choices() { return choices; }

}
