#pragma once

#include "core/property.hpp"
#include "core/time.hpp"
#include "host/compiler/byte_writer.hpp"
#include "host/compiler/header.hpp"
#include "host/compiler/time_code.hpp"
#include "tests/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
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

/// The keys of an object that shows one drawing all the time.
inline Bytes one_key(int drawing = 0) { return block(bytes({0, 0, drawing})); }

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

enum class Smoothness : bool { by_laws, smooth };

inline Bytes track_keys(const std::vector<RawTrackKey>& list, Smoothness smoothness = Smoothness::by_laws)
{
    Bytes keys;
    Time before;
    for (const RawTrackKey& key : list) {
        keys = joined({keys, varint(time_code(key.time - before)),
                       smoothness == Smoothness::smooth ? Bytes{} : bytes({key.laws}),
                       signed_varint(key.value)});
        before = key.time;
    }
    return keys;
}

inline Bytes moving_track(Property property, const std::vector<RawTrackKey>& list)
{
    return joined({bytes({static_cast<int>(property)}), block(track_keys(list))});
}

inline Bytes smooth_track(Property property, const std::vector<RawTrackKey>& list)
{
    return joined({bytes({0x40 | static_cast<int>(property)}), block(track_keys(list, Smoothness::smooth))});
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
    std::uint32_t law_count = 0;
    std::uint32_t loop = 0;
    std::uint32_t ticks = 10 * 1024;
    std::uint32_t frame_rate = 30'000;
    std::uint32_t width = 16;
    std::uint32_t height = 16;
    std::uint32_t camera = 32;
    Bytes palette = bytes({0, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 128});
    Bytes laws;
    Bytes marks;
    Bytes bones; ///< each skeleton a block
    std::uint32_t symbol_count = 0;
    Bytes symbols; ///< each a block
    Bytes items = triangle();
    /// At 0 a triangle within the canvas, at 10 the empty drawing.
    Bytes drawings = bytes({1, 6, 2, 16, 0, 32, 0, 0x10, 0x00, 0x03, 0});

    void add_symbol(const Bytes& inside)
    {
        ++symbol_count;
        symbols = joined({symbols, block(inside)});
    }

    /// Size and checksum fit.
    Bytes file() const
    {
        ByteWriter body;
        body.u32(outline_bytes);
        body.u8(law_count);
        body.u8(loop);
        body.u32(ticks);
        body.u32(frame_rate);
        body.u16(width);
        body.u16(height);
        body.u8(static_cast<std::uint32_t>(palette.size() / 4));
        body.u8(symbol_count);
        body.u16(camera);
        body.append(palette);
        body.append(laws);
        for (const Bytes* section : {&marks, &bones, &symbols, &items})
            body.block(*section);
        body.append(drawings);
        return sealed(body);
    }
};

}
