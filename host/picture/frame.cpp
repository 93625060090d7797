#include "host/picture/frame.hpp"

#include "core/bytes/crc32.hpp"

namespace kfast {

std::uint32_t hash(const Frame& frame)
{
    Crc32 crc;
    crc.add(frame.pixels);
    return crc.value();
}

}
