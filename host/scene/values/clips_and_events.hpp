#pragma once

#include "core/time/time.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/report.hpp"

#include <optional>
#include <string>

namespace kfast::scene {

/// `what` is "this clip ends", say; `length` is that of the scene. Always false.
inline bool report_beyond_end(const std::string& what, SourceSpan place, Time length, SceneContext& context)
{
    return context.report.error(place, what + " after the scene, which ends at frame " + text_of(length),
                                "choose an earlier time, or make the scene longer with frames=…");
}

/// Nothing when the node gives no usable clip of a scene of `length`; what is wrong is reported. `names` are
/// those of the clips before it.
std::optional<Clip> read_clip(const kdl::Node& node, Time length, NameTable& names, SceneContext& context);

NodeSchema clip_schema();

/// Nothing when the node gives no usable event; what is wrong is reported. `scene` has its length and loop.
std::optional<Event> read_event(const kdl::Node& node, const Scene& scene, SceneContext& context);

NodeSchema event_schema();

}
