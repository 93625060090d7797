#include "host/scene_text/arrange/line_pens.hpp"

#include "host/art/document/matrix_at.hpp"
#include "host/scene_text/arrange/placement.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace kfast::scene_text {
namespace {

using art::Affine;
using art::Node;

constexpr double min = 0.05;
/// Of the times that are looked at, for each shape.
constexpr std::size_t max_times = 64;

void add_times(const art::Transform& transform, std::vector<double>& times)
{
    for (const art::Channel* channel :
         {&transform.scale_x, &transform.scale_y, &transform.skew, &transform.rotate})
        for (const auto& key : channel->keys)
            if (times.size() < max_times)
                times.push_back(key.time);
}

class Pens {
public:
    explicit Pens(art::Losses& losses) : losses_{losses} {}

    void look_at(const std::vector<Node>& nodes)
    {
        for (const Node& node : nodes) {
            around_.push_back(&node);
            if (const auto* const group = std::get_if<art::Group>(&node.content))
                look_at(group->nodes);
            else if (std::get<art::Shape>(node.content).stroke)
                look_at_line();
            around_.pop_back();
        }
    }

private:
    /// Of the innermost node.
    void look_at_line()
    {
        std::vector<double> times;
        for (const Node* node : around_)
            add_times(node->transform, times);
        std::ranges::sort(times);
        const auto bent =
            std::ranges::find_if(times, [this](double time) { return distortion_of(shape(time)) > min; });
        if (bent == times.end())
            return;
        const bool is_later = *bent > times.front();
        losses_.add({"a line that becomes wider one way than the other", names(),
                     is_later ? std::optional{*bent} : std::nullopt, "it is as wide in every direction"});
    }

    Affine shape(double time) const
    {
        Affine shape;
        for (const Node* node : around_)
            shape = shape * shape_at(node->transform, time);
        return shape;
    }

    std::string names() const
    {
        std::string names;
        for (const Node* node : around_)
            if (!node->name.empty())
                names += (names.empty() ? "" : " / ") + node->name;
        return names;
    }

    art::Losses& losses_;
    std::vector<const Node*> around_ = {}; ///< from the outermost
};

}

void report_bent_pens(const std::vector<Node>& nodes, art::Losses& losses) { Pens{losses}.look_at(nodes); }

}
