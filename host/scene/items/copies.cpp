#include "host/scene/items/copies.hpp"

#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <variant>
#include <vector>

namespace kfast::scene {
namespace {

/// Looks for colours that the palette names, in items and all that they use.
class NamedColours {
public:
    explicit NamedColours(const SceneContext& context) : context_{context} {}

    bool are_in(const SymbolEntry& symbol)
    {
        return seen_.insert(&symbol).second &&
               std::ranges::any_of(symbol.items, [this](const Item& item) { return are_in(item); });
    }

private:
    bool are_in(const Item& item)
    {
        if (std::ranges::any_of(item.tracks, [this](const Track& track) { return are_in(track); }))
            return true;
        if (const Group* const group = std::get_if<Group>(&item.content))
            return std::ranges::any_of(group->items, [this](const Item& inner) { return are_in(inner); });
        if (const Use* const use = std::get_if<Use>(&item.content))
            return are_in(context_.symbols.entries[use->symbol]);
        const auto& object = std::get<Object>(item.content);
        return (object.fill && is_named(*object.fill)) || (object.stroke && is_named(object.stroke->colour));
    }

    bool are_in(const Track& track) const
    {
        return (track.property == Property::fill || track.property == Property::stroke) &&
               std::ranges::any_of(track.keys, [this](const TrackKey& key) {
                   return is_named(static_cast<std::size_t>(key.value));
               });
    }

    bool is_named(std::size_t colour) const { return context_.palette.is_declared(colour); }

    const SceneContext& context_;
    std::set<const SymbolEntry*> seen_; ///< they have none
};

void warn_of_idle_colour_step(const kdl::Node& node, const SymbolUse& use, SceneContext& context)
{
    if (use.repeat.colour != 0 && context.palette.declared() != 0 &&
        !NamedColours{context}.are_in(*use.symbol))
        context.report.warning(property_span(node, "colour-step"),
                               "colour-step does nothing: the symbol has no colour that the palette names",
                               "give it one by its name in the palette, or remove colour-step");
}

}

Group copies_of(const kdl::Node& node, const SymbolUse& use, SourceSpan place, SceneContext& context)
{
    Group group;
    UseTime time = use.time;
    warn_of_unseen_copies(node, use.repeat, context);
    warn_of_idle_colour_step(node, use, context);
    for (int number = 0; number < *use.repeat.count; ++number) {
        const auto values = use.repeat.copy(number, use.values);
        const auto delay = use.repeat.delay_of(number, use.time.delay);
        if (!delay) {
            report_late_copy(node, number, context);
            return group;
        }
        if (use.repeat.delay != Time{})
            time.delay = delay;
        if (!values) {
            report_far_copy(node, number, use.repeat, context);
            return group;
        }
        const auto inner = own_driver(time, *use.symbol, place, context);
        if (!inner)
            return group;
        take_pass(*use.symbol, *inner, context);
        group.items.push_back(
            {.name = "",
             .tracks = fixed_tracks(*values),
             .content = Use{context.symbols.number(*use.symbol), *inner, number * use.repeat.colour},
             .place = place});
    }
    return group;
}

}
