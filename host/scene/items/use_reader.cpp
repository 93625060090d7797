#include "host/scene/items/use_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/duplicate_quantity.hpp"
#include "host/scene/items/key_list.hpp"
#include "host/scene/items/mirror.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/items/track_builder.hpp"
#include "host/scene/items/track_reader.hpp"
#include "host/text/glyph.hpp"
#include "host/words/synonyms.hpp"

#include <array>
#include <utility>

namespace kfast::scene {
namespace {

constexpr std::array names_inside{key_name, track_name};

/// How a use changes.
struct Changes {
    std::vector<ItemKey> keys;
    std::vector<TimedQuantity> timed;
};

Changes read_changes(const kdl::Node& node, const KeyDriver& driver, SceneContext& context)
{
    Changes changes;
    KeyList keys{KeyHolder::group, driver, context};
    for (const kdl::Node& child : node.children) {
        if (context.report.full())
            break;
        if (child.name == key_name) {
            keys.read(child);
        } else if (child.name == track_name) {
            if (auto quantity = read_track(child, KeyHolder::group, context))
                changes.timed.push_back(std::move(*quantity));
        } else {
            context.report.error(child.name_span, "a use has no node " + in_quotes(child.name),
                                 word_hint(child.name, names_inside));
        }
    }
    changes.keys = keys.take();
    return changes;
}

}

std::optional<Item> read_use(const kdl::Node& node, int depth, SceneContext& context)
{
    auto use = read_items_use(node, context);
    auto [keys, timed] = read_changes(node, use ? use->driver : KeyDriver{}, context);
    if (!use)
        return std::nullopt;
    const SourceSpan place = span(node.name_span, node.arguments.front().place);
    if (depth + 1 + use->symbol->depth > deepest_item) {
        context.report.error(place, too_deep());
        return std::nullopt;
    }
    warn_of_idle_input(node, !keys.empty(), context);
    refuse_duplicate_quantities(timed, use->values, keys, context);
    mirror(use->mirror, use->values, keys, timed);
    auto tracks = build_tracks(node, use->values, {keys, use->driver.driver()}, timed, context);
    return Item{"", std::move(tracks), Use{context.symbols.number(*use->symbol)}, place, take_path(timed)};
}

}
