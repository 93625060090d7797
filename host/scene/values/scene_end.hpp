#pragma once

#include "core/time/time.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/values/value_reader.hpp"

#include <string>

namespace kfast::scene {

/// `what` is "this clip ends", say; `length` is that of the scene. Always false.
inline bool report_beyond_end(const std::string& what, SourceSpan place, Time length, SceneContext& context)
{
    return context.report.error(place, what + " after the scene, which ends at frame " + text_of(length),
                                "choose an earlier time, or make the scene longer with frames=…");
}

}
