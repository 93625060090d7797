#include "host/compiler/write/key_writer.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/compiler/carry/deformed_tweens.hpp"
#include "host/compiler/match/match_by_length.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/compiler/pack/value_writer.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast {
namespace {

/// The drawings at both ends of the way from `key` to `next`.
MatchedDrawings ends_of_tween(const scene::Key& key, const scene::Key& next, Diagnostics& diagnostics)
{
    MatchedDrawings as_drawn{key.drawing, next.drawing};
    if (key.match == scene::Match::count)
        return as_drawn;
    if (const auto matched = match_by_length(key.drawing, next.drawing))
        return *matched;
    diagnostics.error(key.place,
                      "to match the next key by length takes more than " +
                          std::to_string(kfb::max_drawing_points) + " points, as many as a drawing holds",
                      "draw both with fewer points, or use match=count");
    return as_drawn;
}

/// As they are without backbones.
std::vector<KeyTween> drawn_tweens(const scene::Object& object, Diagnostics& diagnostics)
{
    std::vector<KeyTween> tweens;
    for (std::size_t i = 0; i < object.keys.size(); ++i) {
        const scene::Key& key = object.keys[i];
        const bool leads_on = i + 1 < object.keys.size();
        KeyTween tween{
            .time = key.time, .laws = leads_on ? key.laws : LawPair{}, .ends = {}, .place = key.place};
        tween.ends = leads_on ? ends_of_tween(key, object.keys[i + 1], diagnostics)
                              : MatchedDrawings{key.drawing, key.drawing};
        tweens.push_back(std::move(tween));
    }
    return tweens;
}

}

bool has_arrivals(const scene::Object& object)
{
    if (!object.backbone_keys.empty())
        return object.keys.size() > 1;
    return std::any_of(object.keys.begin(), object.keys.end() - 1,
                       [](const scene::Key& key) { return key.match == scene::Match::length; });
}

KeyTweens key_tweens(const scene::Object& object, Diagnostics& diagnostics)
{
    std::vector<KeyTween> drawn = drawn_tweens(object, diagnostics);
    if (!object.backbone_keys.empty())
        return deformed_tweens(object, drawn, diagnostics);
    return {.tweens = std::move(drawn)};
}

PackedKeys packed_keys(const scene::Object& object, LawTable& laws, DrawingPool& drawings,
                       Diagnostics& diagnostics)
{
    const bool with_arrivals = has_arrivals(object);
    const KeyTweens tweens = key_tweens(object, diagnostics);
    KeyTimes key_times;
    std::vector<std::int32_t> from;
    std::vector<std::int32_t> to;
    std::vector<std::int32_t> depths;
    for (const KeyTween& tween : tweens.tweens) {
        key_times.push_back({tween.time, laws.number_of(tween.laws, tween.place)});
        from.push_back(drawings.offset_of(tween.ends.from));
        if (with_arrivals)
            to.push_back(drawings.offset_of(tween.ends.to));
    }
    for (const scene::Key& key : object.keys) {
        if (!object.has_depths)
            break;
        depths.push_back(drawings.offset_of(key.depths));
    }
    ByteWriter bytes;
    write_key_times({key_times, object.driver}, one_key_time, bytes);
    write_values(from, bytes);
    if (with_arrivals)
        write_values(to, bytes);
    if (object.has_depths)
        write_values(depths, bytes);
    return {bytes.bytes(), tweens.unit_bits};
}

}
