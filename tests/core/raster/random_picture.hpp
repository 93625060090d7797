#pragma once

#include "core/raster/renderer.hpp"

#include <cstdint>
#include <random>
#include <vector>

namespace kfast::raster {

/// A layer of a picture that moves: polygons that turn, grow and shift from step to step.
struct RandomLayer {
    Colour colour;
    FillRule rule = FillRule::nonzero;
    std::vector<std::vector<Corner>> contours;
    std::uint32_t item = 0;
};

/// Layers, some of them in groups, that move, change their colours, come and go.
class RandomPicture {
public:
    RandomPicture(Size panel, std::uint32_t seed, int layers) : panel_{panel}, random_{seed}
    {
        while (static_cast<int>(layers_.size()) < layers)
            layers_.push_back(layer());
    }

    /// To another picture.
    void step()
    {
        ++step_;
        moved_ = 0;
        if (chance(4) && layers_.size() > 1)
            layers_.erase(layers_.begin() + static_cast<std::ptrdiff_t>(random_() % layers_.size()));
        if (chance(4))
            layers_.insert(layers_.begin() + static_cast<std::ptrdiff_t>(random_() % (layers_.size() + 1)),
                           layer());
        for (RandomLayer& layer : layers_) {
            if (chance(5))
                layer.colour = colour();
            if (chance(3))
                continue;
            moved_ |= bit_of(layer);
            for (auto& contour : layer.contours)
                shift(contour);
        }
        group_begin_ = random_() % (layers_.size() + 1);
        group_opacity_ = chance(3) ? 128 : 200;
    }

    /// Every second picture has a group and another one in it, if `has_groups`. Outlines that the renderer
    /// has from the picture before are kept if `keeps`, and if there is room for the others beside them.
    void show(Renderer& renderer, bool has_groups, bool keeps = false) const
    {
        OutlineStore& outlines = renderer.picture().outlines;
        if (keeps)
            outlines.keep({.keys = moved_});
        else
            outlines.clear();
        add_all(renderer.picture(), has_groups);
        if (outlines.is_full() && outlines.keeps_layers())
            return show(renderer, has_groups);
        renderer.begin();
    }

    const std::vector<RandomLayer>& layers() const { return layers_; }

private:
    void add_all(Picture& picture, bool has_groups) const
    {
        picture.step_count = 0;
        const std::size_t group_begin = has_groups && step_ % 2 == 0 ? group_begin_ : layers_.size();
        const std::size_t inner_begin = (group_begin + layers_.size()) / 2;
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            if (i == group_begin)
                picture.add_step(group_step(PaintStep::Kind::begin_group));
            if (i == inner_begin)
                picture.add_step(group_step(PaintStep::Kind::begin_group));
            add(picture, layers_[i]);
        }
        for (const std::size_t begin : {inner_begin, group_begin})
            if (begin < layers_.size())
                picture.add_step(group_step(PaintStep::Kind::end_group));
    }

    bool chance(std::uint32_t times) { return random_() % times == 0; }
    std::int32_t between(std::int32_t low, std::int32_t high)
    {
        return low + static_cast<std::int32_t>(random_() % static_cast<std::uint32_t>(high - low + 1));
    }
    Colour colour()
    {
        const auto channel = [this] { return static_cast<std::uint8_t>(random_()); };
        return {channel(), channel(), channel(), chance(4) ? channel() : std::uint8_t{255}};
    }

    RandomLayer layer()
    {
        RandomLayer added{colour(), chance(2) ? FillRule::nonzero : FillRule::even_odd, {}, ++items_};
        for (std::int32_t contours = between(1, 2); contours > 0; --contours)
            added.contours.push_back(contour());
        return added;
    }

    /// Some have level and upright edges, some lie on whole pixels, some reach far out.
    std::vector<Corner> contour()
    {
        std::vector<Corner> corners;
        const std::int32_t reach = chance(8) ? 20 * (panel_.width + panel_.height) : 8;
        const std::int32_t unit = chance(4) ? grid : 1;
        for (std::int32_t count = between(3, 9); count > 0; --count)
            corners.push_back({between(-reach, panel_.width + reach) * grid / unit * unit +
                                   (unit == 1 ? between(0, 63) : 0),
                               between(-reach, panel_.height + reach) * grid / unit * unit +
                                   (unit == 1 ? between(0, 63) : 0)});
        for (std::size_t i = 1; i < corners.size(); ++i) {
            if (chance(4))
                corners[i].y = corners[i - 1].y;
            else if (chance(4))
                corners[i].x = corners[i - 1].x;
        }
        return corners;
    }

    void shift(std::vector<Corner>& contour)
    {
        const Corner way{between(-100, 100), between(-100, 100)};
        for (Corner& corner : contour)
            corner = {corner.x + way.x, corner.y + way.y};
        if (chance(3))
            contour[random_() % contour.size()].x += between(-200, 200);
    }

    PaintStep group_step(PaintStep::Kind kind) const
    {
        PaintStep step;
        step.kind = kind;
        step.opacity = group_opacity_;
        step.item = 0xFFFF'0000;
        return step;
    }

    /// A few layers have the same: they are traced anew once more often.
    static std::uint32_t bit_of(const RandomLayer& layer) { return Dependence::bit(layer.item); }

    static void add(Picture& picture, const RandomLayer& layer)
    {
        const PaintStep step{.rule = layer.rule, .colour = layer.colour, .item = layer.item};
        picture.add_layer(step, 0, {.keys = bit_of(layer)}, [&] {
            for (const std::vector<Corner>& contour : layer.contours) {
                for (const Corner corner : contour)
                    picture.outlines.add(corner);
                picture.outlines.close();
            }
        });
    }

    Size panel_;
    std::mt19937 random_;
    std::vector<RandomLayer> layers_;
    std::int32_t step_ = 0;
    std::uint32_t moved_ = 0; ///< since the picture before
    std::uint32_t items_ = 0;
    std::size_t group_begin_ = 0;
    std::uint8_t group_opacity_ = 128;
};

}
