#include "host/picture/svg_source.hpp"

#include "host/picture/svg_tracer.hpp"

#include <algorithm>

namespace kfast {

SvgSource::SvgSource(const SceneView& scene, Size panel, Fit fit)
    : panel_{panel}, memory_{SvgPlayer::bytes_for(scene)}, player_{scene, panel, fit, memory_.bytes()}
{
}

std::string SvgSource::SvgPlayer::show(Time moment)
{
    pose(std::clamp(moment, Time{}, scene().length()));
    return SvgTracer{on_panel()}.run();
}

}
