#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/kdl/parser.hpp"
#include "host/scene/scene_reader.hpp"
#include "tests/demand.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

using namespace kfast;

namespace {

/// What is missing at the end of the text is marked behind it.
void check_messages(const Diagnostics& diagnostics, const SourceText& source)
{
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
        demand(diagnostic.place.offset <= source.text.size());
        demand(diagnostic.place.length <= source.text.size() - diagnostic.place.offset + 1);
        demand(!format(diagnostic, source).empty());
    }
}

void check_stroke(const scene::Stroke& stroke)
{
    scene::Point from = stroke.from;
    for (const scene::Segment& segment : stroke.segments) {
        demand(segment.to != from || (segment.cubic && (segment.c1 != from || segment.c2 != from)));
        from = segment.to;
    }
}

/// What keys of drawings and of tracks have in common.
template <class Key>
void check_keys(const std::vector<Key>& keys)
{
    demand(!keys.empty() && keys.front().time >= Time{0} && keys.back().time.ticks <= kfb::max_time);
    demand(std::ranges::adjacent_find(keys, std::greater_equal{}, &Key::time) == keys.end());
    demand(std::ranges::all_of(keys,
                               [](const Key& key) { return is_valid(key.laws.x) && is_valid(key.laws.y); }));
}

void check_label(const scene::Label& label, const std::vector<scene::Input>& inputs)
{
    demand(label.input < inputs.size());
    demand(inputs[label.input].type == (label.format ? InputType::number : InputType::text));
    const scene::TextInput& text = inputs[label.input].text;
    demand(label.format ? label.glyphs.size() >= kfb::number_glyph::first_other
                        : label.glyphs.size() == text.glyphs.size() && text.default_value.size() <= text.max);
    for (const scene::LabelGlyph& glyph : label.glyphs) {
        demand(std::abs(glyph.advance) <= kfb::max_text_width / static_cast<std::int32_t>(text.max));
        for (const scene::Stroke& stroke : glyph.drawing.strokes)
            check_stroke(stroke);
    }
}

void check_object(const scene::Object& object, std::size_t colours, const std::vector<scene::Input>& inputs)
{
    demand(object.fill || object.stroke);
    demand(!object.fill || *object.fill < colours);
    if (object.stroke) {
        demand(object.stroke->colour < colours);
        demand(object.stroke->width >= 1 && object.stroke->width <= kfb::max_width);
        demand(object.stroke->miter_limit >= 8 && object.stroke->miter_limit <= 255);
    }
    demand(!object.beam.has_hatching() || (object.fill && object.beam.spacing >= kfb::min_hatch_spacing &&
                                           object.beam.spacing <= kfb::max_width));
    demand(!object.live || (object.keys.empty() && !object.skin && object.backbone_keys.empty()));
    if (object.live)
        return;
    if (object.label)
        return check_label(*object.label, inputs);
    check_keys(object.keys);
    for (const scene::Key& key : object.keys)
        for (const scene::Stroke& stroke : key.drawing.strokes)
            check_stroke(stroke);
}

void check_tracks(const scene::Item& item, std::size_t colours)
{
    demand(std::ranges::adjacent_find(item.tracks, std::greater_equal{}, &scene::Track::property) ==
           item.tracks.end());
    for (const scene::Track& track : item.tracks) {
        check_keys(track.keys);
        const ValueRange range = value_range(track.property);
        const bool is_colour = track.property == Property::fill || track.property == Property::stroke;
        for (const scene::TrackKey& key : track.keys) {
            demand(key.value >= range.min && key.value <= range.max);
            demand(!is_colour || static_cast<std::size_t>(key.value) < colours);
        }
        const auto* const object = std::get_if<scene::Object>(&item.content);
        if (track.property == Property::fill)
            demand(object != nullptr && object->fill);
        if (track.property == Property::stroke || track.property == Property::width)
            demand(object != nullptr && object->stroke);
    }
}

/// `known` symbols may be used, and `depth` groups and uses lie around. Returns the number of items.
std::size_t check_items(const scene::Scene& scene, const std::vector<scene::Item>& items, std::size_t known,
                        int depth)
{
    demand(depth <= static_cast<int>(kfb::max_depth));
    std::size_t count = items.size();
    for (const scene::Item& item : items) {
        check_tracks(item, scene.palette.size());
        if (const auto* const object = std::get_if<scene::Object>(&item.content))
            check_object(*object, scene.palette.size(), scene.inputs);
        else if (const auto* const group = std::get_if<scene::Group>(&item.content))
            count += check_items(scene, group->items, known, depth + 1);
        else {
            const std::size_t symbol = std::get<scene::Use>(item.content).symbol;
            demand(symbol < known);
            count += check_items(scene, scene.symbols[symbol].items, symbol, depth + 1);
        }
    }
    return count;
}

bool is_name(std::string_view name) { return !name.empty() && name.size() <= kfb::max_name_bytes; }

void check_marks(const scene::Scene& scene)
{
    demand(scene.clips.size() <= kfb::max_clips);
    for (const scene::Clip& clip : scene.clips)
        demand(is_name(clip.name) && clip.begin >= Time{0} && clip.begin < clip.end &&
               clip.end <= scene.length);
    demand(std::ranges::is_sorted(scene.events, {}, &scene::Event::time));
    for (const scene::Event& event : scene.events)
        demand(is_name(event.name) && event.time >= Time{0} && event.time <= scene.length);
}

}

/// Any bytes at all: there is either an error or a scene that keeps what model.hpp promises.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const SourceText source{.name = "fuzz", .text = std::string(data, data + size)};
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    const auto scene = scene::read_scene(document, source, diagnostics);
    check_messages(diagnostics, source);
    demand(scene.has_value() != diagnostics.has_errors());
    if (!scene)
        return 0;
    demand(scene->length >= Time::frame(1) && !scene->palette.empty() && scene->palette[0].opacity == 255);
    demand(scene->symbols.size() <= kfb::max_symbols);
    demand(check_items(*scene, scene->items, scene->symbols.size(), 0) <= kfb::max_items);
    check_marks(*scene);
    return 0;
}
