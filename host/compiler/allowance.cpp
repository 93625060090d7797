#include "host/compiler/allowance.hpp"

#include "core/kfb_limits.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace kfast {
namespace {

/// Uses of symbols within symbols multiply: beyond this figure the rest no longer counts.
constexpr std::uint64_t beyond_all_limits = 1'000'000'000'000;

/// What an item needs of something.
struct Need {
    const scene::Item* item;
    std::uint64_t amount;
};

/// Something that the format limits, and how much of it the items of a scene need.
struct Allowance {
    std::string_view what;
    std::string_view remedy;
    std::uint64_t limit;
    std::vector<Need> needs;
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

/// What each item needs by itself, a use also all that its symbol needs. A symbol is read once.
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

/// Of the drawings of inputs, each counting as one more: far less than the format holds.
std::uint64_t points_of_inputs(const scene::Scene& scene)
{
    std::uint64_t points = 0;
    for (const scene::Input& input : scene.inputs)
        if (input.type == InputType::drawing)
            points += point_count(input.drawing.usual) + 1;
    return points;
}

const std::vector<scene::Item>& items_in(const scene::Scene& scene, const scene::Item& item)
{
    if (const auto* use = std::get_if<scene::Use>(&item.content))
        return scene.symbols[use->symbol].items;
    return std::get<scene::Group>(item.content).items;
}

/// As the core's has_several_layers() tells.
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

/// Tracks of which a player has a record (core/evaluator/node.hpp), or one more.
std::uint64_t tracks_of(const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    if (object == nullptr || object->live)
        return item.tracks.size();
    const bool may_have_arrivals = object->keys.size() > 1;
    const bool is_carried = object->skin || !object->backbone_keys.empty();
    return item.tracks.size() + 1 + (may_have_arrivals ? 1 : 0) + (is_carried || object->has_depths ? 1 : 0);
}

/// Likewise of all bones.
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
    const auto most = std::ranges::max_element(allowance.needs, {}, &Need::amount);
    diagnostics.error(most->item->place,
                      "the scene needs " + std::to_string(needed) + " " + std::string{allowance.what} +
                          ", the format holds " + std::to_string(allowance.limit) + "; " +
                          name_of(*most->item, scene) + " alone needs " + std::to_string(most->amount),
                      std::string{allowance.remedy});
}

}

void check_allowances(const scene::Scene& scene, const PointsOfObjects& points, Diagnostics& diagnostics)
{
    const auto points_of = [&points](const scene::Item& item) {
        const auto* object = std::get_if<scene::Object>(&item.content);
        return object != nullptr ? points.at(object) : 0;
    };
    const auto one = [](const scene::Item&) { return std::uint64_t{1}; };
    const auto steps_of = [&scene](const scene::Item& item) { return paint_steps_of(scene, item); };
    check({"points in all keys together", "draw it with fewer points, or with fewer keys",
           kfb::max_key_points - points_of_inputs(scene), stored_needs(scene, points_of)},
          scene, diagnostics);
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

}
