#include "host/compiler/input_writer.hpp"

#include "host/compiler/name_writer.hpp"

namespace kfast {
namespace {

constexpr std::uint32_t number_kind = 0;

}

void write_inputs(const std::vector<scene::Input>& inputs, ByteWriter& bytes)
{
    for (const scene::Input& input : inputs) {
        bytes.u8(number_kind);
        write_name(input.name, bytes);
        for (const std::int32_t value : {input.least, input.most, input.usual})
            bytes.signed_varint(value);
    }
}

}
