#include "host/lottie/layers/composition.hpp"

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/extent.hpp"
#include "host/lottie/layers/layer.hpp"
#include "host/lottie/layers/unread.hpp"
#include "host/lottie/shapes/transform.hpp"

#include <deque>
#include <unordered_map>
#include <utility>

namespace kfast::lottie {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// A layer's own transform and those of its parents.
class Chain {
public:
    explicit Chain(const Around* outer) : innermost_{outer} {}
    Chain(const Chain&) = delete;
    Chain& operator=(const Chain&) = delete;

    void add(art::Transform transform)
    {
        transforms_.push_back(std::move(transform));
        around_.push_back({innermost_, &transforms_.back()});
        innermost_ = &around_.back();
    }
    const Around& innermost() const { return *innermost_; }
    /// The outermost parent first, the layer's own last.
    std::deque<art::Transform>& transforms() { return transforms_; }

private:
    std::deque<art::Transform> transforms_;
    std::deque<Around> around_;
    const Around* innermost_;
};

class CompositionReader {
public:
    CompositionReader(const Composition& composition, Animation& animation, const Reading& reading)
        : composition_{composition},
          layers_{composition.layers},
          animation_{animation},
          reading_{reading},
          tags_(layers_.size(), 0)
    {
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            if (!layers_[i].is_object())
                throw WrongMember(layers_[i], "is no layer: one is an object");
            numbers_.emplace(whole_at(layers_[i], "ind", static_cast<int>(i) + 1), i);
        }
        for (const Json& layer : layers_)
            if (const auto parent = parent_of(layer))
                tags_[*parent] = 1;
        for (std::size_t& tag : tags_)
            if (tag != 0)
                tag = ++animation_.tags;
    }

    std::vector<art::Node> nodes()
    {
        std::vector<art::Node> result;
        for (std::size_t i = layers_.size(); i-- > 0;) {
            reading_.budget.take_node();
            if (auto node = read_node(i))
                result.push_back(std::move(*node));
        }
        return result;
    }

private:
    std::optional<std::size_t> by_number(int number) const
    {
        const auto found = numbers_.find(number);
        return found == numbers_.end() ? std::nullopt : std::optional{found->second};
    }

    std::optional<std::size_t> parent_of(const Json& layer) const
    {
        return find_member(layer, "parent") ? by_number(whole_at(layer, "parent", 0)) : std::nullopt;
    }

    Reading reading_of(std::size_t index) const
    {
        Reading reading = reading_;
        const std::string name = name_of(layers_[index], index);
        reading.layer = reading_.layer.empty() ? name : reading_.layer + " / " + name;
        return reading;
    }

    /// From the nearest to the outermost.
    std::vector<std::size_t> parents_of(std::size_t index) const
    {
        std::vector<std::size_t> parents;
        for (auto parent = parent_of(layers_[index]); parent; parent = parent_of(layers_[*parent])) {
            if (*parent == index || std::ranges::find(parents, *parent) != parents.end())
                throw WrongMember(layers_[index],
                                  "its parents go round in a circle: take one \"parent\" out");
            parents.push_back(*parent);
            art::Budget::check_depth(reading_.depth + static_cast<int>(parents.size()));
        }
        return parents;
    }

    void read_chain(Chain& chain, std::size_t index, const std::vector<std::size_t>& parents)
    {
        for (std::size_t i = parents.size(); i-- > 0;) {
            const Reading reading = reading_of(parents[i]);
            if (const Json* const ks = find_member(layers_[parents[i]], "ks"))
                report_expressions(*ks, "ks", animation_, reading);
            chain.add(read_layer_transform(layers_[parents[i]], reading));
        }
        chain.add(read_layer_transform(layers_[index], reading_of(index)));
    }

    bool is_drawn(const Json& layer) const
    {
        const LayerKind kind = kind_of(layer);
        return kind != LayerKind::null && kind != LayerKind::guide && kind != LayerKind::camera &&
               !truth_at(layer, "hd", false) && !truth_at(layer, "td", false);
    }

    static bool is_cut(const Json& layer)
    {
        return find_member(layer, "masksProperties") || whole_at(layer, "tt", 0) != 0;
    }

    /// When it is visible while the composition is; empty if never.
    art::Span seen_of(const art::Span& shown) const
    {
        return {std::max(shown.from, composition_.seen.from), std::min(shown.to, composition_.seen.to)};
    }

    std::optional<art::Node> read_node(std::size_t index)
    {
        const Json& json = layers_[index];
        Reading reading = reading_of(index);
        if (!is_drawn(json))
            return std::nullopt;
        const art::Span shown = span_of(json, reading.time, composition_.seen);
        const art::Span seen = seen_of(shown);
        if (!(seen.from < seen.to))
            return std::nullopt;
        report_unread(json, animation_, reading);
        const std::vector<std::size_t> parents = parents_of(index);
        report_missing_parent(json, reading);
        Chain chain{composition_.around};
        read_chain(chain, index, parents);
        if (is_cut(json) || std::ranges::any_of(chain.transforms(), changes_while_skewed))
            reading.symbols = nullptr;
        const Layer layer{json, reading, chain.innermost(), seen};
        std::vector<art::Node> content = read_content(layer, animation_);
        apply_masks(content, layer);
        apply_matte_to(content, layer, index);
        if (content.empty())
            return std::nullopt;
        return within_parents(leaf(std::move(content), layer, shown, index, chain), parents, chain);
    }

    void report_missing_parent(const Json& layer, const Reading& reading) const
    {
        if (find_member(layer, "parent") && !parent_of(layer))
            reading.losses.add({"parent " + std::to_string(whole_at(layer, "parent", 0)), reading.layer,
                                std::nullopt, "none: there is no such layer"});
    }

    void apply_matte_to(std::vector<art::Node>& content, const Layer& layer, std::size_t index)
    {
        if (whole_at(layer.json, "tt", 0) == 0 || content.empty())
            return;
        std::optional<std::size_t> source;
        if (find_member(layer.json, "tp"))
            source = by_number(whole_at(layer.json, "tp", 0));
        else if (index > 0)
            source = index - 1;
        animation_.depends_on_place = true; // if it is within a symbol
        if (!source || *source == index)
            return layer.reading.losses.add(
                {"matte", layer.reading.layer, std::nullopt, "none: there is no layer to take it from"});
        const Reading reading = reading_of(*source);
        const LayerKind kind = kind_of(layers_[*source]);
        if (kind != LayerKind::solid && kind != LayerKind::shapes)
            return report_matte(layer);
        reading_.budget.take_node();
        Chain chain{composition_.around};
        read_chain(chain, *source, parents_of(*source));
        const Layer matte{layers_[*source], reading, chain.innermost(), layer.seen};
        art::Losses unheard; // it is not drawn
        Reading quiet{reading.budget, unheard, reading.time, reading.layer, reading.depth};
        std::vector<art::Node> nodes =
            read_content({matte.json, quiet, matte.around, matte.seen}, animation_);
        apply_matte(content, layer,
                    {matte, std::move(nodes), span_of(matte.json, reading.time, {-endless, endless})});
    }

    /// The layer itself, without its parents.
    art::Node leaf(std::vector<art::Node> content, const Layer& layer, const art::Span& shown,
                   std::size_t index, Chain& chain)
    {
        art::Node node;
        node.name = given_name(layer.json);
        if (const Json* const ks = find_member(layer.json, "ks"))
            node.opacity = read_channel(*ks, "o", 0, 1, 0.01, layer.reading.time, layer.reading.budget);
        node.shown = {shown};
        node.content = art::Group{std::move(content)};
        art::Transform& own = chain.transforms().back();
        if (tags_[index] == 0) {
            node.transform = own;
            return node;
        }
        art::Node group;
        group.name = node.name;
        group.transform = own;
        group.parent_tag = tags_[index];
        if (node.opacity == art::Channel{1} && shown == art::Span{}) {
            group.content = std::move(node.content);
        } else {
            reading_.budget.take_node();
            group.content = art::Group{{std::move(node)}};
        }
        return group;
    }

    art::Node within_parents(art::Node node, const std::vector<std::size_t>& parents, Chain& chain)
    {
        for (std::size_t i = 0; i < parents.size(); ++i) {
            reading_.budget.take_node();
            art::Node group;
            group.name = given_name(layers_[parents[i]]);
            group.transform = chain.transforms()[parents.size() - 1 - i];
            group.parent_tag = tags_[parents[i]];
            group.content = art::Group{{std::move(node)}};
            node = std::move(group);
        }
        return node;
    }

    const Composition& composition_;
    const Json& layers_;
    Animation& animation_;
    const Reading& reading_;
    std::unordered_map<int, std::size_t> numbers_;
    std::vector<std::size_t> tags_; ///< art::Node::parent_tag, of layers that are parents
};

}

std::vector<art::Node> read_composition(const Composition& composition, Animation& animation,
                                        const Reading& reading)
{
    Reading seen = reading;
    seen.time.seen = composition.seen;
    return CompositionReader{composition, animation, seen}.nodes();
}

std::size_t weight(const Around* around)
{
    std::size_t total = 0;
    for (; around; around = around->outer)
        if (around->transform)
            total += weight(*around->transform);
    return total;
}

bool is_within_symbol(const Around* around)
{
    while (around && around->transform)
        around = around->outer;
    return around && around->is_symbol;
}

std::optional<art::Affine> canvas_matrix(const Around* around, double time)
{
    art::Affine matrix;
    for (; around; around = around->outer) {
        if (!around->transform)
            return std::nullopt;
        matrix = matrix_at(*around->transform, time) * matrix;
    }
    return matrix;
}

}
