#pragma once

#include "firmware/slots/flash.hpp"

#include <cstdint>

namespace kfast {

/// Where the slots of a device are in its flash, in whole sectors.
struct FlashPlaces {
    std::uint32_t directory = 0; ///< two sectors
    std::uint32_t pool = 0;
    std::uint32_t pool_bytes = 0;
};

}
