#include "host/link/scene_upload.hpp"
#include "host/link/session.hpp"
#include "host/program/interruption.hpp"
#include "tests/host/link/device_pipe.hpp"
#include "tests/host/link/scripted_pipe.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <set>
#include <utility>

/// The computer's side of uploads, against the firmware's own end of the link.
namespace kfast::test {

using namespace link;

namespace {

const ByteProgressCallback nobody = [](std::size_t) {};

Scene in_slot(LinkBench& bench, std::uint8_t slot)
{
    return state_of(Store{bench.flash, small_places}).slots[slot].scene;
}

std::size_t count_of(const std::vector<Report>& reports, Kind kind)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        reports, [&](const Report& report) { return report.kind() == static_cast<std::uint8_t>(kind); }));
}

}

TEST_CASE("a scene goes into a slot and into RAM, each block once")
{
    const Scene scene = padded_scene(9000, 3);
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    upload_scene(session, begin_in_slot(2, "eyes", scene), scene, nobody);
    CHECK(in_slot(device, 2) == scene);
    CHECK(count_of(pipe.sent, Kind::data) == 150);
    CHECK(count_of(pipe.sent, Kind::begin) == 1);
    CHECK(count_of(pipe.sent, Kind::commit) == 1);

    upload_scene(session, begin_in_ram(scene), scene, nobody);
    CHECK(device.device.ram == scene);
    CHECK(count_of(pipe.sent, Kind::data) == 300);
}

TEST_CASE("every block but the last carries 60 bytes, and the window stays full")
{
    const Scene scene = padded_scene(7777, 3);
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    upload_scene(session, begin_in_ram(scene), scene, nobody);
    // A report a millisecond: whoever waits for acknowledgements needs more.
    CHECK(pipe.now() <= Milliseconds{130 + 40});
    Scene sent;
    for (const Report& report : pipe.sent)
        if (const auto data = message_of<Data>(report))
            sent.insert(sent.end(), data->bytes.begin(), data->bytes.end());
    sent.resize(scene.size());
    CHECK(sent == scene);
}

TEST_CASE("each upload has another tag")
{
    const Scene scene = padded_scene(1000, 3);
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    std::set<std::uint8_t> tags;
    for (int count = 0; count < 20; ++count)
        upload_scene(session, begin_in_ram(scene), scene, nobody);
    for (const Report& report : pipe.sent)
        if (message_of<Begin>(report))
            tags.insert(report.tag());
    CHECK(tags.size() == 20);
}

TEST_CASE("uploads get through links that lose, repeat, reorder and cut reports")
{
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        const Scene scene = padded_scene(400 + seed * 237 % 9000, seed);
        const Badness badness{.lost = seed * 3, .repeated = 60, .overtaken = 80, .truncated = 20};
        LinkBench device;
        DevicePipe pipe{device, badness, seed};
        Session session{pipe, {.last_patience = Milliseconds{60'000}}};
        const bool is_for_ram = seed % 2 == 0;
        upload_scene(session, is_for_ram ? begin_in_ram(scene) : begin_in_slot(1, "s", scene), scene, nobody);
        CHECK((is_for_ram ? device.device.ram : in_slot(device, 1)) == scene);
    }
}

TEST_CASE("over links that damage reports and bring garbage, a scene comes whole or not at all")
{
    int right = 0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        const Scene scene = padded_scene(400 + seed * 237 % 5000, seed);
        LinkBench device;
        DevicePipe pipe{device, {.lost = 20, .damaged = 5, .garbage = 20}, seed};
        Session session{pipe, {.last_patience = Milliseconds{20'000}}};
        try {
            upload_scene(session, begin_in_slot(1, "s", scene), scene, nobody);
            ++right;
        } catch (const kfast::Failure&) {
        }
        const Scene found = in_slot(device, 1);
        CHECK((found == scene || found.empty()));
    }
    CHECK(right > 40);
}

TEST_CASE("a block that is lost is sent again as soon as the device misses it")
{
    const Scene scene = padded_scene(7777, 3);
    LinkBench device;
    DevicePipe pipe{device};
    bool is_lost = false;
    pipe.on_the_way = [&](const Report& report) {
        const auto data = message_of<Data>(report);
        const bool loses = data && data->block == 20 && !std::exchange(is_lost, true);
        return loses ? std::nullopt : std::optional{report};
    };
    Session session{pipe, {}};
    upload_scene(session, begin_in_ram(scene), scene, nobody);
    CHECK(device.device.ram == scene);
    CHECK(is_lost);
    CHECK(pipe.now() <= Milliseconds{130 + 40}); // no silence was waited for
}

TEST_CASE("a scene that was damaged on the way is sent once more")
{
    const Scene scene = padded_scene(3000, 3);
    LinkBench device;
    DevicePipe pipe{device};
    bool is_damaged = false;
    pipe.on_the_way = [&](Report report) {
        if (message_of<Data>(report) && !std::exchange(is_damaged, true))
            report.bytes[40] ^= std::byte{4};
        return std::optional{report};
    };
    Session session{pipe, {}};
    upload_scene(session, begin_in_slot(1, "s", scene), scene, nobody);
    CHECK(in_slot(device, 1) == scene);
    CHECK(count_of(pipe.sent, Kind::begin) == 2);
}

TEST_CASE("a scene that is damaged each time is given up")
{
    const Scene scene = padded_scene(3000, 3);
    Scene other = scene;
    other.back() ^= std::byte{1};
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    CHECK_THROWS_AS(upload_scene(session, begin_in_ram(other), scene, nobody), Refusal);
    CHECK(count_of(pipe.sent, Kind::begin) < 10);
}

TEST_CASE("an acknowledgement of blocks that were not sent is not believed")
{
    const Scene scene = padded_scene(3000, 3); // 50 blocks
    ScriptedPipe pipe;
    std::set<std::uint16_t> came;
    pipe.answer = [&](const Report& report) -> std::optional<Report> {
        if (message_of<Begin>(report))
            return report_of(Begun{.next = 0, .window = 8}, report.tag());
        if (const auto data = message_of<Data>(report)) {
            came.insert(data->block);
            const auto next = static_cast<std::uint16_t>(data->block == 0 ? 50 : data->block + 1);
            return report_of(Acknowledgement{.next = next, .window = 8}, report.tag());
        }
        CHECK(came.size() == 50);
        return report_of(Done<Kind::commit>{}, report.tag());
    };
    Session session{pipe, {}};
    upload_scene(session, begin_in_ram(scene), scene, nobody);
    CHECK(came.size() == 50);
}

TEST_CASE("a device that never has all blocks, as it says, is given up")
{
    const Scene scene = padded_scene(3000, 3);
    ScriptedPipe pipe;
    pipe.answer = [&](const Report& report) -> std::optional<Report> {
        if (message_of<Begin>(report))
            return report_of(Begun{.next = 50, .window = 64}, report.tag());
        if (message_of<Data>(report))
            return report_of(Acknowledgement{.next = 50, .window = 64}, report.tag());
        return report_of(link::Failure{.request = report.kind(), .status = Status::incomplete, .number = 49},
                         report.tag());
    };
    Session session{pipe, {}};
    CHECK_THROWS_AS(upload_scene(session, begin_in_ram(scene), scene, nobody), Refusal);
}

TEST_CASE("what flash does not hold is sent once more, to where it does; but not for ever")
{
    const Scene scene = padded_scene(100, 3);
    ScriptedPipe pipe;
    int begun = 0;
    int failing = 0;
    pipe.answer = [&](const Report& report) -> std::optional<Report> {
        if (message_of<Begin>(report))
            return ++begun, report_of(Begun{.next = 2, .window = 8}, report.tag());
        if (begun <= failing)
            return report_of(link::Failure{.request = report.kind(), .status = Status::flash_failed},
                             report.tag());
        return report_of(Done<Kind::commit>{}, report.tag());
    };
    Session session{pipe, {}};
    failing = 1;
    upload_scene(session, begin_in_slot(1, "s", scene), scene, nobody);
    CHECK(begun == 2);
    failing = 100;
    CHECK_THROWS_AS(upload_scene(session, begin_in_slot(1, "s", scene), scene, nobody), Refusal);
    CHECK(begun == 2 + 4);
}

TEST_CASE("progress is told and ends with all")
{
    const Scene scene = padded_scene(5000, 3);
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    std::vector<std::size_t> progress;
    upload_scene(session, begin_in_ram(scene), scene, [&](std::size_t bytes) { progress.push_back(bytes); });
    CHECK(std::ranges::is_sorted(progress));
    CHECK(progress.front() == 0);
    CHECK(progress.back() == scene.size());
    CHECK(progress.size() > 3);
}

TEST_CASE("unplugged after any report, an upload says so, and the next one succeeds")
{
    const Scene scene = padded_scene(1500, 3);
    for (std::size_t count = 0;; ++count) {
        CAPTURE(count);
        LinkBench device;
        DevicePipe broken{device};
        broken.unplugged_after = count;
        Session session{broken, {}};
        try {
            upload_scene(session, begin_in_slot(4, "s", scene), scene, nobody);
            CHECK(count > 28); // begin, 25 blocks, commit and answers
            break;
        } catch (const kfast::Failure& failure) {
            CHECK(failure.status() == ExitStatus::unplugged);
        }
        DevicePipe whole{device};
        Session again{whole, {.first_tag = 100}};
        upload_scene(again, begin_in_slot(4, "s", scene), scene, nobody);
        CHECK(in_slot(device, 4) == scene);
    }
}

TEST_CASE("a device that falls silent in the midst of an upload is given up")
{
    const Scene scene = padded_scene(9000, 3);
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {.last_patience = Milliseconds{5000}}};
    pipe.on_sent = [&](const Report&) { pipe.is_silent = pipe.sent.size() > 100; };
    try {
        upload_scene(session, begin_in_ram(scene), scene, nobody);
        FAIL("it is silent");
    } catch (const kfast::Failure& failure) {
        CHECK(failure.status() == ExitStatus::timed_out);
    }
    CHECK(pipe.now() < Milliseconds{20'000});
}

TEST_CASE("an upload that is interrupted is cancelled on the device")
{
    const Scene scene = padded_scene(9000, 3);
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    const RememberedInterruption interruption;
    pipe.on_sent = [&](const Report&) {
        if (pipe.sent.size() == 60)
            std::raise(SIGINT);
    };
    CHECK_THROWS_AS(upload_scene(session, begin_in_slot(1, "s", scene), scene, nobody), Interrupted);
    CHECK(count_of(pipe.sent, Kind::cancel) == 1);
    CHECK(pipe.sent.back().kind() == static_cast<std::uint8_t>(Kind::cancel));
    CHECK(pipe.sent.back().tag() == pipe.sent.front().tag());
    CHECK(pipe.sent.size() <= 62);
    CHECK(in_slot(device, 1).empty());
}

TEST_CASE("an upload that the device has dropped is begun anew")
{
    const Scene scene = padded_scene(9000, 3);
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    pipe.on_sent = [&](const Report&) {
        if (pipe.sent.size() == 60)
            device.wait(4000); // the computer slept
    };
    upload_scene(session, begin_in_slot(1, "s", scene), scene, nobody);
    CHECK(in_slot(device, 1) == scene);
    CHECK(count_of(pipe.sent, Kind::begin) == 2);
}

TEST_CASE("a scene for which there is no room is refused without a block")
{
    const Scene scene = padded_scene(20'001, 3);
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    CHECK_THROWS_AS(upload_scene(session, begin_in_ram(scene), scene, nobody), Refusal);
    CHECK(count_of(pipe.sent, Kind::data) == 0);
}

TEST_CASE("what is no scene is refused, and not sent again and again")
{
    const Scene scene(1000, std::byte{1});
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    CHECK_THROWS_AS(upload_scene(session, begin_in_ram(scene), scene, nobody), Refusal);
    CHECK(count_of(pipe.sent, Kind::begin) == 1);
}

}
