#include "core/scene/stroke_form.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::uint32_t bit(bool is_set, int place) { return is_set ? 1U << place : 0; }

/// By how much `a` is more than `b`.
constexpr std::uint32_t more(std::uint32_t a, std::uint32_t b) { return a > b ? a - b : 0; }

constexpr std::uint8_t bits_within(std::uint32_t bits)
{
    return static_cast<std::uint8_t>(std::clamp<std::uint32_t>(bits, 1, StrokeForm::max_bits));
}

}

StrokeForm StrokeForm::unpacked(std::uint32_t head)
{
    StrokeForm form;
    form.mix = static_cast<SegmentMix>(head & 3);
    form.end = static_cast<StrokeEnd>(std::min<std::uint32_t>(head >> 2 & 3, 2));
    const std::uint32_t bits = head >> 8 & 31;
    form.ends = {bits_within(bits), (head >> 4 & 1) != 0};
    if (form.mix == SegmentMix::lines)
        return form;
    const std::uint32_t fewer = head >> 13;
    form.controls = {bits_within(bits > fewer ? bits - fewer : 0), (head >> 5 & 1) != 0};
    form.smooth = static_cast<std::uint8_t>(head >> 6 & 3);
    return form;
}

std::uint32_t StrokeForm::packed() const
{
    const std::uint32_t head = static_cast<std::uint32_t>(mix) | static_cast<std::uint32_t>(end) << 2 |
                               bit(ends.is_sparse, 4) | std::uint32_t{ends.bits} << 8;
    if (mix == SegmentMix::lines)
        return head;
    return head | bit(controls.is_sparse, 5) | std::uint32_t{smooth} << 6 |
           more(ends.bits, controls.bits) << 13;
}

void StrokeForm::predict(std::uint32_t byte)
{
    predicted = bits_within(byte & 31);
    controls.bits = bits_within(controls.bits + (byte >> 5));
}

std::uint32_t StrokeForm::predicting() const { return predicted | more(controls.bits, ends.bits) << 5; }

}
