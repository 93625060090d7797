#include "host/scene/object_reader.hpp"

#include "host/scene/key_list.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/style_reader.hpp"
#include "host/scene/value_reader.hpp"

namespace kfast::scene {
namespace {

constexpr NodeForm object_form{"object", "object NAME fill=COLOUR { shapes or keys }", 1, 1, true};

}

std::optional<Object> read_object(const kdl::Node& node, Reading& reading)
{
    if (!fits(node, object_form, reading))
        return std::nullopt;
    Object object;
    object.place = span(node.name_place, node.arguments.front().place);
    read_style(node, object, reading);
    const auto name = read_text(node.arguments.front(), reading);
    if (!name)
        return std::nullopt;
    object.name = *name;
    if (node.children.empty())
        reading.report.error(object.place, "this object has no shapes and no keys",
                             "add { circle 10 10 r=5 } or { key 0 { … } }");
    KeyList keys{object, reading};
    for (const kdl::Node& child : node.children)
        if (!reading.report.full())
            keys.read(child);
    keys.finish();
    return object;
}

}
