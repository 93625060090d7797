#include "host/compiler/write/key_writer.hpp"

#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/carry/backbone_timeline.hpp"
#include "host/compiler/carry/deformed_tweens.hpp"
#include "host/compiler/carry/skinned_drawing.hpp"
#include "host/compiler/match/match_by_letters.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/compiler/pack/value_writer.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

namespace {

/// The drawings at both ends of the tween from `key` to `next`.
MatchedDrawings ends_of_tween(const scene::Key& key, const scene::Key& next, bool is_stroked,
                              Diagnostics& diagnostics)
{
    if (const auto matched = matched_drawings(key, next, is_stroked))
        return *matched;
    diagnostics.error(key.place,
                      "to match the next key by " + std::string{scene::match_name(key.match)} +
                          " takes more than " + std::to_string(kfb::max_drawing_points) +
                          " points, as many as a drawing holds",
                      "draw both with fewer points, or use match=count");
    return {key.drawing, next.drawing};
}

/// The tweens as they are without backbones.
std::vector<KeyTween> drawn_tweens(const scene::Object& object, Diagnostics& diagnostics)
{
    std::vector<KeyTween> tweens;
    for (std::size_t i = 0; i < object.keys.size(); ++i) {
        const scene::Key& key = object.keys[i];
        const bool leads_on = i + 1 < object.keys.size();
        KeyTween tween{
            .time = key.time, .laws = leads_on ? key.laws : LawPair{}, .ends = {}, .place = key.place};
        tween.ends = leads_on ? ends_of_tween(key, object.keys[i + 1], object.stroke.has_value(), diagnostics)
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
                       [](const scene::Key& key) { return key.match != scene::Match::count; });
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

namespace {

const scene::Drawing& first_seen(const std::vector<scene::Key>& keys)
{
    const auto is_seen = [](const scene::Key& key) { return !key.drawing.strokes.empty(); };
    const auto first = std::ranges::find_if(keys, is_seen);
    return first == keys.end() ? keys.front().drawing : first->drawing;
}

std::vector<SkinnedDrawing> skinned_drawings(const scene::Object& object, Diagnostics& diagnostics)
{
    const scene::Drawing& first = first_seen(object.keys);
    std::vector<SkinnedDrawing> drawings;
    for (const scene::Key& key : object.keys) {
        auto skinned = skinned_drawing(first, object.skin->bindings, key.drawing);
        if (!skinned)
            diagnostics.error(key.place,
                              "to follow bones as the first drawing does, this one takes more than " +
                                  std::to_string(kfb::max_drawing_points) +
                                  " points, as many as a drawing holds",
                              "draw both with fewer points");
        else if (object.skin->turns_changes)
            skinned->at_rest.reset();
        drawings.push_back(std::move(skinned).value_or(SkinnedDrawing{}));
    }
    return drawings;
}

bool has_fine_weights(const scene::Binding& binding)
{
    return std::ranges::any_of(
        binding, [](const scene::BoneWeight& share) { return share.weight % kfb::skin::coarse_weight != 0; });
}

/// The last bone has no weight of its own.
void write_binding(const scene::Binding& binding, bool is_fine, ByteWriter& bytes)
{
    for (const scene::BoneWeight& share : binding) {
        bytes.u8(static_cast<std::uint32_t>(share.bone));
        if (&share == &binding.back())
            return;
        const auto weight = static_cast<std::uint32_t>(share.weight);
        if (is_fine)
            bytes.u16(weight);
        else
            bytes.u8(weight / kfb::skin::coarse_weight);
    }
}

/// Points in a row that follow the same bones are stored as one run.
void write_runs(const std::vector<scene::Binding>& bindings, ByteWriter& bytes)
{
    for (auto run = bindings.begin(); run != bindings.end();) {
        const auto end = std::find_if(run, bindings.end(),
                                      [run](const scene::Binding& binding) { return binding != *run; });
        const auto points = static_cast<std::uint32_t>(end - run);
        const bool is_fine = has_fine_weights(*run);
        bytes.varint(kfb::skin::points.put(points - 1) | kfb::skin::has_fine_weights.put(is_fine) |
                     kfb::skin::bones.put(run->size() - 1));
        write_binding(*run, is_fine, bytes);
        run = end;
    }
}

/// The bone that moves all points, which are at rest where they are drawn.
std::optional<std::int32_t> only_bone(const SkinnedDrawing& skinned)
{
    const auto is_first = [&skinned](const scene::Binding& binding) {
        return binding.size() == 1 && binding == skinned.bindings.front();
    };
    if (skinned.at_rest || skinned.bindings.empty() || !std::ranges::all_of(skinned.bindings, is_first))
        return std::nullopt;
    return static_cast<std::int32_t>(skinned.bindings.front().front().bone);
}

/// The number by which a key refers to it.
std::int32_t number_of_skin(const SkinnedDrawing& skinned, DrawingPool& drawings)
{
    if (const auto bone = only_bone(skinned))
        return kfb::skin::of_bone(*bone);
    ByteWriter skin;
    skin.varint(skinned.at_rest ? 1 + static_cast<std::uint32_t>(drawings.offset_of(*skinned.at_rest)) : 0);
    write_runs(skinned.bindings, skin);
    return drawings.offset_of(skin.bytes());
}

}

PackedKeys packed_skinned_keys(const scene::Object& object, LawTable& laws, DrawingPool& drawings,
                               Diagnostics& diagnostics)
{
    const std::vector<SkinnedDrawing> skinned = skinned_drawings(object, diagnostics);
    PackedKeys packed;
    KeyTimes key_times;
    std::vector<std::int32_t> offsets;
    std::vector<std::int32_t> skins;
    for (std::size_t i = 0; i < skinned.size(); ++i) {
        const scene::Key& key = object.keys[i];
        key_times.push_back(
            {key.time, laws.number_of(i + 1 == skinned.size() ? LawPair{} : key.laws, key.place)});
        offsets.push_back(drawings.offset_of(skinned[i].drawing));
        skins.push_back(number_of_skin(skinned[i], drawings));
    }
    ByteWriter bytes;
    write_key_times({key_times, object.driver}, one_key_time, bytes);
    write_values(offsets, bytes);
    write_values(skins, bytes);
    packed.bytes = bytes.bytes();
    return packed;
}

void write_backbones(const scene::Object& object, std::uint32_t unit_bits, LawTable& laws,
                     DrawingPool& drawings, ByteWriter& bytes)
{
    KeyTimes key_times;
    std::vector<std::int32_t> offsets;
    for (const scene::BackboneKey& key : object.backbone_keys) {
        const bool is_last = &key == &object.backbone_keys.back();
        key_times.push_back({key.time, laws.number_of(is_last ? LawPair{} : key.laws, key.place)});
        offsets.push_back(drawings.offset_of(drawing_of(key.backbones)));
    }
    bytes.u8(unit_bits);
    write_key_times({key_times, object.driver}, one_key_time, bytes);
    write_values(offsets, bytes);
}

}
