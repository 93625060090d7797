#include "core/velocity_law.hpp"

#include "core/angle.hpp"

namespace kfast {
namespace {

Share decelerated(Share time) { return {(static_cast<std::uint32_t>(quarter_sine(time)) + (1 << 13)) >> 14}; }

// (1 - cos 2a) / 2 = sin^2 a: squaring keeps the precision near both ends.
Share accelerated_decelerated(Share time)
{
    const auto sine = static_cast<std::uint64_t>(quarter_sine(time));
    return {static_cast<std::uint32_t>((sine * sine + (std::uint64_t{1} << 43)) >> 44)};
}

}

Share progress(VelocityLaw law, Share time)
{
    switch (law) {
    case VelocityLaw::constant:
        return time;
    case VelocityLaw::accelerate:
        return {Share::one - decelerated({Share::one - time.raw}).raw};
    case VelocityLaw::decelerate:
        return decelerated(time);
    case VelocityLaw::accelerate_decelerate:
        return accelerated_decelerated(time);
    }
    return time;
}

}
