#include "host/simulator/simulated_board.hpp"

#include "core/player.hpp"

#include <utility>

namespace kfast {

SimulatedBoard::SimulatedBoard(std::span<const std::byte> scene, std::size_t frames)
    : scene_{scene}, frames_wanted_{frames}
{
    if (const auto view = SceneView::parse(scene))
        block_.resize(Player::block_bytes(*view, panel_.size()));
    for (auto& band : bands_)
        band.resize(band_rows * row_bytes(PixelFormat::grey4, Ssd0323Model::width));
}

void SimulatedBoard::frame_shown(FrameReport report)
{
    const auto picture = model_.picture();
    frames_.push_back(
        {report.time, std::exchange(passed_, {}), mirror_.hash(), {picture.begin(), picture.end()}});
}

}
