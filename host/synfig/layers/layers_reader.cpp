#include "host/synfig/layers/layers_reader.hpp"

#include "host/synfig/bones/deformation_layer.hpp"
#include "host/synfig/layers/blending.hpp"
#include "host/synfig/layers/cover_layers.hpp"
#include "host/synfig/layers/group_layers.hpp"
#include "host/synfig/layers/shape_layers.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace kfast::synfig {
namespace {

class CanvasLayers {
public:
    CanvasLayers(pugi::xml_node canvas, Reading& reading, const Scope& scope)
        : reading_{reading}, scope_{scope}
    {
        for (const pugi::xml_node child : canvas.children("layer"))
            elements_.push_back(child);
        sort_by_depth();
        const auto drawn =
            std::ranges::find_if(elements_, [](pugi::xml_node element) { return Layer::is_drawn(element); });
        lowest_drawn_ = static_cast<std::size_t>(drawn - elements_.begin());
    }

    std::vector<art::Node> nodes() { return up_to(elements_.size(), scope_, 0); }

    /// The nodes of a switch, which shows one of them at a time.
    std::vector<art::Node> nodes_of_switch(const Layer& choice)
    {
        std::vector<art::Node> all;
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            const std::size_t depth = elements_.size() - 1 - i;
            auto nodes = read(Layer{elements_[i], reading_, scope_});
            for (art::Node& node : nodes) {
                node.shown = shown_by_switch(choice, elements_[i].attribute("desc").value(), depth);
                all.push_back(std::move(node));
            }
        }
        return all;
    }

private:
    /// Files have the lowest layer first; with depths, the deepest is lowest, and a layer counts one in
    /// depth.
    void sort_by_depth()
    {
        std::vector<std::pair<double, pugi::xml_node>> keyed;
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            const double depth = depth_of(elements_[i]);
            keyed.emplace_back(-(depth * 1.0001 + static_cast<double>(elements_.size() - 1 - i)),
                               elements_[i]);
        }
        std::ranges::stable_sort(keyed, {}, [](const auto& one) { return one.first; });
        for (std::size_t i = 0; i < keyed.size(); ++i)
            elements_[i] = keyed[i].second;
    }

    double depth_of(pugi::xml_node element)
    {
        for (const pugi::xml_node child : element.children("param"))
            if (std::string_view{child.attribute("name").value()} == "z_depth")
                if (const ValueNodePtr value = reading_.values.read_inside(child)) {
                    if (value->kind == "animated")
                        reading_.losses.add({"changing depth of a layer",
                                             element.attribute("desc").value(),
                                             {},
                                             "the depth that it has at first"});
                    return reading_.evaluator.at(*value, reading_.begin).number();
                }
        return 0;
    }

    /// Nodes of the lowest `count` layers. Those that change all below them take that as their content.
    std::vector<art::Node> up_to(std::size_t count, const Scope& scope, int depth)
    {
        art::Budget::check_depth(depth);
        std::vector<art::Node> above;  // the topmost first
        std::vector<art::Node> lowest; // what is painted below all the others, the lowest first
        std::vector<Tint> tints;       // the uppermost first
        while (count > 0) {
            const Layer layer{elements_[--count], reading_, scope};
            if (!layer.is_drawn())
                continue;
            if (is_for_all_below(layer)) {
                add(tinted(tints, changed(layer, count, scope, depth)), above);
                break;
            }
            const Blending blending = blending_of(layer, count == lowest_drawn_);
            if (blending == Blending::tinting)
                tints.push_back(tint_of(layer));
            else if (blending != Blending::left_out)
                add(tinted(tints, read(layer)), blending == Blending::behind ? lowest : above);
            if (blending == Blending::replacing)
                break;
        }
        std::move(lowest.rbegin(), lowest.rend(), std::back_inserter(above));
        std::ranges::reverse(above);
        return above;
    }

    static void add(std::vector<art::Node> nodes, std::vector<art::Node>& above)
    {
        std::move(nodes.rbegin(), nodes.rend(), std::back_inserter(above));
    }

    static std::vector<art::Node> tinted(const std::vector<Tint>& tints, std::vector<art::Node> nodes)
    {
        for (auto tint = tints.rbegin(); tint != tints.rend(); ++tint)
            tint->apply(nodes);
        return nodes;
    }

    static Blending blending_of(const Layer& layer, bool lies_lowest)
    {
        const auto covers = is_composite(layer) ? std::nullopt : covers_in(layer);
        const Extent extent = covers || is_cover(layer) ? Extent::everywhere : Extent::shape;
        const Blending blending = synfig::blending_of(layer, extent, lies_lowest);
        if (blending != Blending::tinting || !covers || covers->is_alone)
            return blending;
        layer.lose("blend method of a group that fills all of the canvas", "the layer is left out");
        return Blending::left_out;
    }

    static Tint tint_of(const Layer& layer)
    {
        const auto covers = covers_in(layer);
        const Layer& cover = covers ? covers->lowest : layer;
        if (colour_name(cover) != std::string_view{"color"})
            cover.lose("gradient", "its mean colour, on what lies below");
        return covers ? Tint{layer, cover} : Tint{layer};
    }

    static bool is_for_all_below(const Layer& layer)
    {
        const std::string& type = layer.type();
        return type == "translate" || type == "rotate" || type == "zoom" || type == "stretch" ||
               type == "timeloop" || type == "freetime" || type == "skeleton_deformation";
    }

    std::vector<art::Node> changed(const Layer& layer, std::size_t count, const Scope& scope, int depth)
    {
        if (auto gear = gear_of(layer)) {
            Scope inner = scope;
            inner.clock = scope.clock.with(std::move(*gear));
            return up_to(count, inner, depth + 1);
        }
        Scope inner = scope;
        inner.is_deformed = scope.is_deformed || layer.type() == "skeleton_deformation";
        std::vector<art::Node> nodes = up_to(count, inner, depth + 1);
        if (layer.type() == "skeleton_deformation")
            return deformed(layer, std::move(nodes));
        art::Node group;
        group.name = layer.name();
        group.transform = *movement_of(layer);
        group.content = art::Group{std::move(nodes)};
        std::vector<art::Node> result;
        result.push_back(std::move(group));
        return result;
    }

    std::vector<art::Node> read(const Layer& layer)
    {
        std::vector<art::Node> nodes;
        if (!layer.is_drawn() || layer.type() == "skeleton")
            return nodes;
        if (is_group(layer))
            nodes.push_back(group(layer));
        else if (auto cover = read_cover_layer(layer))
            nodes.push_back(std::move(*cover));
        else if (auto shape = read_shape_layer(layer))
            nodes.push_back(std::move(*shape));
        else if (auto line = read_line_layer(layer))
            nodes.push_back(std::move(*line));
        else
            layer.lose("layer \"" + layer.type() + '"', "the layer is left out");
        return nodes;
    }

    art::Node group(const Layer& layer)
    {
        layer.lose_others({"origin", "transformation", "time_offset", "time_dilation", "outline_grow",
                           "focus", "zoom", "children_lock", "z_range", "z_range_position", "z_range_depth",
                           "z_range_blur", "layer_name", "layer_depth"});
        if (layer.truth("z_range", 0, false))
            layer.lose("range of depths", "all layers of the group");
        if (!layer.canvas())
            layer.lose("group of another file, or without content", "an empty group");
        art::Node node = node_of(layer);
        node.transform = placement_of(layer);
        Scope inner = inside_of(layer);
        art::Budget::check_depth(inner.depth);
        CanvasLayers content{layer.canvas(), reading_, inner};
        node.content =
            art::Group{layer.type() == "switch" ? content.nodes_of_switch(layer) : content.nodes()};
        return node;
    }

    Reading& reading_;
    Scope scope_;
    std::vector<pugi::xml_node> elements_; ///< the lowest first
    std::size_t lowest_drawn_ = 0;         ///< of `elements_`; their number if none is drawn
};

}

std::vector<art::Node> read_layers(pugi::xml_node canvas, Reading& reading, const Scope& scope)
{
    return CanvasLayers{canvas, reading, scope}.nodes();
}

}
