#include "host/compiler/write/track_writer.hpp"

#include "core/scene/format.hpp"
#include "host/compiler/pack/value_writer.hpp"
#include "host/scene/items/track_builder.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

bool is_fixed(const scene::Track& track) { return track.keys.size() == 1; }

std::int32_t value_without(Property property, const scene::Item& item)
{
    switch (property) {
    case Property::fill:
        return static_cast<std::int32_t>(std::get<scene::Object>(item.content).fill.value());
    case Property::stroke:
        return static_cast<std::int32_t>(std::get<scene::Object>(item.content).stroke.value().colour);
    case Property::width:
        return std::get<scene::Object>(item.content).stroke.value().width;
    default:
        return value_without_track(property);
    }
}

/// A place on a path is never the default.
bool changes_nothing(const scene::Track& track, const scene::Item& item)
{
    return is_fixed(track) && track.property != Property::along &&
           track.keys.front().value == value_without(track.property, item);
}

/// The tracks that make a difference. A pivot makes none where nothing rotates or scales, except for the
/// width of wires.
std::vector<const scene::Track*> effective_tracks(const scene::Item& item)
{
    std::vector<const scene::Track*> tracks;
    for (const scene::Track& track : item.tracks)
        if (!changes_nothing(track, item))
            tracks.push_back(&track);
    const auto pointed_to = [](const scene::Track* track) -> const scene::Track& { return *track; };
    const auto* object = std::get_if<scene::Object>(&item.content);
    const bool has_depths = object != nullptr && object->has_depths;
    if (!has_depths && std::ranges::none_of(tracks, scene::needs_pivot, pointed_to))
        std::erase_if(tracks, [](const scene::Track* track) { return scene::is_pivot(*track); });
    return tracks;
}

void write_track(const scene::Track& track, LawTable& laws, DrivenKeyTimes& before, ByteWriter& bytes)
{
    bytes.u8(kfb::track::property.put(track.property) |
             kfb::track::is_smooth.put(track.is_smooth && !is_fixed(track)) |
             kfb::track::is_fixed.put(is_fixed(track)));
    if (is_fixed(track))
        return bytes.signed_varint(track.keys.front().value);
    DrivenKeyTimes key_times = key_times_of(track.keys, track.driver, track.is_smooth, laws);
    write_key_times(key_times, before, bytes);
    write_values(values_of(track.keys), bytes);
    before = std::move(key_times);
}

const BeamStyle* beam_style_of(const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    return object != nullptr && object->beam != BeamStyle{} ? &object->beam : nullptr;
}

void write_beam_style(const BeamStyle& style, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(style.parts));
    if (!style.has_hatching())
        return;
    bytes.varint(static_cast<std::uint32_t>(style.spacing));
    bytes.varint(style.direction.raw);
}

}

DrivenKeyTimes key_times_of(const std::vector<scene::TrackKey>& keys, Driver driver, bool is_smooth,
                            LawTable& laws)
{
    KeyTimes key_times;
    for (const scene::TrackKey& key : keys) {
        const bool has_laws = !is_smooth && &key != &keys.back();
        key_times.push_back({key.time, has_laws ? laws.number_of(key.laws, key.place) : 0});
    }
    return {key_times, driver};
}

std::vector<std::int32_t> values_of(const std::vector<scene::TrackKey>& keys)
{
    std::vector<std::int32_t> values;
    values.reserve(keys.size());
    for (const scene::TrackKey& key : keys)
        values.push_back(key.value);
    return values;
}

std::vector<std::byte> packed_tracks(const scene::Item& item, LawTable& laws)
{
    const std::vector<const scene::Track*> tracks = effective_tracks(item);
    const BeamStyle* beam = beam_style_of(item);
    if (tracks.empty() && beam == nullptr)
        return {};
    ByteWriter bytes;
    bytes.u8(kfb::tracks::count.put(tracks.size()) | kfb::tracks::has_beam_style.put(beam != nullptr));
    DrivenKeyTimes before;
    for (const scene::Track* track : tracks)
        write_track(*track, laws, before, bytes);
    if (beam != nullptr)
        write_beam_style(*beam, bytes);
    return bytes.bytes();
}

}
