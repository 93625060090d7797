#include "host/scene/language_schema.hpp"

#include "host/scene/font/font_shelf.hpp"
#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/items/input_reader.hpp"
#include "host/scene/items/item_reader.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/items/object_reader.hpp"
#include "host/scene/items/skeleton_reader.hpp"
#include "host/scene/items/symbol_reader.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/items/track_reader.hpp"
#include "host/scene/scene_reader.hpp"
#include "host/scene/shapes/shape_reader.hpp"
#include "host/scene/shapes/wire_reader.hpp"
#include "host/scene/skeleton/backbone_reader.hpp"
#include "host/scene/skeleton/bone_reader.hpp"
#include "host/scene/skeleton/bones_reader.hpp"
#include "host/scene/skeleton/pose_reader.hpp"
#include "host/scene/skeleton/reach_reader.hpp"
#include "host/scene/skeleton/weights_reader.hpp"
#include "host/scene/values/canvas_reader.hpp"
#include "host/scene/values/clips_and_events.hpp"
#include "host/scene/values/law_reader.hpp"
#include "host/scene/values/let_reader.hpp"
#include "host/scene/values/timed_quantity.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kfast::scene {
namespace {

std::vector<NodeSchema> all_nodes()
{
    std::vector<NodeSchema> nodes;
    const auto add = [&nodes](std::vector<NodeSchema> words) {
        std::ranges::move(words, std::back_inserter(nodes));
    };
    add({version_schema(), let_schema(), canvas_schema()});
    add(palette_schema());
    add(input_schema());
    add({object_schema(), group_schema()});
    add(use_schema());
    add(symbol_schema());
    add(key_schema());
    add(track_schema());
    add({at_schema()});
    add(shape_schema());
    add(wire_schema());
    add(mesh_schema());
    add({empty_schema(), skeleton_schema()});
    add(backbone_schema());
    add(weights_schema());
    add({bones_schema(), bone_schema()});
    add(pose_schema());
    add(reach_schema());
    add({clip_schema(), event_schema()});
    return nodes;
}

}

LanguageSchema language_schema()
{
    const auto outermost = names_outermost();
    const auto fonts = FontShelf::bundled_names();
    return {{outermost.begin(), outermost.end()},
            all_nodes(),
            quantity_schema(),
            law_forms(),
            known_colour_names(),
            {fonts.begin(), fonts.end()}};
}

std::vector<std::string_view> holders(const LanguageSchema& words, std::string_view id)
{
    std::vector<std::string_view> ids;
    if (std::ranges::find(words.outermost, id) != words.outermost.end())
        ids.push_back("");
    for (const NodeSchema& node : words.nodes)
        if (std::ranges::find(node.inside, id) != node.inside.end() &&
            std::ranges::find(ids, node.id) == ids.end())
            ids.push_back(node.id);
    return ids;
}

}
