#pragma once

#include "core/math/point.hpp"
#include "core/pose/scene_state.hpp"
#include "core/raster/outline/picture.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "host/picture/picture.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace kfast {

/// What an input of a scene can be given: a number as a place of its range (InputView::place_of), a text, or
/// a drawing.
using InputContent = std::variant<Time, std::string_view, std::span<const InputStroke>>;

/// Gives it to a playing scene, by the member of SceneState for its kind. Returns false where a drawing does
/// not fit; nothing changes then.
bool give_input(SceneState& scene, std::uint32_t number, const InputContent& content);

/// The inputs of a scene that is shown somewhere. Whatever they are given comes by set().
class InputReceiver {
public:
    virtual ~InputReceiver() = default;

    /// As give_input() to the scene that is shown.
    virtual bool set(std::uint32_t number, const InputContent& content) = 0;

    void set_input(std::uint32_t number, Time place) { set(number, place); }
    bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes)
    {
        return set(number, strokes);
    }
    void set_text(std::uint32_t number, std::string_view text) { set(number, text); }
};

/// How much of a picture found room for its outlines, in increasing order.
enum class Detail : std::uint8_t {
    parts_missing,
    coarse, ///< all of it, its curves in fewer pieces
    full,
};

Detail detail_of(const raster::Picture& picture);

/// How many of a scene's pictures on a panel are drawn with less than full detail, with inputs at their
/// defaults.
struct CoarsePictures {
    std::size_t coarse = 0;
    std::size_t looked_at = 0; ///< all frames of one round, or some of them, evenly spread
};

/// Checks no more than `max_pictures` of them.
CoarsePictures coarse_pictures(const SceneView& scene, Size panel, std::size_t max_pictures);

/// The detail of the pictures that a source shows.
class ShownDetail {
public:
    void add(const raster::Picture& picture);

    Detail min() const { return min_; }
    /// The detail of the last picture, in words for FrameSource::facts(); empty if it is full.
    std::string text() const;

private:
    Detail last_ = Detail::full;
    Detail min_ = Detail::full;
};

/// When a picture changes while a scene plays.
enum class Pace {
    smooth,    ///< whenever it is asked
    by_frames, ///< only at the frames of the scene
};

/// Draws a scene on one panel. Which one is chosen at run time, hence virtual.
class FrameSource : public InputReceiver {
public:
    /// The picture at a time of the timeline, including the scene's very end. Valid until the next call.
    virtual const Frame& show(Time moment) = 0;
    /// Does what accompanies the picture at a time, sound for instance, when one that was kept is shown
    /// in place of a new one.
    virtual void accompany(Time /*moment*/) {}
    virtual Pace pace() const { return Pace::smooth; }
    /// Facts about the picture that was shown last, on one line; empty if there are none.
    virtual std::string facts() const { return {}; }
    /// The minimum of all pictures so far.
    virtual Detail min_detail() const { return Detail::full; }
    /// From the next picture on, also shows what is invisible on the display, where there is such a thing.
    virtual void reveal(bool /*hidden*/) {}
};

/// The pictures of another source, in larger pixels and without its pixel format.
class ScaledSource : public FrameSource {
public:
    /// `factor` is at least 1. show() throws Failure where a picture would become too large.
    ScaledSource(std::unique_ptr<FrameSource> source, int factor)
        : source_{std::move(source)}, factor_{factor}
    {
    }

    const Frame& show(Time moment) override;
    bool set(std::uint32_t number, const InputContent& content) override
    {
        return source_->set(number, content);
    }
    Pace pace() const override { return source_->pace(); }
    std::string facts() const override { return source_->facts(); }
    Detail min_detail() const override { return source_->min_detail(); }
    void reveal(bool hidden) override { source_->reveal(hidden); }

private:
    std::unique_ptr<FrameSource> source_;
    int factor_;
    Frame frame_;
};

}
