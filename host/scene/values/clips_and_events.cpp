#include "host/scene/values/clips_and_events.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"

#include <string>

namespace kfast::scene {

namespace {

constexpr NodeForm clip_form{"clip", "clip NAME from=TIME to=TIME", 1, 1};

bool read_begin(const kdl::Value& value, Clip& clip, SceneContext& context)
{
    return assign(read_time(value, context), clip.begin);
}

bool read_end(const kdl::Value& value, Clip& clip, SceneContext& context)
{
    return assign(read_time(value, context), clip.end);
}

bool read_clip_loop(const kdl::Value& value, Clip& clip, SceneContext& context)
{
    return assign(read_loop(value, context), clip.loop);
}

constexpr std::array clip_rules{
    PropertyRule<Clip>{"from", read_begin, any_time, true},
    PropertyRule<Clip>{"to", read_end, any_time, true},
    PropertyRule<Clip>{"loop", read_clip_loop, ValueKind::one_of<loops>()},
};

bool lies_in_scene(const Clip& clip, const kdl::Node& node, Time length, SceneContext& context)
{
    const SourceSpan end = property_span(node, "to");
    if (clip.end <= clip.begin)
        return context.report.error(end, "this clip ends before anything of it is shown",
                                    "let to= be later than from=");
    return clip.end <= length || report_beyond_end("this clip ends", end, length, context);
}

}

std::optional<Clip> read_clip(const kdl::Node& node, Time length, NameTable& names, SceneContext& context)
{
    if (!fits(node, clip_form, context.report))
        return std::nullopt;
    Clip clip;
    const bool good =
        read_properties(node, clip_rules, clip, context) && lies_in_scene(clip, node, length, context);
    const kdl::Value& value = node.arguments.front();
    const auto name = read_name(value, context.report);
    const SourceSpan place = span(node.name_span, value.place);
    if (!name || !add_name(names, "a clip", *name, place, context.report) || !good)
        return std::nullopt;
    if (names.size() > max_clips) {
        context.report.error(place, "a scene has at most " + std::to_string(max_clips) + " clips");
        return std::nullopt;
    }
    clip.name = *name;
    return clip;
}

NodeSchema clip_schema() { return {clip_form.name, clip_form, {any_name}, schema_of(clip_rules)}; }

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

NodeSchema event_schema() { return {event_form.name, event_form, {any_time, any_name}}; }

}
