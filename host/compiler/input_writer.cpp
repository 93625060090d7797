#include "host/compiler/input_writer.hpp"

#include "host/compiler/name_writer.hpp"

namespace kfast {
namespace {

void write_number(const scene::Input& input, ByteWriter& bytes)
{
    for (const std::int32_t value : {input.least, input.most, input.usual})
        bytes.signed_varint(value);
}

void write_drawing(const scene::DrawingInput& drawing, DrawingPool& drawings, ByteWriter& bytes)
{
    bytes.varint(static_cast<std::uint32_t>(drawing.strokes));
    bytes.varint(static_cast<std::uint32_t>(drawing.points));
    bytes.varint(static_cast<std::uint32_t>(drawings.offset_of(drawing.usual)));
}

}

void write_inputs(const std::vector<scene::Input>& inputs, DrawingPool& drawings, ByteWriter& bytes)
{
    for (const scene::Input& input : inputs) {
        bytes.u8(static_cast<std::uint32_t>(input.type));
        write_name(input.name, bytes);
        if (input.type == InputType::drawing)
            write_drawing(input.drawing, drawings, bytes);
        else
            write_number(input, bytes);
    }
}

}
