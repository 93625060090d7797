#include "core/beam/beam_plot.hpp"

namespace kfast {

std::size_t BeamPlot::next(std::span<BeamPoint> points)
{
    std::size_t count = 0;
    while (count < points.size() && leg_ < legs_.size()) {
        const BeamLine& line = lines_->line(legs_[leg_].line);
        points[count++] = {lines_->points(line)[vertex_], vertex_ == 0 ? Colour{.opacity = 0} : line.colour};
        if (++vertex_ == line.points) {
            vertex_ = 0;
            ++leg_;
        }
    }
    return count;
}

}
