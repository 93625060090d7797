#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/pack_drawing.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// The section of drawings: each drawing is stored once, however many keys of whichever objects show it, and
/// so is what belongs to drawings, and each form of strokes, wherever they begin and however mirrored.
class DrawingPool {
public:
    /// Where the drawing is in the section.
    std::int32_t offset_of(const scene::Drawing& drawing);
    /// Where the section has `bytes`, of which there is at least one.
    std::int32_t offset_of(std::span<const std::byte> bytes);

    const std::vector<std::byte>& bytes() const { return section_.bytes(); }

private:
    /// A stroke that the section has.
    struct Form {
        std::uint32_t offset;
        std::size_t size;
    };

    void add_form(const Steps& steps);
    std::vector<std::byte> repeat_of(const Steps& steps) const;

    ByteWriter section_;
    std::map<std::string, std::int32_t> drawings_;
    std::map<Steps, Form> forms_;
    std::map<std::string, std::int32_t> others_; ///< by their bytes
};

}
