#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstdint>
#include <vector>

namespace kfast {

/// Appends items as the core's ItemCursor reads them (docs/format.md, "Items").
class ItemWriter {
public:
    /// `laws` and `drawings`, which keys refer to, must outlive the writer, as must `diagnostics`.
    ItemWriter(LawTable& laws, DrawingPool& drawings, Diagnostics& diagnostics)
        : laws_{laws}, drawings_{drawings}, diagnostics_{diagnostics}
    {
    }

    void write(const std::vector<scene::Item>& items, ByteWriter& bytes);

private:
    void write_item(const scene::Item& item, ByteWriter& bytes);
    void write_deformer(const scene::Object& object, std::uint32_t unit_bits, ByteWriter& bytes);
    void write_live(const scene::Object& object, ByteWriter& bytes);
    void write_object(const scene::Object& object, ByteWriter& bytes);

    LawTable& laws_;
    DrawingPool& drawings_;
    Diagnostics& diagnostics_;
};

}
