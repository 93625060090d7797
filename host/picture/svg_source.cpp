#include "host/picture/svg_source.hpp"

#include "host/picture/svg_tracer.hpp"

#include <algorithm>

namespace kfast {

SvgSource::SvgSource(const SceneView& scene, Size panel, Fit fit)
    : panel_{panel}, memory_{SvgPlayer::memory_for(scene)}, player_{
                                                                scene, panel, fit,
                                                                std::as_writable_bytes(std::span{memory_})}
{
}

std::vector<std::uint32_t> SvgSource::SvgPlayer::memory_for(const SceneView& scene)
{
    return std::vector<std::uint32_t>((bytes_for(scene) + 3) / 4);
}

std::string SvgSource::SvgPlayer::show(Time moment)
{
    const Moment posed = pose(std::clamp(moment, Time{}, scene().length()));
    return SvgTracer{on_panel(), posed}.run();
}

}
