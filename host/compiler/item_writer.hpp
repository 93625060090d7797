#pragma once

#include "core/item_view.hpp"
#include "host/compiler/byte_writer.hpp"
#include "host/compiler/drawing_pool.hpp"
#include "host/compiler/enlargement.hpp"
#include "host/compiler/law_table.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace kfast {

/// What an object takes of the things that the format limits.
struct ObjectNeeds {
    std::uint64_t edges = 0;      ///< at any moment, at most
    std::uint64_t key_points = 0; ///< see PackedKeys::points
};

using NeedsOfObjects = std::unordered_map<const scene::Object*, ObjectNeeds>;

/// Appends items as the core's ItemCursor reads them (docs/format.md, "Items").
class ItemWriter {
public:
    /// `laws` and `drawings`, which keys refer to, must outlive the writer, as must `scene`, whose items
    /// these are, and `diagnostics`.
    ItemWriter(const scene::Scene& scene, LawTable& laws, DrawingPool& drawings, Diagnostics& diagnostics)
        : scene_{scene}, laws_{laws}, drawings_{drawings}, diagnostics_{diagnostics}
    {
    }

    /// `around` is that of the groups and uses around `items`.
    void write(const std::vector<scene::Item>& items, const Enlargement& around, ByteWriter& bytes);

    /// Of the objects that have been written, which must stay where they are.
    const NeedsOfObjects& needs() const { return needs_; }

private:
    void write_item(const scene::Item& item, const Enlargement& around, ByteWriter& bytes);
    void write_carrier(const scene::Object& object, std::uint32_t unit_bits, ByteWriter& bytes);
    void write_object(const scene::Object& object, const ObjectStyle& style, double scale, ByteWriter& bytes);

    const scene::Scene& scene_;
    LawTable& laws_;
    DrawingPool& drawings_;
    Diagnostics& diagnostics_;
    NeedsOfObjects needs_;
};

}
