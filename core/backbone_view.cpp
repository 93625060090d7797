#include "core/backbone_view.hpp"

#include "core/time_code.hpp"

namespace kfast {

BackboneKey BackboneKeyCursor::next()
{
    time_ = time_ + read_time_code(bytes_);
    const std::uint32_t laws = bytes_.u8();
    return {.time = time_, .laws = laws, .drawing = bytes_.varint()};
}

}
