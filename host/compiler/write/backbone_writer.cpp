#include "host/compiler/write/backbone_writer.hpp"

#include "host/compiler/carry/backbone_timeline.hpp"
#include "host/compiler/pack/beat_writer.hpp"
#include "host/compiler/pack/value_writer.hpp"

#include <vector>

namespace kfast {

void write_backbones(const scene::Object& object, std::uint32_t unit_bits, LawTable& laws,
                     DrawingPool& drawings, ByteWriter& bytes)
{
    Beats beats;
    std::vector<std::int32_t> offsets;
    for (const scene::BackboneKey& key : object.backbone_keys) {
        const bool is_last = &key == &object.backbone_keys.back();
        beats.push_back({key.time, laws.number_of(is_last ? LawPair{} : key.laws, key.place)});
        offsets.push_back(drawings.offset_of(drawing_of(key.backbones)));
    }
    bytes.u8(unit_bits);
    write_beats({beats, object.clock}, one_beat, bytes);
    write_values(offsets, bytes);
}

}
