#include "host/simulator/trace_replay.hpp"

#include "host/program/failure.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// The least that makes a reset of all controllers.
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
