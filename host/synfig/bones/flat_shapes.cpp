#include "host/synfig/bones/flat_shapes.hpp"

#include "host/art/document/matrix_at.hpp"

#include <cmath>

namespace kfast::synfig {
namespace {

using art::Affine;
using art::Transform;

// The channels that groups of Synfig have.
std::vector<const art::Channel*> channels_of(const Transform& transform)
{
    return {&transform.anchor_x, &transform.anchor_y, &transform.x,      &transform.y,
            &transform.scale_x,  &transform.scale_y,  &transform.rotate, &transform.skew};
}

art::Drawing mapped(const Affine& matrix, art::Drawing drawing)
{
    for (scene::Outline& outline : drawing.outlines)
        outline = matrix.of(outline);
    return drawing;
}

template <typename Value>
void add_times(const art::Animated<Value>& animated, std::vector<double>& times)
{
    for (const auto& key : animated.keys)
        times.push_back(key.time);
}

class Flattening {
public:
    explicit Flattening(const Layer& layer) : layer_{layer} {}

    void flatten(std::vector<art::Node>& nodes)
    {
        for (art::Node& node : nodes) {
            path_.push_back(std::move(node.transform));
            node.transform = {};
            if (auto* group = std::get_if<art::Group>(&node.content))
                flatten(group->nodes);
            else
                flatten(std::get<art::Shape>(node.content));
            path_.pop_back();
        }
    }

private:
    void flatten(art::Shape& shape)
    {
        std::vector<double> times;
        for (const Transform& transform : path_)
            for (const art::Channel* channel : channels_of(transform))
                if (!channel->is_still())
                    add_times(*channel, times);
        if (shape.stroke)
            flatten_width(*shape.stroke, times);
        if (times.empty()) {
            for (auto& key : shape.drawing.keys)
                key.value = mapped(matrix(0), std::move(key.value));
            return;
        }
        add_times(shape.drawing, times);
        const std::function<art::Drawing(double)> drawing = [this, &shape](double frame) {
            return mapped(matrix(frame), shape.drawing.at(frame));
        };
        shape.drawing = traced(drawing, tracing(std::move(times)));
    }

    void flatten_width(art::StrokeStyle& stroke, std::vector<double> times)
    {
        const auto scale_factor = [this](double frame) {
            return std::sqrt(std::abs(matrix(frame).determinant()));
        };
        if (times.empty()) {
            for (auto& key : stroke.width.keys)
                key.value *= scale_factor(0);
            return;
        }
        add_times(stroke.width, times);
        const std::function<double(double)> width = [&](double frame) {
            return stroke.width.at(frame) * scale_factor(frame);
        };
        stroke.width = traced(width, tracing(std::move(times)));
    }

    Tracing tracing(std::vector<double> times) const
    {
        return {0, layer_.reading().frames, std::move(times), place_tolerance, &layer_.reading().budget};
    }

    Affine matrix(double frame) const
    {
        Affine result;
        for (const Transform& transform : path_)
            result = result * matrix_at(transform, frame);
        return result;
    }

    const Layer& layer_;
    std::vector<Transform> path_; ///< the outermost first
};

}

void flatten(std::vector<art::Node>& nodes, const Layer& layer) { Flattening{layer}.flatten(nodes); }

}
