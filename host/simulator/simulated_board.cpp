#include "host/simulator/simulated_board.hpp"

#include "core/player.hpp"

namespace kfast {

SimulatedBoard::SimulatedBoard(std::span<const std::byte> scene) : scene_{scene}
{
    if (const auto view = SceneView::parse(scene))
        block_.resize(Player::block_bytes(*view, panel_.size()));
    for (auto& band : bands_)
        band.resize(band_rows * row_bytes(PixelFormat::grey4, Ssd0323Model::width));
}

void SimulatedBoard::scene_started(const SceneView& scene)
{
    const int length = scene.length().ticks;
    const int frames_begun = (length - 1) / Time::ticks_per_frame + 1;
    frames_wanted_ = static_cast<std::size_t>(scene.loop() == Loop::once ? frames_begun + 1 : frames_begun);
}

void SimulatedBoard::frame_shown(FrameReport report)
{
    const auto picture = model_.picture();
    frames_.push_back({report.time, picture_.value(), {picture.begin(), picture.end()}});
    picture_ = {};
}

}
