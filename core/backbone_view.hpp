#pragma once

#include "core/byte_reader.hpp"
#include "core/time.hpp"

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
    explicit BackboneKeyCursor(ByteReader bytes) : bytes_{bytes} {}

    bool at_end() const { return bytes_.left() == 0; }
    /// Only when not at the end.
    BackboneKey next();
    bool overrun() const { return bytes_.overrun(); }

private:
    ByteReader bytes_;
    Time time_;
};

/// The backbones that carry an object; borrows the scene's bytes.
struct BackbonesView {
    std::uint32_t unit_bits = 0; ///< a segment, and a width, are 2^unit_bits sixteenths of a pixel long
    ByteReader key_bytes;

    BackboneKeyCursor keys() const { return BackboneKeyCursor{key_bytes}; }
};

}
