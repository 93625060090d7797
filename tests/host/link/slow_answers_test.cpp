#include "host/link/live_feed.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/scene_upload.hpp"
#include "host/link/session.hpp"
#include "tests/host/link/device_pipe.hpp"
#include "tests/host/link/scripted_pipe.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>

/// Answers that come late, to somebody else, or that no device should give.
namespace kfast::test {

using namespace link;

namespace {

/// A device from which a report comes as often as one is waited for, at the end of the patience.
class ChattyPipe : public ReportPipe {
public:
    explicit ChattyPipe(const Report& report) : report_{report} {}

    void send(const Report&) override {}
    std::optional<Report> receive(Milliseconds patience) override
    {
        now_ += patience;
        ++received;
        return report_;
    }
    Milliseconds now() const override { return now_; }

    int received = 0;

private:
    Report report_;
    Milliseconds now_{0};
};

std::optional<ExitStatus> exit_status_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const kfast::Failure& failure) {
        return failure.status();
    }
    return std::nullopt;
}

/// An answer of this kind, from a device.
Report answer_of(const Report& request, const StatusWithNumber& result)
{
    return report_of(
        link::Failure{.request = request.kind(), .status = result.status, .number = result.number},
        request.tag());
}

/// A device that acknowledges all blocks of a scene at once, and answers commits in their turn.
struct Committing {
    explicit Committing(const std::vector<std::byte>& scene)
        : blocks{static_cast<std::uint16_t>(blocks_of(static_cast<std::uint32_t>(scene.size())))}
    {
        pipe.answer = [this](const Report& report) { return answer(report); };
    }

    std::optional<Report> answer(const Report& report)
    {
        if (report.kind() == code_of<Begin>()) {
            ++begun;
            return report_of(Begun{.next = blocks, .window = 64}, report.tag());
        }
        if (report.kind() != code_of<Commit>())
            return std::nullopt;
        const StatusWithNumber result = begun <= refusals ? refusal : StatusWithNumber{};
        return result.is_ok() ? report_of(Done<Kind::commit>{}, report.tag()) : answer_of(report, result);
    }

    ScriptedPipe pipe;
    std::uint16_t blocks;
    StatusWithNumber refusal;
    int refusals = 0; ///< how many commits are refused
    int begun = 0;
};

}

TEST_CASE("reports to somebody else, as many as come, do not make a patience longer")
{
    ChattyPipe pipe{report_of(Done<Kind::pause>{}, 5)};
    Session session{pipe, {}};
    CHECK_FALSE(session.hear(6, Milliseconds{10}));
    CHECK(pipe.received == 1);
    CHECK(session.hear(5, Milliseconds{10}));
}

TEST_CASE("a device that answers with something else again and again is given up")
{
    ChattyPipe pipe{report_of(Done<Kind::pause>{}, 1)};
    Session session{pipe, {.last_patience = Milliseconds{500}, .first_tag = 1}};
    CHECK(exit_status_of([&] { session.order(Resume{}); }) == ExitStatus::timed_out);
    CHECK(pipe.now() >= Milliseconds{500});
}

TEST_CASE("a farewell waits for its answer alone, and not for long")
{
    const auto waited = [](const std::optional<Report>& answer) {
        ScriptedPipe pipe;
        pipe.answer = [&](const Report&) { return answer; };
        Session session{pipe, {}};
        session.take_leave(report_of(Cancel{}, 7));
        return pipe.now();
    };
    CHECK(waited(report_of(Done<Kind::cancel>{}, 7)) < Milliseconds{100});
    CHECK(waited(report_of(Done<Kind::cancel>{}, 8)) >= Milliseconds{500});
    CHECK(waited(report_of(Done<Kind::pause>{}, 7)) >= Milliseconds{500});
    CHECK(waited(std::nullopt) >= Milliseconds{500});
    CHECK(waited(std::nullopt) < Milliseconds{1000});
}

TEST_CASE("an upload is begun anew where the device knows nothing of it any more")
{
    const Scene scene = padded_scene(2000, 1);
    Committing device{scene};
    device.refusal = Status::no_transfer;
    device.refusals = 1;
    Session session{device.pipe, {}};
    upload_scene(session, begin_in_ram(scene), scene, [](std::size_t) {});
    CHECK(device.begun == 2);
}

TEST_CASE("a device that misses a block behind the last one is not believed")
{
    const Scene scene = padded_scene(2000, 1);
    Committing device{scene};
    device.refusal = {Status::incomplete, device.blocks};
    device.refusals = 1;
    Session session{device.pipe, {}};
    try {
        upload_scene(session, begin_in_ram(scene), scene, [](std::size_t) {});
        FAIL("there is no such block");
    } catch (const Refusal& refusal) {
        CHECK(refusal.status() == Status::incomplete);
    }
    CHECK(device.begun == 1);
}

TEST_CASE("more values than a report has room for come in several")
{
    LinkBench device;
    REQUIRE(device.does(Play{.home = Home::built_in}));
    device.device.now.inputs = 32;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    LiveFeed feed;
    LiveValues values;
    for (std::uint8_t input = 0; input < 30; ++input)
        values.places[input] = Time{100 + input};
    feed.put(values);
    feed.close();
    send_live(session, feed, Milliseconds{300});
    for (std::uint8_t input = 0; input < 30; ++input)
        CHECK(device.device.inputs.at(input) == Time{100 + input});
    CHECK(pipe.sent.size() == 3 + 1);
}

TEST_CASE("while there are no values the device is shown now and then that somebody is there")
{
    /// Time passes whenever somebody looks for a report.
    struct TickingPipe : DevicePipe {
        using DevicePipe::DevicePipe;
        std::optional<Report> receive(Milliseconds patience) override
        {
            looked += Milliseconds{1};
            return DevicePipe::receive(patience);
        }
        Milliseconds now() const override { return DevicePipe::now() + looked; }
        Milliseconds looked{0};
    };
    LinkBench device;
    TickingPipe pipe{device};
    Session session{pipe, {}};
    LiveFeed feed;
    std::vector<Milliseconds> sent;
    pipe.on_sent = [&](const Report& report) {
        if (const auto inputs = message_of<Inputs>(report)) {
            CHECK(inputs->count == 0);
            sent.push_back(pipe.now());
            if (sent.size() == 4)
                feed.close();
        }
    };
    send_live(session, feed, Milliseconds{10});
    for (std::size_t at = 1; at < sent.size(); ++at) {
        CHECK(sent[at] - sent[at - 1] >= Milliseconds{10});
        CHECK(sent[at] - sent[at - 1] < Milliseconds{20});
    }
}

TEST_CASE("answers to somebody who left before they came are passed over, even if there are many")
{
    /// They lie there before anything is asked.
    struct UsedPipe : ScriptedPipe {
        std::optional<Report> receive(Milliseconds patience) override
        {
            return old-- > 0 ? report_of(Done<Kind::pause>{}, 1) : ScriptedPipe::receive(patience);
        }
        int old = 0;
    };
    for (const int count : {0, 3, 63, 64, 65, 200}) {
        auto pipe = std::make_unique<UsedPipe>();
        pipe->old = count;
        bool is_asked = false;
        auto* const used = pipe.get();
        used->answer = [&is_asked, used, count](const Report& request) {
            if (!std::exchange(is_asked, true))
                CHECK(used->old <= std::max(0, count - 64));
            return report_of(Capabilities{.serial = {"E6"}}, request.tag());
        };
        CHECK(RemoteDevice{std::move(pipe), {.first_tag = 1}, "it"}.name() == "E6");
    }
}

TEST_CASE("a device without a serial number is called as it was found")
{
    auto pipe = std::make_unique<ScriptedPipe>();
    pipe->answer = [](const Report& request) { return report_of(Capabilities{}, request.tag()); };
    CHECK(RemoteDevice{std::move(pipe), {}, "it"}.name() == "it");
}

}
