#include "host/compiler/backbone_writer.hpp"

#include "host/compiler/backbone_timeline.hpp"
#include "host/compiler/time_code.hpp"

namespace kfast {

void write_backbones(const scene::Object& object, std::uint32_t unit_bits, LawTable& laws,
                     DrawingPool& drawings, ByteWriter& bytes)
{
    ByteWriter keys;
    Time before;
    for (const scene::BackboneKey& key : object.backbone_keys) {
        const bool is_last = &key == &object.backbone_keys.back();
        keys.varint(time_code(key.time - before));
        keys.u8(laws.number_of(is_last ? LawPair{} : key.laws, key.place));
        keys.varint(drawings.offset_of(drawing_of(key.backbones)));
        before = key.time;
    }
    bytes.u8(unit_bits);
    bytes.block(keys.bytes());
}

std::uint64_t backbone_points(const scene::Object& object)
{
    std::uint64_t points = 0;
    for (const scene::BackboneKey& key : object.backbone_keys)
        points += point_count(drawing_of(key.backbones)) + 1;
    return points;
}

}
