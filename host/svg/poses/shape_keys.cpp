#include "host/svg/poses/shape_keys.hpp"

#include "host/svg/parts/motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace kfast::svg {
namespace {

using art::Affine;
using art::Drawing;

/// In pixels: nothing beyond it is visible.
constexpr double farthest = 1e6;
/// In pixels: files of drawings are rounded, most of them to 1/1000 of their units.
constexpr double rounding = 1.0 / 64;
/// For points that are rounded before they are scaled.
constexpr double max_scale_factor = 4;

bool is_near_enough(scene::Vec2 spot) { return std::abs(spot.x) <= farthest && std::abs(spot.y) <= farthest; }

bool is_near_enough(const Drawing& drawing)
{
    return std::ranges::all_of(drawing.outlines, [](const scene::Outline& outline) {
        return is_near_enough(outline.from) &&
               std::ranges::all_of(outline.curves, [](const scene::Curve& curve) {
                   return is_near_enough(curve.to) && is_near_enough(curve.c1) && is_near_enough(curve.c2);
               });
    });
}

Drawing through(const Affine& affine, const Drawing& drawing)
{
    Drawing result;
    for (const scene::Outline& outline : drawing.outlines)
        result.outlines.push_back(affine.of(outline));
    return result;
}

/// The moments without what is too far away.
Moments drawable(const Moments& moments, art::Losses& losses)
{
    Moments result = moments;
    for (Moment& moment : result) {
        if (moment.part == nullptr ||
            is_near_enough(through(moment.fold * moment.part->own, moment.part->drawing)))
            continue;
        losses.add({"points more than a million pixels away", moment.part->layer, {}, "it is not drawn"});
        moment.part = nullptr;
    }
    return result;
}

double scale_factor(const Affine& affine) { return std::sqrt(std::abs(affine.determinant())); }

class ShapeMaker {
public:
    /// All moments have the part.
    ShapeMaker(const Moments& moments, art::Budget& budget, art::Losses& losses)
        : moments_{moments},
          first_{*moments.front().part},
          ways_{ways(moments)},
          instants_{instants(moments)},
          budget_{budget},
          losses_{losses}
    {
    }

    art::Node node()
    {
        art::Shape shape;
        motion_ = same_drawing() ? motion_of(moments_) : fitted_motion();
        shape.drawing = motion_ ? still_drawing() : changing_drawing(shape.matches_length);
        if (has(&Part::fill))
            shape.fill = fill();
        if (has(&Part::pen))
            shape.stroke = stroke();
        art::Node node;
        node.name = first_.name;
        node.content = std::move(shape);
        node.opacity = channel(values_of(moments_, [](const Part& part) { return part.opacity; }));
        if (motion_)
            node.transform = transform_of(*motion_, moments_, budget_);
        return node;
    }

private:
    bool same_drawing() const
    {
        return std::ranges::all_of(moments_,
                                   [&](const Moment& each) { return each.part->drawing == first_.drawing; });
    }

    /// For points that were moved, rotated or scaled evenly together; a line would have to scale with them.
    std::optional<Motion> fitted_motion() const
    {
        const Drawing from = through(ways_.front(), first_.drawing);
        std::vector<Affine> from_there;
        for (std::size_t i = 0; i < moments_.size(); ++i) {
            const Part& part = *moments_[i].part;
            const auto fit = similarity(from, through(ways_[i], part.drawing), rounding);
            if (!fit || scale_factor(*fit) > max_scale_factor || scale_factor(*fit) * max_scale_factor < 1 ||
                (has(&Part::pen) && std::abs(scale_factor(*fit) * width(0) - width(i)) > rounding))
                return std::nullopt;
            from_there.push_back(*fit);
        }
        const auto box = box_of(first_, ways_.front());
        return box ? motion_of(ways_.front(), std::move(from_there), *box) : std::nullopt;
    }

    art::Animated<Drawing> still_drawing() const { return {through(ways_.front(), first_.drawing)}; }

    art::Animated<Drawing> changing_drawing(bool& matches_length)
    {
        std::vector<Drawing> drawings;
        for (std::size_t i = 0; i < moments_.size(); ++i) {
            drawings.push_back(through(ways_[i], moments_[i].part->drawing));
            matches_length = matches_length || !art::same_form(drawings.front(), drawings.back());
        }
        auto result = keyed(instants_, drawings, std::equal_to<>{}, budget_);
        for (const auto& key : result.keys)
            for (const scene::Outline& outline : key.value.outlines)
                budget_.take_points(1 + outline.curves.size());
        return result;
    }

    art::Fill fill()
    {
        report_change("fill-rule", [](const Part& part) { return part.rule; });
        const auto inks = inks_of([](const Part& part) { return part.fill; });
        return {.colour = colours(inks), .opacity = opacities(inks), .rule = first_.rule};
    }

    art::StrokeStyle stroke()
    {
        const Pen& pen = *(*std::ranges::find_if(moments_, [](const Moment& each) {
                              return each.part->pen.has_value();
                          })).part->pen;
        report_change("stroke-linecap", [&](const Part& part) { return part.pen.value_or(pen).cap; });
        report_change("stroke-linejoin", [&](const Part& part) { return part.pen.value_or(pen).join; });
        if (std::ranges::any_of(ways_, [](const Affine& way) { return !is_even(way); }) && !pen.keeps_width)
            losses_.add({"line that is scaled unevenly", first_.layer, {}, "a width between the two"});
        std::vector<double> widths;
        for (std::size_t i = 0; i < moments_.size(); ++i)
            widths.push_back(motion_ ? width_at_rest(i) : width(i));
        const auto inks =
            inks_of([](const Part& part) { return part.pen ? std::optional{part.pen->ink} : std::nullopt; });
        return {.colour = colours(inks),
                .opacity = opacities(inks),
                .width = channel(widths),
                .cap = pen.cap,
                .join = pen.join,
                .miter_limit = pen.miter_limit,
                .dashes = dashes(pen)};
    }

    /// Lengths that grow and shrink with the width, of the moments that have as many of them as `pen`.
    art::Dashes dashes(const Pen& pen)
    {
        const std::size_t count = pen.dashes.lengths.size();
        report_change("stroke-dasharray",
                      [&](const Part& part) { return part.pen.value_or(pen).dashes.lengths.size(); });
        const auto values = [&](const auto& length) {
            std::vector<double> lengths;
            for (std::size_t i = 0; i < moments_.size(); ++i) {
                const Pen own = moments_[i].part->pen.value_or(pen);
                const bool has_as_many = own.dashes.lengths.size() == count;
                lengths.push_back(pen_scale(i, own) * length(has_as_many ? own.dashes : pen.dashes));
            }
            return channel(lengths);
        };
        art::Dashes dashes;
        if (count == 0)
            return dashes;
        for (std::size_t length = 0; length < count; ++length)
            dashes.lengths.push_back(values([length](const Dashes& own) { return own.lengths[length]; }));
        dashes.offset = values([](const Dashes& own) { return own.offset; });
        return dashes;
    }

    /// From units of the drawing to those of the shape.
    double pen_scale(std::size_t moment, const Pen& pen) const
    {
        return pen.keeps_width ? 1 : scale_factor(motion_ ? motion_->at_rest : ways_[moment]);
    }

    /// The width on the canvas, or in the node around; without a line there, that of the first that has one.
    double width(std::size_t moment) const
    {
        const Part* part = moments_[moment].part;
        if (!part->pen)
            part = std::ranges::find_if(moments_, [](const Moment& each) {
                       return each.part->pen.has_value();
                   })->part;
        return part->pen->keeps_width ? part->pen->width : scale_factor(ways_[moment]) * part->pen->width;
    }

    /// The node's scale is applied to it.
    double width_at_rest(std::size_t moment)
    {
        const double grown = scale_factor(motion_->from_there[moment]);
        const Part& part = *moments_[moment].part;
        if (!part.pen || !part.pen->keeps_width)
            return scale_factor(motion_->at_rest) * (part.pen ? part.pen->width : width(moment));
        if (std::abs(grown - 1) > rounding)
            losses_.add({"vector-effect non-scaling-stroke", first_.layer, {}, "the line grows as well"});
        return part.pen->width;
    }

    template <typename Member>
    bool has(Member member) const
    {
        return std::ranges::any_of(moments_,
                                   [&](const Moment& each) { return (each.part->*member).has_value(); });
    }

    /// Where nothing is painted, the last colour, or the first one, is used: it is not visible.
    template <typename Get>
    std::vector<Ink> inks_of(const Get& get) const
    {
        std::vector<Ink> inks;
        for (const Moment& moment : moments_) {
            const std::optional<Ink> ink = get(*moment.part);
            const art::Rgb last = inks.empty() ? first_ink(get).colour : inks.back().colour;
            inks.push_back(ink.value_or(Ink{last, 0}));
        }
        return inks;
    }

    template <typename Get>
    Ink first_ink(const Get& get) const
    {
        for (const Moment& moment : moments_)
            if (const auto ink = get(*moment.part))
                return *ink;
        return {};
    }

    template <typename Get>
    void report_change(const char* feature, const Get& get)
    {
        for (const Moment& moment : moments_)
            if (get(*moment.part) != get(first_))
                losses_.add({std::string{"change of "} + feature, first_.layer, moment.instant.time,
                             "as it is at first"});
    }

    art::Channel channel(const std::vector<double>& values)
    {
        return keyed(instants_, values, std::equal_to<>{}, budget_);
    }

    art::Animated<art::Rgb> colours(const std::vector<Ink>& inks)
    {
        std::vector<art::Rgb> values;
        values.reserve(inks.size());
        for (const Ink& ink : inks)
            values.push_back(ink.colour);
        return keyed(instants_, values, std::equal_to<>{}, budget_);
    }

    art::Channel opacities(const std::vector<Ink>& inks)
    {
        std::vector<double> values;
        values.reserve(inks.size());
        for (const Ink& ink : inks)
            values.push_back(ink.opacity);
        return channel(values);
    }

    const Moments& moments_;
    const Part& first_;
    std::vector<Affine> ways_;
    std::vector<Instant> instants_;
    art::Budget& budget_;
    art::Losses& losses_;
    std::optional<Motion> motion_;
};

}

std::optional<art::Node> shape_node(const Moments& moments, art::Budget& budget, art::Losses& losses)
{
    const Moments near = drawable(moments, losses);
    const Moments seen = present(near);
    if (seen.empty())
        return std::nullopt;
    art::Node node = ShapeMaker{seen, budget, losses}.node();
    if (node.opacity.is_still() && node.opacity.value() <= 0)
        return std::nullopt;
    node.shown = spans(near);
    return node;
}

}
