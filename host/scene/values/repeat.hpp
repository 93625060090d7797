#pragma once

#include "core/time/time.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/own_time.hpp"
#include "host/scene/values/value_reader.hpp"

#include <array>
#include <optional>
#include <vector>

namespace kfast::scene {

/// How many copies of a symbol a use makes, and by what each differs from the one before: the copy with the
/// number n, from 0, by n steps.
struct Repeat {
    static constexpr int max_count = 1000;

    std::optional<int> count; ///< at least 1; without it there are no steps
    double x = 0;             ///< pixels
    double y = 0;
    double rotation = 0; ///< degrees
    double scale = 1;    ///< a factor
    double opacity = 0;
    Time delay = {};
    int colour = 0; ///< colours of the palette

    /// The place, rotation, scale and opacity of a copy, about the pivot of `use`; rounded once. Nothing if
    /// it is beyond what an item may have.
    std::optional<ItemValues> copy(int number, const ItemValues& use) const;
    /// Whether a copy is wholly transparent, or too small to have any extent.
    bool is_transparent(int number) const;
    bool is_nothing(int number) const;
    /// The delay of a copy. Nothing if it is beyond what a time may be.
    std::optional<Time> delay_of(int number, std::optional<Time> first) const;
};

inline constexpr Range copies{1, Repeat::max_count};
inline constexpr Range rotation_steps{-360, 360};
inline constexpr Range scale_steps{0, 64};
inline constexpr Range opacity_steps{-1, 1};
inline constexpr Range colour_steps{-255, 255};

bool read_repeat_count(const kdl::Value& value, Repeat& repeat, SceneContext& context);
bool read_colour_step(const kdl::Value& value, Repeat& repeat, SceneContext& context);

template <class Target>
bool read_count(const kdl::Value& value, Target& target, SceneContext& context)
{
    return read_repeat_count(value, target.repeat, context);
}

template <class Target, double Repeat::*step, const Range& range>
bool read_step(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_number(value, range, context.report), target.repeat.*step);
}

template <class Target>
bool read_colour_step(const kdl::Value& value, Target& target, SceneContext& context)
{
    return read_colour_step(value, target.repeat, context);
}

template <class Target>
bool read_delay_step(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_signed_time(value, context), target.repeat.delay);
}

/// The rules of something that has a Repeat, its `repeat`: what drawings and items take.
template <class Target>
inline constexpr std::array repeat_rules{
    PropertyRule<Target>{"count", read_count<Target>, ValueKind::whole(copies)},
    PropertyRule<Target>{"x-step", read_step<Target, &Repeat::x, coordinates>,
                         ValueKind::pixels(coordinates)},
    PropertyRule<Target>{"y-step", read_step<Target, &Repeat::y, coordinates>,
                         ValueKind::pixels(coordinates)},
    PropertyRule<Target>{"rotate-step", read_step<Target, &Repeat::rotation, rotation_steps>,
                         ValueKind::degrees(rotation_steps)},
    PropertyRule<Target>{"scale-step", read_step<Target, &Repeat::scale, scale_steps>,
                         ValueKind::number(scale_steps)},
};

/// The rest, which only items take.
template <class Target>
inline constexpr std::array item_repeat_rules{
    PropertyRule<Target>{"opacity-step", read_step<Target, &Repeat::opacity, opacity_steps>,
                         ValueKind::number(opacity_steps)},
    PropertyRule<Target>{"colour-step", read_colour_step<Target>, ValueKind::whole(colour_steps)},
    PropertyRule<Target>{"delay-step", read_delay_step<Target>, any_time},
};

/// Reports steps of `node` where there is no count. Returns whether there is nothing to report.
bool has_count_for_steps(const kdl::Node& node, SceneContext& context);

/// Reports a copy that is out of range. Returns false.
bool report_far_copy(const kdl::Node& node, int number, const Repeat& repeat, SceneContext& context);

/// Warns if copies are not seen, and says from which number on.
void warn_of_unseen_copies(const kdl::Node& node, const Repeat& repeat, SceneContext& context);

/// Reports a copy whose delay is out of range. Returns false.
bool report_late_copy(const kdl::Node& node, int number, SceneContext& context);

/// Tracks of one value for all that is not as without a track, and the pivot.
std::vector<Track> fixed_tracks(const ItemValues& values);

}
