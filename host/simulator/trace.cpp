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

namespace {

/// The shortest time that resets all controllers.
constexpr std::chrono::microseconds shortest_reset{10};

bool is_select_record(const TraceRecord& record)
{
    return record.kind == TraceKind::selected || record.kind == TraceKind::deselected;
}

std::string_view text_of(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

[[noreturn]] void refuse(const TraceRecord& record, const std::string& what)
{
    throw Failure("the record at byte " + std::to_string(record.position) + " of the trace, " +
                  std::to_string(record.time.count()) + " ns: " + what);
}

}

void TraceReplay::play(std::span<const TraceRecord> trace,
                       const std::function<void(std::string_view note)>& on_note)
{
    is_selected_ = std::ranges::none_of(trace, is_select_record);
    model_.reset(std::chrono::nanoseconds{});
    for (const TraceRecord& record : trace) {
        if (record.kind == TraceKind::note)
            on_note(text_of(record.bytes));
        else
            play(record);
        if (model_.error())
            refuse(record, "the panel was driven wrongly: " + *model_.error());
    }
}

void TraceReplay::play(const TraceRecord& record)
{
    switch (record.kind) {
    case TraceKind::command:
        expect_listener(record);
        return model_.command(record.time, record.bytes);
    case TraceKind::data:
        expect_listener(record);
        return model_.data(record.time, record.bytes);
    case TraceKind::reset_low:
        reset_began_ = reset_began_.value_or(record.time);
        return;
    case TraceKind::reset_high:
        return raise_reset(record);
    case TraceKind::selected:
    case TraceKind::deselected:
        is_selected_ = record.kind == TraceKind::selected;
        return;
    case TraceKind::note:
        return;
    }
}

void TraceReplay::raise_reset(const TraceRecord& record)
{
    if (!reset_began_)
        return;
    if (record.time - *reset_began_ < shortest_reset)
        refuse(record, "a reset shorter than 10 microseconds");
    reset_began_.reset();
    model_.reset(record.time);
}

void TraceReplay::expect_listener(const TraceRecord& record) const
{
    if (!is_selected_)
        refuse(record, "bytes while chip select is inactive");
    if (reset_began_)
        refuse(record, "bytes while the reset line is low");
}

}
