#include "host/scene/use_reader.hpp"

#include "host/scene/key_list.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/mirror.hpp"
#include "host/scene/symbol_use.hpp"
#include "host/scene/track_builder.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <array>
#include <utility>

namespace kfast::scene {
namespace {

std::vector<ItemKey> read_keys(const kdl::Node& node, Reading& reading)
{
    KeyList keys{KeyHolder::group, reading};
    for (const kdl::Node& child : node.children) {
        if (reading.report.full())
            break;
        if (child.name == key_name)
            keys.read(child);
        else
            reading.report.error(child.name_place, "a use has no node " + quoted(child.name),
                                 suggestion(child.name, std::array{key_name}));
    }
    return keys.take();
}

}

std::optional<Item> read_use(const kdl::Node& node, int depth, Reading& reading)
{
    auto use = read_items_use(node, reading);
    std::vector<ItemKey> keys = read_keys(node, reading);
    if (!use)
        return std::nullopt;
    const Place place = span(node.name_place, node.arguments.front().place);
    if (depth + 1 + use->symbol->depth > deepest_item) {
        reading.report.error(place, too_deep());
        return std::nullopt;
    }
    mirror(use->mirror, use->values, keys);
    auto tracks = build_tracks(node, use->values, keys, reading);
    return Item{"", std::move(tracks), Use{reading.symbols.number(*use->symbol)}, place};
}

}
