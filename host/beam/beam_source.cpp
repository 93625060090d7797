#include "host/beam/beam_source.hpp"

#include <array>

namespace kfast {
BeamSource::BeamSource(const SceneView& scene, const BeamProfile& profile, std::uint32_t budget)
    : block_{BeamPlayer::block_bytes(scene, profile)}, player_{*BeamPlayer::create(scene, profile, budget,
                                                                                   block_.bytes())}
{
}

std::span<const BeamPoint> BeamSource::show(Time moment)
{
    player_.show_moment(moment);
    points_.clear();
    PointStream plot = player_.plot();
    std::array<BeamPoint, 256> piece;
    while (const std::size_t count = plot.next(piece))
        points_.insert(points_.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
    return points_;
}

}
