#pragma once

#include "core/scene/kfb_limits.hpp"
#include "core/scene/property.hpp"
#include "core/time/time.hpp"
#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/compiler/pack/value_writer.hpp"
#include "host/compiler/write/header.hpp"
#include "host/compiler/write/inputs_and_marks.hpp"
#include "tests/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Scenes put together by hand, so that anything in them can be wrong; docs/format.md says what the bytes
/// are.
namespace kfast::test {

using Bytes = std::vector<std::byte>;

inline Bytes joined(std::initializer_list<Bytes> parts)
{
    Bytes all;
    for (const Bytes& part : parts)
        for (const std::byte byte : part)
            all.push_back(byte);
    return all;
}

inline Bytes repeated(const Bytes& part, std::size_t count)
{
    Bytes all;
    for (; count > 0; --count)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

inline Bytes varint(std::uint32_t value)
{
    ByteWriter writer;
    writer.varint(value);
    return writer.bytes();
}

inline Bytes signed_varint(std::int32_t value)
{
    ByteWriter writer;
    writer.signed_varint(value);
    return writer.bytes();
}

inline Bytes block(const Bytes& part)
{
    ByteWriter writer;
    writer.block(part);
    return writer.bytes();
}

inline Bytes group(const Bytes& items) { return joined({bytes({1}), block(items)}); }

inline Bytes use(int symbol) { return bytes({2, symbol}); }

/// "Key times"; also none.
inline Bytes key_time_bytes(const KeyTimes& key_times, Driver driver = {})
{
    ByteWriter writer;
    write_key_times({key_times, driver}, {}, writer);
    return writer.bytes();
}

/// "Values"; of none there is room for one.
inline Bytes value_bytes(const std::vector<std::int32_t>& values)
{
    ByteWriter writer;
    write_values(values.empty() ? std::vector<std::int32_t>{0} : values, writer);
    return writer.bytes();
}

/// Of an object, or of backbones.
struct RawKey {
    Time time = {};
    int laws = 0;
    std::uint32_t drawing = 0;
    std::optional<std::int32_t> more = {}; ///< the arrival drawing, or the skin; of all keys or none
};

inline Bytes key_bytes(const std::vector<RawKey>& list)
{
    KeyTimes key_times;
    std::vector<std::int32_t> drawings;
    std::vector<std::int32_t> more;
    for (const RawKey& key : list) {
        key_times.push_back({key.time, static_cast<std::uint32_t>(key.laws)});
        drawings.push_back(static_cast<std::int32_t>(key.drawing));
        if (key.more)
            more.push_back(*key.more);
    }
    return joined(
        {key_time_bytes(key_times), value_bytes(drawings), more.empty() ? Bytes{} : value_bytes(more)});
}

/// The keys of an object that shows one drawing all the time.
inline Bytes one_key(int drawing = 0) { return joined({bytes({0}), signed_varint(drawing)}); }

/// A filled triangle.
inline Bytes triangle() { return joined({bytes({0x08, 1}), one_key()}); }

/// An object whose only drawing is empty.
inline Bytes nothing() { return joined({bytes({0x08, 1}), one_key(10)}); }

/// The triangle with tracks; `count` and the tracks need not fit.
inline Bytes tracked(int count, const Bytes& tracks)
{
    return joined({bytes({0x0C, count}), tracks, bytes({1}), one_key()});
}

inline Bytes fixed_track(Property property, std::int32_t value)
{
    return joined({bytes({0x80 | static_cast<int>(property)}), signed_varint(value)});
}

struct RawTrackKey {
    Time time;
    int laws;
    std::int32_t value;
};

/// Values are stored as differences from `from`.
inline Bytes track_keys(const std::vector<RawTrackKey>& list, std::int32_t from = 0, Driver driver = {})
{
    KeyTimes key_times;
    std::vector<std::int32_t> values;
    for (const RawTrackKey& key : list) {
        key_times.push_back({key.time, static_cast<std::uint32_t>(key.laws)});
        values.push_back(key.value - from);
    }
    return joined({key_time_bytes(key_times, driver), value_bytes(values)});
}

inline Bytes moving_track(Property property, const std::vector<RawTrackKey>& list)
{
    return joined({bytes({static_cast<int>(property)}), track_keys(list)});
}

/// Laws of its keys have no meaning.
inline Bytes smooth_track(Property property, const std::vector<RawTrackKey>& list)
{
    return joined({bytes({0x40 | static_cast<int>(property)}), track_keys(list)});
}

/// Values are in 1/1000.
inline Bytes input_bytes(std::string_view name, std::int32_t min = 0, std::int32_t max = 1000,
                         std::int32_t default_value = 0)
{
    ByteWriter writer;
    DrawingPool none;
    write_inputs({{std::string{name}, min, max, default_value}}, none, writer);
    return writer.bytes();
}

/// Behind the tracks of an item, one of which leads along it.
inline Bytes path_bytes(bool turns, std::uint32_t drawing, const std::vector<std::uint32_t>& lengths)
{
    Bytes path = joined({bytes({turns ? 1 : 0}), varint(drawing)});
    for (const std::uint32_t length : lengths)
        path = joined({path, varint(length)});
    return block(path);
}

/// 16 x 16 px, 10 frames, a black background, white, and red; one triangle.
struct RawScene {
    std::uint32_t outline_bytes = 24'000;
    std::uint32_t borders = 1'500;
    std::uint32_t cache_bytes = 0;
    std::uint32_t law_count = 0;
    std::uint32_t loop = 0;
    std::uint32_t ticks = 10 * 1024;
    std::uint32_t frame_rate = 30'000;
    std::uint32_t width = 16;
    std::uint32_t height = 16;
    std::uint32_t camera = 32;
    Bytes palette = bytes({0, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 128});
    Bytes laws;
    std::uint32_t input_count = 0;
    Bytes inputs;
    Bytes marks;
    Bytes bones; ///< each skeleton a block
    std::uint32_t symbol_count = 0;
    Bytes symbols; ///< each a block
    Bytes items = triangle();
    /// At 0 a triangle within the canvas, at 10 the empty drawing.
    Bytes drawings = bytes({1, 32, 0x80, 1, 0, 6, 4, 0x40, 0x0C, 0x10, 0});

    void add_symbol(const Bytes& inside)
    {
        ++symbol_count;
        symbols = joined({symbols, block(inside)});
    }

    /// Size and checksum fit.
    Bytes file() const
    {
        const auto bit = [](bool is_set, int place) { return is_set ? 1U << place : 0; };
        ByteWriter body;
        body.varint(outline_bytes / 4);
        body.varint(borders);
        body.varint(cache_bytes / 4);
        body.u8(loop | 0x0C | bit(!marks.empty(), 4) | bit(!bones.empty(), 5) | bit(symbol_count != 0, 6) |
                bit(input_count != 0, 7));
        body.varint(ticks <= kfb::max_time ? time_code({static_cast<std::int32_t>(ticks)}) : 0xFFFFFFFF);
        body.varint(2 * frame_rate + 1);
        body.varint(width);
        body.varint(height);
        body.varint(camera);
        body.u8(static_cast<std::uint32_t>(palette.size() / 4));
        body.append(palette);
        body.u8(law_count);
        body.append(laws);
        if (input_count != 0) {
            body.u8(input_count);
            body.block(inputs);
        }
        for (const Bytes* section : {&marks, &bones})
            if (!section->empty())
                body.block(*section);
        if (symbol_count != 0) {
            body.u8(symbol_count);
            body.block(symbols);
        }
        body.block(items);
        body.append(drawings);
        return sealed(body);
    }
};

}
