#include "host/compiler/key_writer.hpp"

#include "core/kfb_limits.hpp"
#include "host/compiler/curve_pieces.hpp"
#include "host/compiler/match_by_length.hpp"
#include "host/compiler/time_code.hpp"

#include <algorithm>
#include <string>

namespace kfast {
namespace {

/// The drawings at both ends of the way from `key` to `next`.
MatchedDrawings ends_of_way(const scene::Key& key, const scene::Key& next, Diagnostics& diagnostics)
{
    const MatchedDrawings as_drawn{key.drawing, next.drawing};
    if (key.match == scene::Match::count)
        return as_drawn;
    if (const auto matched = match_by_length(key.drawing, next.drawing))
        return *matched;
    diagnostics.error(key.place,
                      "to match the next key by length takes more than " +
                          std::to_string(kfb::max_drawing_points) + " points, as many as a drawing holds",
                      "draw both with fewer points, or use match=count");
    return as_drawn;
}

/// Exactly on its time a key is shown undivided, with curves longer than any on the way.
std::uint32_t pieces_of_way(const MatchedDrawings& ends, const LawPair& laws, double scale)
{
    return std::max(curve_pieces(ends.from, ends.from, {}, {}, scale),
                    curve_pieces(ends.from, ends.to, way_range(laws.x), way_range(laws.y), scale));
}

}

bool has_arrivals(const scene::Object& object)
{
    return std::any_of(object.keys.begin(), object.keys.end() - 1,
                       [](const scene::Key& key) { return key.match == scene::Match::length; });
}

PackedKeys packed_keys(const scene::Object& object, double scale, LawTable& laws, DrawingPool& drawings,
                       Diagnostics& diagnostics)
{
    ByteWriter bytes;
    std::uint64_t points = 0;
    const bool with_arrivals = has_arrivals(object);
    Time before;
    for (std::size_t i = 0; i < object.keys.size(); ++i) {
        const scene::Key& key = object.keys[i];
        const bool leads_on = i + 1 < object.keys.size();
        const MatchedDrawings ends = leads_on ? ends_of_way(key, object.keys[i + 1], diagnostics)
                                              : MatchedDrawings{key.drawing, key.drawing};
        const LawPair way = leads_on ? key.laws : LawPair{};
        bytes.varint(time_code(key.time - before));
        bytes.u8(laws.number_of(way, key.place));
        bytes.varint(pieces_of_way(ends, way, scale));
        bytes.varint(drawings.offset_of(ends.from));
        points += point_count(ends.from) + 1;
        if (with_arrivals) {
            bytes.varint(drawings.offset_of(ends.to));
            points += point_count(ends.to) + 1;
        }
        before = key.time;
    }
    return {bytes.bytes(), points};
}

}
