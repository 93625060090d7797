#include "host/scene/values/event_reader.hpp"

#include "host/scene/values/scene_end.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/node_schema.hpp"
#include "host/schema/property_rule.hpp"

namespace kfast::scene {
namespace {

constexpr NodeForm event_form{"event", "event TIME NAME", 2, 2};

bool lies_in_scene(Time time, SourceSpan place, const Scene& scene, SceneContext& context)
{
    if (time > scene.length)
        return report_beyond_end("this event comes", place, scene.length, context);
    if (time == scene.length && scene.loop == Loop::repeat)
        context.report.warning(
            place, "a scene that repeats never shows its end, so this event comes with its beginning",
            "put it at 0, unless it is meant to come just before what stands there");
    return true;
}

}

std::optional<Event> read_event(const kdl::Node& node, const Scene& scene, SceneContext& context)
{
    if (!fits(node, event_form, context.report) || !refuse_properties(node, context.report))
        return std::nullopt;
    const kdl::Value& moment = node.arguments[0];
    const auto time = read_time(moment, context);
    const auto name = read_name(node.arguments[1], context.report);
    if (!time || !lies_in_scene(*time, moment.place, scene, context) || !name)
        return std::nullopt;
    return Event{.name = std::string{*name}, .time = *time};
}

NodeSchema event_words() { return {event_form.name, event_form, {any_time, any_name}}; }

}
