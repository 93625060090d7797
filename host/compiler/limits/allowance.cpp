#include "host/compiler/limits/allowance.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace kfast {
namespace {

/// Uses of symbols within symbols multiply: beyond this figure the rest no longer counts.
constexpr std::uint64_t beyond_all_limits = 1'000'000'000'000;

/// How much of something an item needs.
struct Need {
    const scene::Item* item;
    std::uint64_t amount;
};

/// Something that the format limits, and how much of it the items of a scene need.
struct Allowance {
    std::string_view what;
    std::string_view hint;
    std::uint64_t limit;
    std::vector<Need> needs;
    std::string_view who = "the format holds";
};

std::uint64_t total(const std::vector<Need>& needs)
{
    std::uint64_t sum = 0;
    for (const Need& need : needs)
        sum = std::min(sum + need.amount, beyond_all_limits);
    return sum;
}

/// Calls visit(item) for `items` and all inside of their groups.
template <class Visit>
void each_item(const std::vector<scene::Item>& items, Visit visit)
{
    for (const scene::Item& item : items) {
        visit(item);
        if (const auto* group = std::get_if<scene::Group>(&item.content))
            each_item(group->items, visit);
    }
}

/// What each item needs by itself; a use also needs all that its symbol needs. A symbol is read once.
template <class AmountOf>
std::vector<Need> needs_with_uses(const scene::Scene& scene, AmountOf amount_of)
{
    std::vector<std::uint64_t> symbols;
    const auto needs_of = [&](const std::vector<scene::Item>& items) {
        std::vector<Need> needs;
        each_item(items, [&](const scene::Item& item) {
            const auto* use = std::get_if<scene::Use>(&item.content);
            needs.push_back({&item, amount_of(item) + (use != nullptr ? symbols[use->symbol] : 0)});
        });
        return needs;
    };
    for (const scene::Symbol& symbol : scene.symbols)
        symbols.push_back(total(needs_of(symbol.items)));
    return needs_of(scene.items);
}

/// What each item needs that is stored, those of a symbol once.
template <class AmountOf>
std::vector<Need> stored_needs(const scene::Scene& scene, AmountOf amount_of)
{
    std::vector<Need> needs;
    const auto add = [&](const scene::Item& item) { needs.push_back({&item, amount_of(item)}); };
    for (const scene::Symbol& symbol : scene.symbols)
        each_item(symbol.items, add);
    each_item(scene.items, add);
    return needs;
}

std::uint64_t layers_of(const scene::Object& object)
{
    return (object.fill ? 1U : 0U) + (object.stroke ? 1U : 0U);
}

bool may_be_transparent(const scene::Item& item)
{
    return std::ranges::any_of(item.tracks, [](const scene::Track& track) {
        return track.property == Property::opacity &&
               (track.keys.size() > 1 || track.keys.front().value != 255);
    });
}

const std::vector<scene::Item>& items_in(const scene::Scene& scene, const scene::Item& item)
{
    if (const auto* use = std::get_if<scene::Use>(&item.content))
        return scene.symbols[use->symbol].items;
    return std::get<scene::Group>(item.content).items;
}

/// As Node::has_several_layers of the core.
bool has_several_layers(const scene::Scene& scene, const scene::Item& item)
{
    if (const auto* object = std::get_if<scene::Object>(&item.content))
        return layers_of(*object) > 1;
    const std::vector<scene::Item>& items = items_in(scene, item);
    return items.size() > 1 || (items.size() == 1 && has_several_layers(scene, items.front()));
}

/// As SceneView::paint_steps() counts them.
std::uint64_t paint_steps_of(const scene::Scene& scene, const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    return (object != nullptr ? layers_of(*object) : 0) +
           (may_be_transparent(item) && has_several_layers(scene, item) ? 2 : 0);
}

/// Tracks of which a player has a record (core/prepared/prepared_scene.hpp), or one more.
std::uint64_t tracks_of(const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    if (object == nullptr || object->live)
        return item.tracks.size();
    const bool may_have_arrivals = object->keys.size() > 1;
    const bool is_deformed = object->skin || !object->backbone_keys.empty();
    return item.tracks.size() + 1 + (may_have_arrivals ? 1 : 0) + (is_deformed || object->has_depths ? 1 : 0);
}

/// The same for all bones.
std::uint64_t tracks_of_bones(const scene::Scene& scene)
{
    std::uint64_t tracks = 0;
    for (const scene::Bones& skeleton : scene.bones)
        for (const scene::Bone& bone : skeleton.bones)
            tracks += static_cast<std::uint64_t>(
                std::ranges::count_if(bone.keys, [](const auto& keys) { return !keys.empty(); }));
    return tracks;
}

std::string name_of(const scene::Item& item, const scene::Scene& scene)
{
    if (const auto* use = std::get_if<scene::Use>(&item.content))
        return "this use of symbol \"" + scene.symbols[use->symbol].name + "\"";
    if (std::holds_alternative<scene::Group>(item.content))
        return "this group";
    return "object \"" + item.name + "\"";
}

void check(const Allowance& allowance, const scene::Scene& scene, Diagnostics& diagnostics)
{
    const std::uint64_t needed = total(allowance.needs);
    if (needed <= allowance.limit)
        return;
    const auto max = std::ranges::max_element(allowance.needs, {}, &Need::amount);
    diagnostics.error(max->item->place,
                      "the scene needs " + std::to_string(needed) + " " + std::string{allowance.what} + ", " +
                          std::string{allowance.who} + " " + std::to_string(allowance.limit) + "; " +
                          name_of(*max->item, scene) + " alone needs " + std::to_string(max->amount),
                      std::string{allowance.hint});
}

/// The number of strokes in all tweens of an item whose points match by length, also in letters.
std::uint64_t matched_strokes(const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    std::uint64_t strokes = 0;
    for (std::size_t i = 1; object != nullptr && i < object->keys.size(); ++i) {
        const scene::Key& from = object->keys[i - 1];
        if (from.match != scene::Match::count)
            strokes += std::max(from.drawing.strokes.size(), object->keys[i].drawing.strokes.size());
    }
    return strokes;
}

/// In the order in which items are stored, as every_item() reads them; null if there is none.
const scene::Item* stored_item(const scene::Scene& scene, std::size_t number)
{
    const std::vector<Need> stored = stored_needs(scene, [](const scene::Item&) { return std::uint64_t{}; });
    return number < stored.size() ? stored[number].item : nullptr;
}

}

void check_matching(const scene::Scene& scene, Diagnostics& diagnostics)
{
    // A stroke takes up to a fifth of a millisecond: less than two seconds in all.
    constexpr std::uint64_t limit = 8'192;
    check({"strokes matched by length", "use match=count, or fewer strokes", limit,
           stored_needs(scene, matched_strokes), "the compiler takes"},
          scene, diagnostics);
}

void check_allowances(const scene::Scene& scene, Diagnostics& diagnostics)
{
    const auto one = [](const scene::Item&) { return std::uint64_t{1}; };
    const auto steps_of = [&scene](const scene::Item& item) { return paint_steps_of(scene, item); };
    check({"items", "use symbols less often, or such that have fewer items", kfb::max_items,
           needs_with_uses(scene, one)},
          scene, diagnostics);
    check({"items as they are written", "draw several shapes as one object, or use symbols",
           kfb::max_nodes - 1 - scene.symbols.size(), stored_needs(scene, one)},
          scene, diagnostics);
    check({"tracks", "move groups instead of the objects in them", kfb::max_tracks - tracks_of_bones(scene),
           stored_needs(scene, tracks_of)},
          scene, diagnostics);
    check({"steps of painting", "use symbols less often, or fill or stroke alone, or fade fewer groups",
           kfb::max_paint_steps, needs_with_uses(scene, steps_of)},
          scene, diagnostics);
}

std::optional<SceneView> playable(std::span<const std::byte> file, const scene::Scene& scene,
                                  Diagnostics& diagnostics)
{
    std::uint32_t number = 0xFFFF'FFFF;
    const auto view = SceneView::parse(file, every_feature, &number);
    if (view)
        return *view;
    const scene::Item* item = stored_item(scene, number);
    const SourceSpan place = item != nullptr ? item->place : SourceSpan{1, 1};
    if (view.error() == Error::too_slow)
        diagnostics.error(place,
                          "a picture of the scene takes a Pico (RP2040) longer than a second" +
                              (item != nullptr ? "; " + name_of(*item, scene) + " takes most of it" : ""),
                          std::string{slow_scene_hint});
    else
        diagnostics.error(place,
                          "the scene has more keys, and points in their drawings, than a player reads of one "
                          "of " +
                              std::to_string(file.size()) + " bytes",
                          "use fewer keys, or drawings of fewer points");
    return std::nullopt;
}

}
