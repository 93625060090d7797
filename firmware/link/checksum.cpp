#include "firmware/link/checksum.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/crc16.hpp"
#include "firmware/chip/span_writer.hpp"

#include <cstdint>
#include <span>

namespace kfast::link {
namespace {

constexpr std::size_t checksum_at = report_bytes - checksum_bytes;

bool is_checked(const Report& report)
{
    return has_checksum(static_cast<Kind>(report.kind() & ~from_device));
}

std::uint16_t checksum_of(const Report& report) { return crc16(std::span{report.bytes}.first(checksum_at)); }

}

Report with_checksum(Report report)
{
    if (is_checked(report))
        SpanWriter{std::span{report.bytes}.subspan(checksum_at)}.u16(checksum_of(report));
    return report;
}

bool is_whole(const Report& report)
{
    return !is_checked(report) ||
           ByteReader{std::span{report.bytes}.subspan(checksum_at)}.u16() == checksum_of(report);
}

}
