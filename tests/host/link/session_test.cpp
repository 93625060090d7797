#include "host/link/remote_device.hpp"
#include "host/link/session.hpp"
#include "host/program/interruption.hpp"
#include "tests/host/link/device_pipe.hpp"
#include "tests/host/link/scripted_pipe.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <memory>

namespace kfast::test {

using namespace link;

namespace {

ExitStatus status_of_failure(const std::function<void()>& act)
{
    try {
        act();
    } catch (const kfast::Failure& failure) {
        CHECK(std::string{failure.what()} != "");
        return failure.status();
    }
    return ExitStatus::done;
}

}

TEST_CASE("a device is asked and answers")
{
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    CHECK(session.ask<Capabilities>(Hello{}).serial.view() == "E66058388341A22C");
    CHECK(session.ask<Names>(AskNames{}).board.view() == "pico");
    session.order(Speed{-32768});
    CHECK(device.device.now.speed == -32768);
    CHECK(pipe.sent.size() == 3);
}

TEST_CASE("each request has another tag, and none has that of what needs no answer")
{
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {.first_tag = 250}};
    for (int count = 0; count < 300; ++count)
        session.order(Pause{});
    for (std::size_t at = 1; at < pipe.sent.size(); ++at) {
        CHECK(pipe.sent[at].tag() != 0);
        CHECK(pipe.sent[at].tag() != pipe.sent[at - 1].tag());
    }
}

TEST_CASE("requests get through a link that loses, repeats and reorders")
{
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        LinkBench device;
        DevicePipe pipe{
            device, {.lost = 300, .repeated = 200, .overtaken = 200, .truncated = 50, .garbage = 100}, seed};
        Session session{pipe, {.last_patience = Milliseconds{60'000}}};
        for (int value = 1; value <= 5; ++value) {
            session.order(Speed{value});
            CHECK(device.device.now.speed == value);
        }
        CHECK(session.ask<Names>(AskNames{}).panel.view() == "st7789");
    }
}

TEST_CASE("what a device refuses is told with its own words, a remedy and a status")
{
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    try {
        session.order(Play{.home = Home::slot, .slot = 3});
        FAIL("the slot is empty");
    } catch (const Refusal& refusal) {
        CHECK(refusal.status() == Status::empty_slot);
        CHECK(kfast::Failure{refusal}.status() == ExitStatus::refused);
        CHECK(std::string{refusal.what()} ==
              "the device says: the slot holds no scene: 'kfast slots' lists what there is");
    }
    try {
        session.ask<Begun>(Begin{.home = Home::ram, .size = 20'001});
        FAIL("there is no room");
    } catch (const Refusal& refusal) {
        CHECK(refusal.number() == 20'000);
        CHECK(kfast::Failure{refusal}.status() == ExitStatus::no_room);
        CHECK(std::string{refusal.what()}.find("it holds 20000 bytes") != std::string::npos);
    }
}

TEST_CASE("a device that is silent is given up after the last patience")
{
    LinkBench device;
    DevicePipe pipe{device};
    pipe.is_silent = true;
    Session session{pipe, {.last_patience = Milliseconds{3000}}};
    CHECK(status_of_failure([&] { session.order(Pause{}); }) == ExitStatus::timed_out);
    CHECK(pipe.now() >= Milliseconds{3000});
    CHECK(pipe.now() < Milliseconds{6000});
    CHECK(pipe.sent.size() > 3);  // asked again,
    CHECK(pipe.sent.size() < 10); // but less and less often
}

TEST_CASE("a device that sends without an end, but no answer, is given up as well")
{
    LinkBench device;
    DevicePipe pipe{device, {.lost = 1000, .garbage = 1000}};
    Session session{pipe, {.last_patience = Milliseconds{500}}};
    CHECK(status_of_failure([&] { session.order(Pause{}); }) == ExitStatus::timed_out);
}

TEST_CASE("a device that is unplugged is told at once")
{
    for (std::size_t count = 0; count < 6; ++count) {
        LinkBench device;
        DevicePipe pipe{device};
        pipe.unplugged_after = count;
        Session session{pipe, {}};
        CHECK(status_of_failure([&] {
                  for (int order = 0; order < 3; ++order)
                      session.order(Pause{});
              }) == ExitStatus::unplugged);
    }
}

TEST_CASE("an answer to somebody else, and one that is late, are passed over")
{
    ScriptedPipe pipe;
    pipe.answer = [](const Report& request) {
        const auto other = static_cast<std::uint8_t>(request.tag() + 1);
        return std::optional{report_of(Done<Kind::pause>{}, other)};
    };
    Session session{pipe, {.last_patience = Milliseconds{500}}};
    CHECK(status_of_failure([&] { session.order(Pause{}); }) == ExitStatus::timed_out);
    pipe.answer = [](const Report& request) { return std::optional{request}; }; // no device says that
    CHECK(status_of_failure([&] { session.order(Pause{}); }) == ExitStatus::timed_out);
}

TEST_CASE("what is told without a tag fails aloud")
{
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    session.post(Inputs{});
    session.throw_pending_failure();
    session.post(Speed{1 << 30});
    CHECK_THROWS_AS(session.throw_pending_failure(), Refusal);
    session.throw_pending_failure(); // once
    session.post(Speed{1 << 30});
    session.order(Pause{}); // does not take it for its own
    CHECK_THROWS_AS(session.throw_pending_failure(), Refusal);
}

TEST_CASE("requests have their checksums, and an answer that came damaged is asked for again")
{
    ScriptedPipe pipe;
    int requests = 0;
    pipe.answer = [&](const Report& request) {
        CHECK(is_whole(request));
        ++requests;
        return std::optional{report_of(SlotContents{.slot = 1, .size = 500}, request.tag())};
    };
    pipe.on_the_way = [&](Report& report) {
        if (requests == 1)
            report.bytes[4] ^= std::byte{1};
    };
    Session session{pipe, {}};
    CHECK(session.ask<SlotContents>(AskSlot{.slot = 1}).size == 500);
    CHECK(requests == 2);
}

TEST_CASE("who takes leave does not take a damaged answer for one")
{
    ScriptedPipe pipe;
    pipe.answer = [](const Report& request) {
        CHECK(is_whole(request));
        return std::optional{report_of(Done<Kind::cancel>{}, request.tag())};
    };
    pipe.on_the_way = [](Report& report) { report.bytes[30] = std::byte{9}; };
    Session session{pipe, {}};
    const Milliseconds begin = session.now();
    session.take_leave(report_of(Cancel{}, session.new_tag()));
    CHECK(session.now() - begin >= Milliseconds{500}); // it has waited for another one
}

TEST_CASE("that a value came damaged is no failure of the values that follow")
{
    ScriptedPipe pipe;
    pipe.answer = [](const Report& request) {
        return std::optional{
            report_of(link::Failure{.request = request.kind(), .status = Status::bad_report}, request.tag())};
    };
    Session session{pipe, {}};
    session.post(Inputs{});
    session.throw_pending_failure();
}

TEST_CASE("a device of another version of the link is not asked anything more")
{
    for (const std::uint8_t version :
         {std::uint8_t{protocol_version - 1}, std::uint8_t{protocol_version + 1}}) {
        auto pipe = std::make_unique<ScriptedPipe>();
        int requests = 0;
        pipe->answer = [&](const Report& request) {
            ++requests;
            return std::optional{report_of(Capabilities{.protocol = version}, request.tag())};
        };
        try {
            RemoteDevice device{std::move(pipe), {}, "it"};
            FAIL("it is not understood");
        } catch (const kfast::Failure& failure) {
            CHECK(failure.status() == ExitStatus::wrong_version);
            const std::string hint = version < protocol_version ? "update the firmware" : "update kfast";
            CHECK(std::string{failure.what()}.find(hint) != std::string::npos);
        }
        CHECK(requests == 1);
    }
}

TEST_CASE("a device is called by its serial number, fit for a terminal")
{
    auto pipe = std::make_unique<ScriptedPipe>();
    pipe->answer = [](const Report& request) {
        return std::optional{report_of(Capabilities{.serial = {"A\x1b[2J"}}, request.tag())};
    };
    CHECK(RemoteDevice{std::move(pipe), {}, "it"}.name() == "A<U+001B>[2J");
}

TEST_CASE("an interruption ends a session, which may take its leave")
{
    LinkBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    const RememberedInterruption interruption;
    session.order(Pause{});
    std::raise(SIGINT);
    CHECK_THROWS_AS(session.order(Resume{}), Interrupted);
    CHECK(device.device.now.is_paused);
    session.take_leave(report_of(Resume{}, session.new_tag()));
    CHECK_FALSE(device.device.now.is_paused);
}

}
