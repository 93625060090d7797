#include "host/compiler/write/backbone_writer.hpp"

#include "host/compiler/carry/backbone_timeline.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/compiler/pack/value_writer.hpp"

#include <vector>

namespace kfast {

void write_backbones(const scene::Object& object, std::uint32_t unit_bits, LawTable& laws,
                     DrawingPool& drawings, ByteWriter& bytes)
{
    KeyTimes key_times;
    std::vector<std::int32_t> offsets;
    for (const scene::BackboneKey& key : object.backbone_keys) {
        const bool is_last = &key == &object.backbone_keys.back();
        key_times.push_back({key.time, laws.number_of(is_last ? LawPair{} : key.laws, key.place)});
        offsets.push_back(drawings.offset_of(drawing_of(key.backbones)));
    }
    bytes.u8(unit_bits);
    write_key_times({key_times, object.driver}, one_key_time, bytes);
    write_values(offsets, bytes);
}

}
