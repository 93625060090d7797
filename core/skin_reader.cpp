#include "core/skin_reader.hpp"

namespace kfast {

/// The last bone has no weight of its own.
Binding::Binding(ByteReader& bytes, std::uint32_t count) : bytes_{bytes}, count_{count}
{
    bytes.skip(2 * count - 1);
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
