#pragma once

#include "host/compiler/byte_writer.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// The section of drawings: each drawing is stored once, however many keys of whichever objects show it, and
/// so is what belongs to drawings.
class DrawingPool {
public:
    /// Where the drawing is in the section.
    std::uint32_t offset_of(const scene::Drawing& drawing);
    /// Where the section has `bytes`, of which there is at least one.
    std::uint32_t offset_of(std::span<const std::byte> bytes);

    const std::vector<std::byte>& bytes() const { return section_.bytes(); }

private:
    ByteWriter section_;
    std::map<std::string, std::uint32_t> offsets_; ///< by what is stored there
};

}
