#include "core/scene/skin_reader.hpp"

#include <limits>

namespace kfast {

Binding::Binding(ByteReader& bytes, std::uint32_t count) : bytes_{bytes}, count_{count}
{
    bytes.skip(2 * (count - 1));
    last_ = bytes.u8();
}

SkinReader SkinReader::of(std::uint32_t bone)
{
    SkinReader reader;
    reader.binding_ = Binding{bone};
    reader.left_ = std::numeric_limits<std::uint32_t>::max();
    return reader;
}

const Binding& SkinReader::next()
{
    if (left_ != 0) {
        --left_;
        return binding_;
    }
    const std::uint32_t head = bytes_.varint();
    left_ = head >> 2;
    binding_ = Binding{bytes_, (head & 3) + 1};
    return binding_;
}

}
