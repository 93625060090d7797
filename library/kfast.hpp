#pragma once

#include "core/player.hpp"
#include "core/scene/scene_view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace kfast {

/// A compiled scene on a display that something else drives: a framework, a driver of your own.
///
/// It is in memory that you lend, and hands out rectangles of finished pixels. There is no heap, no clock
/// and no thread behind it. It must not be moved once it has drawn.
class Animation {
public:
    /// Bytes that create() must be lent, for every time of the scene. `scene` holds what `kfast compile` or
    /// `kfast export` wrote; the sides of the panel are 1 … Player::max_panel.
    /// Fails as SceneView::parse does.
    static Result<std::size_t> block_bytes(std::span<const std::byte> scene, Size panel,
                                           const Features& features = every_feature)
    {
        const Result<SceneView> view = SceneView::parse(scene, features);
        if (!view)
            return view.error();
        return Player::block_bytes(*view, panel);
    }

    /// `scene` and `block` (aligned to 4 bytes) must outlive the animation. It shows the beginning.
    /// Fails as block_bytes() does, or with block_too_small.
    static Result<Animation> create(std::span<const std::byte> scene, Size panel, std::span<std::byte> block,
                                    Fit fit = Fit::contain, const Features& features = every_feature)
    {
        const Result<SceneView> view = SceneView::parse(scene, features);
        if (!view)
            return view.error();
        if (block.size() < Player::block_bytes(*view, panel))
            return Error::block_too_small;
        return Animation{*view, panel, fit, block};
    }

    /// Constructs it in place, for a small stack: what create() returns is copied. `scene` was parsed, and
    /// `block` has Player::block_bytes() for it or more.
    Animation(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block)
        : player_{scene, panel, fit, block.first(Player::block_bytes(scene, panel))},
          range_{play_range_of(scene)}
    {
    }

    /// Sets what show() counts from: a clip, or the whole scene again. A clip that the scene has not changes
    /// nothing, and the result is false.
    bool choose_clip(std::string_view name)
    {
        const auto clip = scene().clip(name);
        if (clip)
            range_ = play_range_of(*clip);
        return clip.has_value();
    }
    void choose_scene() { range_ = play_range_of(scene()); }

    /// Sets an input of the scene, from the next show() on: to `value` in 1/1000 of what the scene counts it
    /// in, clamped to the input's range. At first inputs have their default values. A number that
    /// the scene has not among its inputs changes nothing, and the result is false.
    bool set_input(std::string_view name, std::int32_t value)
    {
        return with_input(name, InputType::number, [&](std::uint32_t number, const InputView& input) {
            player_.set_input(number, input.place_of(value));
        });
    }

    /// Sets a text that is an input of the scene, in UTF-8, from the next show() on. Characters that the
    /// scene has no letters for are left out, and so are those beyond the maximum of the input.
    /// Otherwise as set_input().
    bool set_text(std::string_view name, std::string_view text)
    {
        return with_input(name, InputType::text,
                          [&](std::uint32_t number, const InputView&) { player_.set_text(number, text); });
    }

    /// Sets a drawing among the inputs of the scene, from the next show() on: to `strokes`, their points in
    /// 1/16 px of the objects that show it. If there is no such drawing, or if it takes fewer strokes or
    /// points, nothing changes, and the result is false.
    bool set_drawing(std::string_view name, std::span<const InputStroke> strokes)
    {
        const auto number = input(name, InputType::drawing);
        return number && player_.set_drawing(*number, strokes);
    }
    /// For setting a drawing point by point; it is shown by show_next_drawing(name) only. None if
    /// the scene has no such drawing.
    std::optional<InputDrawing> drawing(std::string_view name) const
    {
        const auto number = input(name, InputType::drawing);
        return number ? std::optional{player_.drawing(*number)} : std::nullopt;
    }
    /// Shows it from the next show() on. A drawing that the scene has not changes nothing.
    void show_next_drawing(std::string_view name)
    {
        if (const auto number = input(name, InputType::drawing))
            player_.show_next_drawing(*number);
    }

    /// Computes the picture at `time`, counted from the beginning of what was chosen; any time is allowed,
    /// its loop decides what it represents.
    void show(Time time) { show_moment(range_.begin + wrap(time, range_.length(), range_.loop)); }

    /// Computes the picture at a time of the whole timeline, whatever was chosen: 0 … the length of the
    /// scene.
    void show_moment(Time moment) { player_.show_moment(moment); }

    /// As show(), after that many milliseconds; rounded down to 1/1024 frame.
    void show_after(std::uint32_t milliseconds)
    {
        const std::uint64_t ticks =
            std::uint64_t{milliseconds} * scene().frame_rate() * Time::ticks_per_frame / 1'000'000;
        const auto turn = static_cast<std::uint32_t>(2 * range_.length().ticks); // there and back
        show({static_cast<std::int32_t>(range_.loop == Loop::once ? std::min<std::uint64_t>(ticks, turn)
                                                                  : ticks % turn)});
    }

    /// Hands out the areas in which the picture differs from what was drawn before, in any format; at
    /// first, and after redraw(), that is the whole panel. Calls
    /// draw_rectangle(Rect area, std::span<const std::byte> pixels) for each area: its rows from the top
    /// down, row_bytes(format, area.width) each. An area begins and ends in columns that are multiples of
    /// pixels_in_whole_bytes(format), or ends with the panel: the rest of the last byte of a row then
    /// means nothing.
    ///
    /// `buffer` is where the pixels are drawn; the larger, the fewer the calls. Returns false, and draws
    /// nothing, if it does not hold a row of the panel; for a format of 16 bits, from an even address on.
    template <PixelFormat format, class DrawRectangle>
    bool draw(std::span<std::byte> buffer, DrawRectangle&& draw_rectangle)
    {
        if constexpr (bits_per_pixel(format) == 16)
            buffer = buffer.subspan(std::min(buffer.size(), beyond_halfword(buffer.data())));
        if (buffer.size() < row_bytes(format, panel().width))
            return false;
        constexpr Size granularity{pixels_in_whole_bytes(format), 1};
        while (true) {
            const auto changes = player_.template draw_changes<format>(buffer, granularity, area_bytes);
            if (changes.empty())
                return true;
            for (const auto& [area, pixels] : changes)
                draw_rectangle(area, pixels);
        }
    }

    /// Whether, for want of room in the block, the picture's curves are coarser, or parts of it are missing.
    bool is_coarse() const { return player_.is_coarse(); }

    /// The display shows something else now: the next draw() hands out the whole panel.
    void redraw() { player_.redraw(); }

    const SceneView& scene() const { return player_.scene(); }
    Size panel() const { return player_.panel(); }

private:
    /// Calls visit(number, input) for the first input of that name, if of this type; returns whether it is.
    template <class Visit>
    bool with_input(std::string_view name, InputType type, Visit visit) const
    {
        InputCursor inputs = scene().inputs();
        for (std::uint32_t number = 0; !inputs.at_end(); ++number) {
            const InputView input = inputs.next();
            if (input.name != name)
                continue;
            if (input.type == type)
                visit(number, input);
            return input.type == type;
        }
        return false;
    }

    /// What an area costs besides its pixels: most displays get its columns and rows in 11 bytes.
    static constexpr int area_bytes = 11;

    static std::size_t beyond_halfword(const std::byte* at)
    {
        return reinterpret_cast<std::uintptr_t>(at) % 2;
    }

    std::optional<std::uint32_t> input(std::string_view name, InputType type) const
    {
        const auto number = scene().input(name);
        return number && scene().input(*number).type == type ? number : std::nullopt;
    }

    Player player_;
    PlayRange range_;
};

}
