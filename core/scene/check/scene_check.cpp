#include "core/scene/check/scene_check.hpp"

#include "core/features.hpp"
#include "core/scene/kfb_limits.hpp"

/// A scene as a whole.
namespace kfast {

namespace {

/// Whether its numbers are what the format allows.
bool is_valid(const Clock& clock)
{
    const bool is_endless = clock.length == Time{};
    return clock.loop <= Loop::ping_pong && clock.delay.ticks >= -kfb::max_time &&
           clock.delay.ticks <= kfb::max_time && clock.speed >= -Clock::max_speed &&
           clock.speed <= Clock::max_speed && clock.length.ticks <= kfb::max_time &&
           (!is_endless || (clock.loop == Loop::once && clock.speed > 0));
}

}

bool SceneCheck::passes()
{
    return check_header() && check_laws() && check_inputs() && check_clocks() && check_clips() &&
           check_events() && check_bones() && check_symbols() && check_whole();
}

/// Whether the program has the feature.
bool SceneCheck::needs(Feature feature)
{
    scene_.needed_features_.add(feature);
    if (scene_.features().has(feature))
        return true;
    error_ = error_without(feature);
    return false;
}

/// If not, the current item has too much.
bool SceneCheck::may_read(std::uint32_t keys_or_points)
{
    if (allowance_.take(keys_or_points))
        return true;
    item_ = items_read_ - 1; // 0xFFFFFFFF before the first one
    return false;
}

bool SceneCheck::check_header() const
{
    const auto is_side = [](int pixels) { return pixels >= 1 && pixels <= kfb::max_canvas; };
    return is_side(scene_.canvas_.width) && is_side(scene_.canvas_.height) &&
           scene_.camera_ >= kfb::min_camera && scene_.camera_ <= kfb::max_camera &&
           scene_.frame_rate_ >= 1 && scene_.frame_rate_ <= kfb::max_frame_rate &&
           scene_.length_.ticks >= Time::ticks_per_frame && scene_.length_.ticks <= kfb::max_time &&
           scene_.loop_ <= Loop::ping_pong && !scene_.palette_.empty() && scene_.colour(0).opacity == 255 &&
           scene_.outline_bytes_ <= kfb::max_outline_bytes && scene_.borders_ <= kfb::max_borders &&
           scene_.cache_bytes_ <= kfb::max_cache_bytes;
}

bool SceneCheck::check_laws()
{
    for (std::uint32_t number = 1; number <= scene_.law_count_; ++number) {
        const LawPair laws = scene_.laws(number);
        for (const VelocityLaw* const law : {&laws.x, &laws.y})
            if (!is_valid(*law) || (is_spring(*law) && !needs(Feature::springs)))
                return false;
        if (laws.x == VelocityLaw::hold)
            holds_[number / 32] |= 1U << number % 32;
    }
    return true;
}

bool SceneCheck::check_clocks() const
{
    std::uint32_t index = 0;
    for (ClockCursor clocks = scene_.clocks(); !clocks.at_end(); ++index) {
        const Clock clock = clocks.next();
        const Driver driver = clock.driver;
        if (clocks.rest().overrun() || !(driver.is_time() || (driver.is_clock() && driver.index() < index)) ||
            !is_valid(clock))
            return false;
    }
    return index <= kfb::max_clocks;
}

bool SceneCheck::check_clips() const
{
    for (ClipCursor clips = scene_.clips(); !clips.at_end();) {
        const ClipView clip = clips.next();
        if (clip.name.empty() || clip.begin > scene_.length_ || clip.end <= clip.begin ||
            clip.end > scene_.length_ || clip.loop > Loop::ping_pong)
            return false;
        if (clips.rest().overrun())
            return false;
    }
    return true;
}

bool SceneCheck::check_events() const
{
    for (EventCursor events = scene_.events(); !events.at_end();) {
        const EventView event = events.next();
        if (event.name.empty() || event.time > scene_.length_ || events.overrun())
            return false;
    }
    return true;
}

bool SceneCheck::check_bones()
{
    if (scene_.skeletons().at_end())
        return true;
    if (!needs(Feature::bones) || !scene_.features().bones->check(scene_, scene_.law_count_, allowance_))
        return false;
    std::uint32_t bones = 0;
    for (SkeletonCursor cursor = scene_.skeletons(); !cursor.at_end();)
        bones += cursor.skip();
    return bones <= kfb::max_bones_together;
}

bool SceneCheck::check_symbols()
{
    ByteReader symbols = scene_.symbols_;
    for (std::uint32_t number = 0; number < scene_.symbol_count_; ++number) {
        const ItemCursor items{symbols.take(symbols.varint())};
        cost_ = {};
        shown_ = 0;
        ItemTotals& totals = symbols_[number];
        if (symbols.overrun() || !check_items(items, number, 1, totals))
            return false;
        totals.cost = static_cast<std::uint16_t>(cost_.largest());
        totals.shown = shown_;
    }
    return symbols.left() == 0;
}

/// Checks what is visible, with all symbols in it.
bool SceneCheck::check_whole()
{
    cost_ = {};
    max_ = 0;
    ItemTotals totals;
    if (!check_items(scene_.items(), scene_.symbol_count_, 0, totals) || totals.is_too_much)
        return false;
    scene_.paint_steps_ = totals.paint_steps;
    scene_.blended_depth_ = totals.blended;
    scene_.records_.spaces = totals.spaces;
    scene_.records_.levels = totals.depth + 2U; // the scene and a leaf
    scene_.cost_ = static_cast<std::uint16_t>(cost_.largest());
    if (scene_.cost_ == PictureCost::max)
        error_ = Error::too_slow;
    return error_ != Error::too_slow;
}

}
