#include "host/scene/items/drawing_content.hpp"

#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/items/item_reader.hpp"
#include "host/scene/items/key_list.hpp"
#include "host/scene/items/symbol_kind.hpp"
#include "host/scene/items/track_reader.hpp"
#include "host/scene/skeleton/weights_reader.hpp"
#include "host/text/glyph.hpp"
#include "host/words/synonyms.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace kfast::scene {
namespace {

class ContentReader {
public:
    ContentReader(KeyHolder holder, const KeyDriver& driver, SceneContext& context)
        : holder_{holder}, noun_{holder == KeyHolder::object ? "an object" : "a symbol"}, context_{context},
          keys_{holder, driver, context}
    {
    }

    void read(const kdl::Node& node)
    {
        if (node.name == key_name)
            read_key(node);
        else if (is_drawn(node.name))
            read_drawn(node);
        else if (holder_ == KeyHolder::object && node.name == track_name)
            read_timed(node);
        else if (holder_ == KeyHolder::object && node.name == weights_name)
            read_weights(node);
        else if (holder_ == KeyHolder::symbol && is_item(node.name))
            report_mixed_kinds(node, context_);
        else
            report_unknown(node);
    }

    DrawingContent take()
    {
        content_.keys = keys_.take();
        return std::move(content_);
    }

private:
    void read_key(const kdl::Node& node)
    {
        const bool has_drawing = holds_drawing(node);
        if (has_drawing && !content_.drawn.empty())
            return report_mixture(node);
        has_drawing_keys_ = has_drawing_keys_ || has_drawing;
        content_.is_valid = keys_.read(node) && content_.is_valid;
    }

    void read_drawn(const kdl::Node& node)
    {
        if (has_drawing_keys_)
            return report_mixture(node);
        content_.drawn.push_back(&node);
    }

    void read_weights(const kdl::Node& node)
    {
        if (content_.weights == nullptr)
            content_.weights = &node;
        else
            context_.report.error(node.name_span, "this object has weights already, on " +
                                                      context_.report.line(content_.weights->name_span));
    }

    void read_timed(const kdl::Node& node)
    {
        if (auto quantity = read_track(node, holder_, context_))
            content_.timed.push_back(std::move(*quantity));
    }

    void report_mixture(const kdl::Node& node)
    {
        if (!std::exchange(is_mixed_, true))
            context_.report.error(
                node.name_span, std::string{noun_} + " has its drawings either in keys or without, not both",
                "put the shapes into a key: key 0 { … }");
    }

    void report_unknown(const kdl::Node& node)
    {
        if (node.name == skeleton_name)
            return report_skeleton(node);
        content_.is_valid =
            context_.report.error(node.name_span, std::string{noun_} + " has no node " + in_quotes(node.name),
                                  word_hint(node.name, names_in_drawing(holder_)));
    }

    void report_skeleton(const kdl::Node& node)
    {
        content_.is_valid = context_.report.error(node.name_span, "a skeleton stands in a key of an object",
                                                  "write key 0 { skeleton { … } }");
    }

    KeyHolder holder_;
    std::string_view noun_;
    SceneContext& context_;
    KeyList keys_;
    DrawingContent content_;
    bool has_drawing_keys_ = false;
    bool is_mixed_ = false; ///< has been reported
};

}

DrawingContent read_drawing_content(const kdl::Node& node, KeyHolder holder, const KeyDriver& driver,
                                    SceneContext& context)
{
    ContentReader content{holder, driver, context};
    for (const kdl::Node& child : node.children)
        if (!context.report.full())
            content.read(child);
    return content.take();
}

std::vector<std::string_view> names_in_drawing(KeyHolder holder)
{
    std::vector<std::string_view> names = drawn_names();
    names.insert(names.begin(), key_name);
    if (holder == KeyHolder::object) {
        names.insert(names.begin() + 1, track_name);
        names.push_back(weights_name);
    }
    return names;
}

}
