#pragma once

#include "firmware/link/message_kind.hpp"
#include "firmware/report.hpp"

#include <cstddef>

/// Some reports end with a checksum (has_checksum()): their last two bytes are the CRC-16
/// (core/bytes/crc16.hpp) of all before them, little-endian.
namespace kfast::link {

inline constexpr std::size_t checksum_bytes = 2;

/// The report as it is sent: with the checksum of its bytes, if it is of such a kind.
Report with_checksum(Report report);

/// Whether a report has the checksum of its bytes, or needs none.
bool is_whole(const Report& report);

}
