#include "host/picture/panel_choice.hpp"

#include "host/picture/board_source.hpp"

#include <array>

namespace kfast {
namespace {

std::unique_ptr<FrameSource> open_ssd0323(std::span<const std::byte> scene)
{
    return std::make_unique<BoardSource>(scene);
}

constexpr std::array choices{
    PanelChoice{"ssd0323", {Ssd0323Model::width, Ssd0323Model::height}, open_ssd0323},
};

}

std::span<const PanelChoice> panel_choices() { return choices; }

}
