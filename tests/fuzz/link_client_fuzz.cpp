#include "core/bytes/crc32.hpp"
#include "firmware/link/checksum.hpp"
#include "firmware/link/fields.hpp"
#include "firmware/link/input_message.hpp"
#include "firmware/link/upload_message.hpp"
#include "host/commands/devices/playing_text.hpp"
#include "host/commands/devices/restart_text.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/link/live_feed.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/report_pipe.hpp"
#include "host/link/scene_upload.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "tests/demand.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

using namespace kfast;

namespace {

/// A device that says what the fuzzer wants; time passes by a millisecond for each report, and as long as
/// somebody waits. When there is nothing more to say it is silent for ever.
class AnyDevice final : public ReportPipe {
public:
    explicit AnyDevice(std::span<const std::byte> says) : says_{says} {}

    void send(const Report& report) override
    {
        pass(Milliseconds{1});
        if (report.tag() != 0)
            asked_ = report;
    }
    std::optional<Report> receive(Milliseconds patience) override
    {
        const auto how = static_cast<std::uint32_t>(take());
        if (how < 0x40) {
            pass(patience);
            return std::nullopt;
        }
        if (how >= 0xF8)
            throw unplugged();
        pass(Milliseconds{1});
        return report(how);
    }
    Milliseconds now() const override { return now_; }

private:
    void pass(Milliseconds time)
    {
        now_ += time;
        demand(now_ < Milliseconds{3'600'000}); // it would never end
    }

    std::uint8_t take()
    {
        if (says_.empty())
            return 0;
        const auto byte = std::to_integer<std::uint8_t>(says_.front());
        says_ = says_.subspan(1);
        return byte;
    }

    /// Bit 0: with the tag of what was asked for last; bit 1: of the kind that answers it; bit 2: short, the
    /// rest is 0; bit 3: with whatever checksum it has.
    Report report(std::uint32_t how)
    {
        Report report;
        const std::size_t count = std::min(says_.size(), (how & 4) != 0 ? std::size_t{8} : report_bytes);
        std::ranges::copy(says_.first(count), report.bytes.begin());
        says_ = says_.subspan(count);
        if ((how & 1) != 0)
            report.bytes[1] = static_cast<std::byte>(asked_.tag());
        if ((how & 2) != 0)
            report.bytes[0] = static_cast<std::byte>(asked_.kind() | from_device);
        return (how & 8) == 0 ? link::with_checksum(report) : report;
    }

    std::span<const std::byte> says_;
    Report asked_;
    Milliseconds now_{0};
};

void demand_printable(const std::string& text) { demand(visible(text) == text); }

/// What people and programs are told of it.
void tell(const RemoteDevice& device, const link::Playing& playing)
{
    demand_printable(device.name());
    demand_printable(playing_text(playing));
    if (playing.restarts.count != 0)
        demand_printable(restart_text(playing.restarts));
    demand_printable(safe_mode_text(playing.restarts));
    using Json = nlohmann::ordered_json;
    demand(Json::accept(json_text(
        Json{playing_json(playing), armed_json(playing), restart_json(playing.restarts), device.name()})));
}

void ask_for_everything(RemoteDevice& device)
{
    Session& session = device.session();
    session.ask<link::Names>(link::AskNames{});
    const auto playing = session.ask<link::Playing>(link::AskPlaying{});
    tell(device, playing);
    session.ask<link::Statistics>(link::AskStatistics{});
    for (std::uint8_t input = 0; input < playing.inputs; ++input)
        session.ask<link::InputState>(link::AskInput{input});
    const auto slots = slots_of(device);
    demand(slots.size() == device.capabilities().slots);
    demand(slot_for("eyes", slots) < slots.size());
}

void upload(RemoteDevice& device, bool is_for_ram)
{
    std::array<std::byte, 3000> scene{};
    const link::Begin begin = is_for_ram ? begin_in_ram(scene) : begin_in_slot(1, "eyes", scene);
    upload_scene(device.session(), begin, scene, [&](std::size_t bytes) { demand(bytes <= scene.size()); });
}

void send_values(RemoteDevice& device)
{
    LiveFeed feed;
    feed.put({.places = {{0, Time{7}}}, .texts = {{1, "12:45"}}, .drawings = {{2, {{{1, 2}, {3, 4}}}}}});
    feed.close();
    send_live(device.session(), feed, Milliseconds{300});
}

}

/// Whatever a device says, talking to it comes to an end: well, or with a Failure. The first byte says what
/// it is talked to about.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes = std::as_bytes(std::span{data, size});
    if (bytes.empty())
        return 0;
    try {
        RemoteDevice device{std::make_unique<AnyDevice>(bytes.subspan(1)), {}, "device"};
        switch (std::to_integer<std::uint32_t>(bytes[0]) % 4) {
        case 0:
            ask_for_everything(device);
            break;
        case 1:
            send_values(device);
            break;
        case 2:
            upload(device, true);
            break;
        default:
            upload(device, false);
            break;
        }
    } catch (const Failure& failure) {
        demand(failure.status() != ExitStatus::done && failure.what()[0] != '\0');
    }
    return 0;
}
