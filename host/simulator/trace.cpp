#include "host/simulator/trace.hpp"

#include "core/bytes/byte_reader.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

namespace kfast {
namespace {

constexpr std::string_view magic = "KFTRACE1";
constexpr std::uint64_t latest = std::numeric_limits<std::int64_t>::max();

[[noreturn]] void refuse(std::size_t position, const std::string& what)
{
    throw Failure("the trace is damaged at byte " + std::to_string(position) + ": " + what);
}

constexpr bool has_bytes(TraceKind kind)
{
    return kind == TraceKind::command || kind == TraceKind::data || kind == TraceKind::note;
}

std::chrono::nanoseconds read_time(ByteReader& reader, std::size_t position)
{
    const std::uint64_t low = reader.u32();
    const std::uint64_t time = low | std::uint64_t{reader.u32()} << 32;
    if (time > latest)
        refuse(position, "a time beyond all times");
    return std::chrono::nanoseconds{static_cast<std::int64_t>(time)};
}

TraceRecord read_record(ByteReader& reader, std::size_t position)
{
    const std::uint32_t kind = reader.u8();
    const auto time = read_time(reader, position);
    const std::uint32_t count = reader.u32();
    if (reader.overrun())
        refuse(position, "it ends within the head of a record");
    if (kind > static_cast<std::uint32_t>(TraceKind::note))
        refuse(position, "there is no record of kind " + std::to_string(kind));
    if (count > reader.left())
        refuse(position, "a record of " + std::to_string(count) + " bytes, of which " +
                             std::to_string(reader.left()) + " are there");
    if (count != 0 && !has_bytes(static_cast<TraceKind>(kind)))
        refuse(position, "a record of kind " + std::to_string(kind) + " has no bytes, this one " +
                             std::to_string(count));
    return {static_cast<TraceKind>(kind), time, reader.take(count).rest(), position};
}

bool begins_with_magic(std::span<const std::byte> bytes)
{
    const auto letters = std::as_bytes(std::span{magic});
    return bytes.size() >= letters.size() && std::ranges::equal(bytes.first(letters.size()), letters);
}

}

std::vector<TraceRecord> read_trace(std::span<const std::byte> bytes)
{
    if (!begins_with_magic(bytes))
        refuse(0, "it does not begin with KFTRACE1");
    std::vector<TraceRecord> records;
    ByteReader reader{bytes.subspan(magic.size())};
    std::chrono::nanoseconds before{};
    while (reader.left() != 0) {
        const std::size_t position = bytes.size() - reader.left();
        records.push_back(read_record(reader, position));
        if (records.back().time < before)
            refuse(position, "the time goes back");
        before = records.back().time;
    }
    return records;
}

}
