#include "host/compiler/write_scene.hpp"

#include "core/crc32.hpp"
#include "core/edge_budget.hpp"
#include "core/kfb_limits.hpp"
#include "core/scene_view.hpp"
#include "host/compiler/byte_writer.hpp"
#include "host/compiler/curve_pieces.hpp"
#include "host/compiler/drawing_pool.hpp"

#include <algorithm>
#include <string>

namespace kfast {
namespace {

/// Twice the frames, or twice the ticks and one.
std::uint32_t time_code(Time difference)
{
    const auto ticks = static_cast<std::uint32_t>(difference.ticks);
    return ticks % Time::ticks_per_frame == 0 ? ticks / Time::ticks_per_frame * 2 : ticks * 2 + 1;
}

std::vector<std::byte> packed_keys(const std::vector<scene::Key>& keys, DrawingPool& drawings)
{
    ByteWriter bytes;
    Time before;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const scene::Key& key = keys[i];
        const scene::Key& next = keys[std::min(i + 1, keys.size() - 1)];
        bytes.varint(time_code(key.time - before));
        bytes.u8(static_cast<std::uint32_t>(key.law_x) | static_cast<std::uint32_t>(key.law_y) << 4);
        bytes.varint(
            std::max(curve_pieces(key.drawing, key.drawing), curve_pieces(key.drawing, next.drawing)));
        bytes.varint(drawings.offset_of(key.drawing));
        before = key.time;
    }
    return bytes.bytes();
}

std::uint32_t style_flags(const scene::Object& object)
{
    std::uint32_t flags = object.fill ? 1 : 0;
    if (object.stroke)
        flags |= 2 | static_cast<std::uint32_t>(object.stroke->cap) << 2 |
                 static_cast<std::uint32_t>(object.stroke->join) << 4;
    return flags;
}

void write_object(const scene::Object& object, DrawingPool& drawings, ByteWriter& bytes)
{
    bytes.u8(style_flags(object));
    if (object.fill)
        bytes.u8(static_cast<std::uint32_t>(*object.fill));
    if (object.stroke) {
        bytes.u8(static_cast<std::uint32_t>(object.stroke->colour));
        bytes.varint(static_cast<std::uint32_t>(object.stroke->width));
    }
    const std::vector<std::byte> keys = packed_keys(object.keys, drawings);
    bytes.varint(static_cast<std::uint32_t>(keys.size()));
    bytes.append(keys);
}

std::size_t points_of(const scene::Object& object)
{
    std::size_t points = 0;
    for (const scene::Key& key : object.keys)
        for (const scene::Stroke& stroke : key.drawing.strokes)
            points += stroke.segments.size() + 1;
    return points + object.keys.size();
}

/// What a scene may hold of, and how the objects share it.
struct Allowance {
    std::string_view what;
    std::uint64_t limit;
    std::vector<std::uint64_t> used; ///< by each object

    std::uint64_t total() const
    {
        std::uint64_t sum = 0;
        for (const std::uint64_t part : used)
            sum += part;
        return sum;
    }
};

void check(const Allowance& allowance, const scene::Scene& scene, Diagnostics& diagnostics)
{
    if (allowance.total() <= allowance.limit)
        return;
    const auto largest = std::ranges::max_element(allowance.used);
    const scene::Object& object = scene.objects[static_cast<std::size_t>(largest - allowance.used.begin())];
    diagnostics.error(object.place,
                      "the scene needs " + std::to_string(allowance.total()) + " " +
                          std::string{allowance.what} + ", the format holds " +
                          std::to_string(allowance.limit) + "; object \"" + object.name + "\" alone needs " +
                          std::to_string(*largest),
                      "draw it with fewer points, or with fewer or smaller curves");
}

void write_header(const scene::Scene& scene, std::uint32_t edges, ByteWriter& bytes)
{
    bytes.u32(edges);
    bytes.u32(static_cast<std::uint32_t>(scene.length.ticks));
    bytes.u32(scene.frame_rate);
    bytes.u16(static_cast<std::uint32_t>(scene.canvas.width));
    bytes.u16(static_cast<std::uint32_t>(scene.canvas.height));
    bytes.u16(static_cast<std::uint32_t>(scene.objects.size()));
    bytes.u8(static_cast<std::uint32_t>(scene.palette.size()));
    bytes.u8(static_cast<std::uint32_t>(scene.loop));
    for (const Colour colour : scene.palette) {
        bytes.u8(colour.red);
        bytes.u8(colour.green);
        bytes.u8(colour.blue);
    }
}

/// Puts magic, checksum and size before everything else.
std::vector<std::byte> sealed(const ByteWriter& body)
{
    ByteWriter checked;
    checked.u32(static_cast<std::uint32_t>(body.size() + 12));
    checked.append(body.bytes());
    Crc32 crc;
    crc.add(checked.bytes());
    ByteWriter file;
    for (const char letter : {'K', 'F', 'B'})
        file.u8(static_cast<std::uint8_t>(letter));
    file.u8(kfb::version);
    file.u32(crc.value());
    file.append(checked.bytes());
    return file.bytes();
}

}

std::optional<std::vector<std::byte>> write_scene(const scene::Scene& scene, Diagnostics& diagnostics)
{
    DrawingPool drawings;
    ByteWriter objects;
    for (const scene::Object& object : scene.objects)
        write_object(object, drawings, objects);

    Allowance edges{"edges", kfb::max_edges, {}};
    Allowance points{"points in all keys together", kfb::max_key_points, {}};
    ObjectCursor cursor{ByteReader{objects.bytes()}, static_cast<std::uint32_t>(scene.objects.size())};
    for (const scene::Object& object : scene.objects) {
        edges.used.push_back(object_edges(cursor.next(), drawings.bytes()));
        points.used.push_back(points_of(object));
    }
    check(edges, scene, diagnostics);
    check(points, scene, diagnostics);
    if (diagnostics.has_errors())
        return std::nullopt;

    ByteWriter body;
    write_header(scene, static_cast<std::uint32_t>(edges.total()), body);
    body.varint(static_cast<std::uint32_t>(objects.size()));
    body.append(objects.bytes());
    body.append(drawings.bytes());
    return sealed(body);
}

}
