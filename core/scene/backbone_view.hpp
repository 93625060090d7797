#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/scene/key_time_cursor.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/packed_values.hpp"
#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// The backbones of an object at one key, and the way from it to the next.
struct BackboneKey {
    Time time;
    std::uint32_t laws = 0;    ///< number of the pair of laws
    std::uint32_t drawing = 0; ///< offset in the section of drawings
};

/// Reads the keys of backbones in the order of their times.
class BackboneKeyCursor {
public:
    /// Takes `bytes` as far as the keys go.
    explicit BackboneKeyCursor(ByteReader& bytes);

    bool at_end() const { return key_times_.at_end(); }
    /// Only when not at the end.
    BackboneKey next();
    /// What has not been read.
    const KeyTimeCursor& key_times() const { return key_times_; }
    const PackedValues& drawings() const { return drawings_; }

private:
    KeyTimeCursor key_times_;
    PackedValues drawings_;
};

/// The backbones that carry an object; borrows the scene's bytes.
struct BackbonesView {
    std::uint32_t unit_bits = 0; ///< a segment, and a width, are 2^unit_bits sixteenths of a pixel long
    ByteReader key_bytes;        ///< begins with the keys

    BackboneKeyCursor keys() const
    {
        ByteReader bytes = key_bytes;
        return BackboneKeyCursor{bytes};
    }
};

/// Nodes and gaps for backbones as `drawing` has them: three strokes each.
std::size_t backbone_node_count(PackedDrawing drawing);

}
