#include "host/compiler/pack/drawing_pool.hpp"

#include "core/scene/format.hpp"
#include "core/scene/packed_drawing.hpp"
#include "host/compiler/pack/pack_drawing.hpp"

namespace kfast {
namespace {

std::string text_of(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A key that differs for each drawing; quicker than packing it.
std::string key_of(const scene::Drawing& drawing)
{
    ByteWriter key;
    pack_drawing(drawing, key, [](const Steps& steps, ByteWriter& bytes) {
        bytes.varint(static_cast<std::uint32_t>(steps.size()));
        for (const Step& step : steps) {
            bytes.u8(step.cubic ? 1 : 0);
            for (const Delta delta : {step.end, step.c1, step.back}) {
                bytes.signed_varint(delta.x);
                bytes.signed_varint(delta.y);
            }
        }
    });
    return text_of(key.bytes());
}

}

std::int32_t DrawingPool::offset_of(const scene::Drawing& drawing)
{
    const auto offset = static_cast<std::int32_t>(section_.size());
    const auto [entry, is_new] = drawings_.emplace(key_of(drawing), offset);
    if (is_new)
        pack_drawing(drawing, section_, [this](const Steps& steps, ByteWriter&) { add_form(steps); });
    return entry->second;
}

std::int32_t DrawingPool::offset_of(std::span<const std::byte> bytes)
{
    const auto offset = static_cast<std::int32_t>(section_.size());
    const auto [entry, is_new] = others_.emplace(text_of(bytes), offset);
    if (is_new)
        section_.append(bytes);
    return entry->second;
}

void DrawingPool::add_form(const Steps& steps)
{
    const std::vector<std::byte> repeat = repeat_of(steps);
    const auto known = forms_.find(steps);
    if (known != forms_.end() && repeat.size() < known->second.size)
        return section_.append(repeat); // without packing it once more
    const std::vector<std::byte> form = packed_form(steps);
    if (!repeat.empty() && repeat.size() < form.size())
        return section_.append(repeat);
    forms_.emplace(steps, Form{static_cast<std::uint32_t>(section_.size()), form.size()});
    section_.append(form);
}

/// What refers to the form of such a stroke, or of a mirrored one; nothing if there is none.
std::vector<std::byte> DrawingPool::repeat_of(const Steps& steps) const
{
    for (const bool y : {false, true})
        for (const bool x : {false, true}) {
            const auto form = forms_.find(mirrored(steps, x, y));
            if (form == forms_.end())
                continue;
            ByteWriter bytes;
            bytes.u8(kfb::repeated_form::mix.put(SegmentMix::repeat) | kfb::repeated_form::mirrors_x.put(x) |
                     kfb::repeated_form::mirrors_y.put(y));
            bytes.varint(form->second.offset);
            return bytes.bytes();
        }
    return {};
}

}
