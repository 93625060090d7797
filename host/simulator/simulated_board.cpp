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

void SimulatedBoard::start_at(Time moment)
{
    start_ = moment;
    frames_.clear();
}

Playhead SimulatedBoard::playhead(const SceneView& scene) const
{
    if (!start_)
        return Playhead{scene};
    Playhead playhead{{Time{0}, scene.length(), Loop::once}, scene.events()};
    playhead.seek(*start_);
    return playhead;
}

void SimulatedBoard::frame_shown(FrameReport report)
{
    const auto picture = model_.picture();
    frames_.push_back(
        {report.time, std::exchange(passed_, {}), picture_.value(), {picture.begin(), picture.end()}});
    picture_ = {};
}

}
