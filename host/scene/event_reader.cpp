#include "host/scene/event_reader.hpp"

#include "host/scene/node_form.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/scene_end.hpp"
#include "host/scene/value_reader.hpp"

namespace kfast::scene {
namespace {

constexpr NodeForm event_form{"event", "event TIME NAME", 2, 2};

bool lies_in_scene(Time time, Place place, const Scene& scene, Reading& reading)
{
    if (time > scene.length)
        return report_beyond_end("this event comes", place, scene.length, reading);
    if (time == scene.length && scene.loop == Loop::repeat)
        reading.report.warning(
            place, "a scene that repeats never shows its end, so this event comes with its beginning",
            "put it at 0, unless it is meant to come just before what stands there");
    return true;
}

}

std::optional<Event> read_event(const kdl::Node& node, const Scene& scene, Reading& reading)
{
    if (!fits(node, event_form, reading) || !refuse_properties(node, reading))
        return std::nullopt;
    const kdl::Value& moment = node.arguments[0];
    const auto time = read_time(moment, reading);
    const auto name = read_name(node.arguments[1], reading);
    if (!time || !lies_in_scene(*time, moment.place, scene, reading) || !name)
        return std::nullopt;
    return Event{.name = std::string{*name}, .time = *time};
}

NodeWords event_words() { return {event_form.name, event_form, {any_time, any_name}}; }

}
