#include "host/compiler/pack/pack_drawing.hpp"

#include "core/scene/format.hpp"
#include "core/scene/packed_drawing.hpp"
#include "host/compiler/pack/value_writer.hpp"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <optional>
#include <span>

namespace kfast {

namespace {

Delta delta(scene::Point from, scene::Point to) { return {to.x - from.x, to.y - from.y}; }

Delta mirrored(Delta delta, bool x, bool y) { return {x ? -delta.x : delta.x, y ? -delta.y : delta.y}; }

}

Steps steps_of(const scene::Stroke& stroke)
{
    Steps steps;
    scene::Point at = stroke.from;
    for (const scene::Segment& segment : stroke.segments) {
        Step step{.cubic = segment.cubic, .end = delta(at, segment.to)};
        if (segment.cubic) {
            step.c1 = delta(at, segment.c1);
            step.back = delta(segment.to, segment.c2);
        }
        steps.push_back(step);
        at = segment.to;
    }
    return steps;
}

Steps mirrored(const Steps& steps, bool x, bool y)
{
    Steps other = steps;
    for (Step& step : other)
        for (Delta Step::*part : {&Step::end, &Step::c1, &Step::back})
            step.*part = mirrored(step.*part, x, y);
    return other;
}

namespace {

/// The bits that a signed number needs, at least 1.
std::uint32_t signed_bits(std::int32_t value)
{
    const auto size = static_cast<std::uint32_t>(value < 0 ? ~value : value);
    return static_cast<std::uint32_t>(std::bit_width(size)) + 1;
}

std::uint32_t bits_of(Delta delta) { return std::max(signed_bits(delta.x), signed_bits(delta.y)); }

SegmentMix mix_of(const Steps& steps)
{
    const auto cubics = std::ranges::count_if(steps, &Step::cubic);
    if (cubics == 0)
        return SegmentMix::lines;
    return cubics == std::ssize(steps) ? SegmentMix::cubics : SegmentMix::both;
}

bool is_closed(const Steps& steps)
{
    Delta end;
    for (const Step& step : steps)
        end = end + step.end;
    return end == Delta{};
}

/// Whether the second half of the steps is the first, rotated by half a turn.
bool is_turned(const Steps& steps)
{
    const auto half = steps.begin() + std::ssize(steps) / 2;
    return steps.size() % 2 == 0 &&
           Steps{half, steps.end()} == mirrored(Steps{steps.begin(), half}, true, true);
}

Delta predicted_end(Delta out, Delta in)
{
    return {kfast::predicted_end(out.x, in.x), kfast::predicted_end(out.y, in.y)};
}

/// Whether a first control point that is `off` from continuing the segment before counts as smooth.
bool is_smooth(Delta off, const StrokeForm& form)
{
    return form.smooth == 1 ? off == Delta{} : bits_of(off) <= form.smooth;
}

/// Hands the parts of the steps that the form stores to `sink`, in their order.
template <class Sink>
void store(const Steps& steps, const StrokeForm& form, Sink& sink)
{
    const std::size_t count = form.end == StrokeEnd::turned ? steps.size() / 2 : steps.size();
    Delta onwards;
    for (const Step& step : std::span{steps}.first(count)) {
        const bool is_predicted = step.cubic && form.predicted != 0;
        const bool has_end = form.end != StrokeEnd::closed || &step != &steps.back();
        sink.kind(step.cubic);
        if (has_end && !is_predicted)
            sink.end(step.end);
        if (step.cubic) {
            const Delta off = step.c1 - onwards;
            is_smooth(off, form) ? sink.smooth(off) : sink.first_control(step.c1);
            sink.second_control(is_predicted ? -step.back - step.c1 : step.back);
        }
        if (has_end && is_predicted)
            sink.end(step.end - predicted_end(step.c1, -step.back));
        onwards = -step.back;
    }
}

/// Finds the widths that a form needs.
class WidthFinder {
public:
    void kind(bool) {}
    void end(Delta end) { ends_ = std::max(ends_, bits_of(end)); }
    void smooth(Delta) {}
    void first_control(Delta control) { firsts_ = std::max(firsts_, bits_of(control)); }
    void second_control(Delta control) { seconds_ = std::max(seconds_, bits_of(control)); }

    void fit(StrokeForm& form) const
    {
        const bool is_predicted = form.predicted != 0;
        const std::uint32_t controls = is_predicted ? seconds_ : std::max(firsts_, seconds_);
        const std::uint32_t ends = std::max(ends_, is_predicted ? at_least(controls) : controls);
        form.ends.bits = static_cast<std::uint8_t>(ends);
        if (form.mix != SegmentMix::lines)
            form.controls.bits = static_cast<std::uint8_t>(std::max(controls, at_least(ends)));
        if (is_predicted)
            form.predicted = static_cast<std::uint8_t>(firsts_);
    }

private:
    /// The smallest width that may go with one of `bits`.
    static std::uint32_t at_least(std::uint32_t bits)
    {
        return bits - std::min(bits, StrokeForm::max_fewer_bits);
    }

    std::uint32_t ends_ = 1;
    std::uint32_t firsts_ = 1;
    std::uint32_t seconds_ = 1;
};

/// Used instead of a BitWriter where only the size of a form is needed.
class BitCounter {
public:
    void put(std::int32_t, std::uint32_t count) { bits_ += count; }
    std::size_t bytes() const { return (bits_ + 7) / 8; }

private:
    std::size_t bits_ = 0;
};

/// Writes the bits of a form.
template <class Bits>
class FormPacker {
public:
    FormPacker(const StrokeForm& form, Bits& bits) : form_{form}, bits_{bits} {}

    void kind(bool cubic)
    {
        if (form_.mix == SegmentMix::both)
            bits_.put(cubic ? 1 : 0, 1);
    }
    void end(Delta end) { put(end, form_.ends); }
    void smooth(Delta off)
    {
        bits_.put(1, 1);
        if (form_.smooth != 1)
            put(off, {form_.smooth, false});
    }
    void first_control(Delta control)
    {
        if (form_.smooth != 0)
            bits_.put(0, 1);
        put(control, form_.first_controls());
    }
    void second_control(Delta control) { put(control, form_.controls); }

private:
    void put(Delta delta, const VectorForm& form)
    {
        if (form.is_sparse)
            bits_.put(static_cast<std::int32_t>(kfb::sparse_vector::has_x.put(delta.x != 0) |
                                                kfb::sparse_vector::has_y.put(delta.y != 0)),
                      kfb::sparse_vector::bits);
        for (const std::int32_t coordinate : {delta.x, delta.y})
            if (!form.is_sparse || coordinate != 0)
                bits_.put(coordinate, form.bits);
    }

    const StrokeForm& form_;
    Bits& bits_;
};

void write_head(const Steps& steps, const StrokeForm& form, ByteWriter& bytes)
{
    bytes.u16(form.packed());
    bytes.varint(kfb::segments::count.put(steps.size()) |
                 kfb::segments::are_predicted.put(form.predicted != 0));
    if (form.predicted != 0)
        bytes.u8(form.predicting());
}

/// The size of what packed() makes, without the head: that of forms without prediction is a byte shorter.
std::size_t packed_size(const Steps& steps, const StrokeForm& form)
{
    BitCounter bits;
    FormPacker packer{form, bits};
    store(steps, form, packer);
    return bits.bytes() + (form.predicted != 0 ? 1 : 0);
}

std::vector<std::byte> packed(const Steps& steps, const StrokeForm& form)
{
    ByteWriter bytes;
    write_head(steps, form, bytes);
    {
        BitWriter bits{bytes};
        FormPacker packer{form, bits};
        store(steps, form, packer);
    }
    return bytes.bytes();
}

/// Adds what each of `forms` becomes by `change`.
template <class Change>
void add_changed(std::vector<StrokeForm>& forms, Change change)
{
    const std::vector<StrokeForm> before = forms;
    for (StrokeForm form : before) {
        change(form);
        forms.push_back(form);
    }
}

/// All forms that may be the best for the steps, without their widths.
std::vector<StrokeForm> forms_for(const Steps& steps)
{
    StrokeForm plain;
    plain.mix = mix_of(steps);
    plain.end = is_closed(steps) ? StrokeEnd::closed : StrokeEnd::open;
    std::vector<StrokeForm> forms{plain};
    if (is_turned(steps))
        add_changed(forms, [](StrokeForm& form) { form.end = StrokeEnd::turned; });
    add_changed(forms, [](StrokeForm& form) { form.ends.is_sparse = true; });
    if (plain.mix == SegmentMix::lines)
        return forms;
    add_changed(forms, [](StrokeForm& form) { form.controls.is_sparse = true; });
    const std::vector<StrokeForm> sharp = forms;
    for (const std::uint8_t smooth : std::initializer_list<std::uint8_t>{1, 2, 3})
        for (StrokeForm form : sharp) {
            form.smooth = smooth;
            forms.push_back(form);
        }
    add_changed(forms, [](StrokeForm& form) { form.predicted = 1; });
    return forms;
}

}

std::vector<std::byte> packed_form(const Steps& steps)
{
    if (steps.empty())
        return packed(steps, StrokeForm{});
    std::optional<StrokeForm> best;
    std::size_t best_size = 0;
    for (StrokeForm form : forms_for(steps)) {
        WidthFinder widths;
        store(steps, form, widths);
        widths.fit(form);
        if (std::max(form.ends.bits, form.controls.bits) > StrokeForm::max_bits)
            continue;
        const std::size_t size = packed_size(steps, form);
        if (!best || size < best_size) {
            best = form;
            best_size = size;
        }
    }
    return best ? packed(steps, *best) : std::vector<std::byte>{};
}

void pack_drawing(const scene::Drawing& drawing, ByteWriter& bytes)
{
    pack_drawing(drawing, bytes,
                 [](const Steps& steps, ByteWriter& form) { form.append(packed_form(steps)); });
}

}
