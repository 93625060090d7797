#include "host/link/hid_pipe.hpp"

#include "host/link/remote_device.hpp"
#include "tests/host/link/pretend_hidapi.hpp"

#include <doctest/doctest.h>

#include <cerrno>
#include <functional>

namespace kfast::test {
namespace {

/// An open device, with what its calls return.
struct Bench {
    Bench() { hidapi = {}; }
    ~Bench()
    {
        pipe.reset();
        CHECK(hidapi.open == 0);
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    void open() { pipe = open_hid_pipe({DeviceAddress::Way::usb, "/dev/none", "E6"}); }

    PretendHidapi& hidapi = pretend_hidapi();
    std::unique_ptr<ReportPipe> pipe;
};

ExitStatus status_of_failure(const std::function<void()>& act)
{
    try {
        act();
    } catch (const Failure& failure) {
        return failure.status();
    }
    return ExitStatus::done;
}

}

TEST_CASE("devices are listed by their serial numbers, and others are not")
{
    Bench bench;
    bench.hidapi.plugged_in = {{"/dev/c", 0xFF00, L"C"},
                               {"/dev/b", 0, L"B"},          // of whose use nothing is known
                               {"/dev/mouse", 0x0001, L"A"}, // of somebody else
                               {"/dev/a", 0xFF00, nullptr}};
    const auto devices = attached_devices();
    REQUIRE(devices.size() == 3);
    CHECK(devices[0].path == "/dev/a");
    CHECK(devices[0].serial.empty());
    CHECK(devices[1].serial == "B");
    CHECK(devices[2].serial == "C");
    CHECK(devices[2].way == DeviceAddress::Way::usb);
    bench.hidapi.plugged_in.clear();
    CHECK(attached_devices().empty());
}

TEST_CASE("serial numbers become UTF-8, without what is no character")
{
    Bench bench;
    const wchar_t serial[]{
        L'E', static_cast<wchar_t>(0xD800), L'\u00E9', static_cast<wchar_t>(0x110000), L'6', 0};
    bench.hidapi.plugged_in = {{"/dev/a", 0xFF00, serial}};
    CHECK(attached_devices().at(0).serial == "E\u00E96");
}

TEST_CASE("a report goes behind a byte 0, as there are no report ids")
{
    Bench bench;
    bench.open();
    Report report;
    report.bytes[0] = std::byte{7};
    report.bytes[report_bytes - 1] = std::byte{9};
    bench.hidapi.writes = {{-1, EINTR}, {-1, EINTR}, {65, 0}}; // interruptions lose nothing
    bench.pipe->send(report);
    REQUIRE(bench.hidapi.written.size() == 3);
    const auto& bytes = bench.hidapi.written.back();
    REQUIRE(bytes.size() == 1 + report_bytes);
    CHECK(bytes[0] == 0);
    CHECK(bytes[1] == 7);
    CHECK(bytes[report_bytes] == 9);
}

TEST_CASE("a device that takes nothing, and one that is gone, are told apart")
{
    Bench bench;
    bench.open();
    bench.hidapi.writes = {{-1, ETIMEDOUT}, {-1, ENODEV}};
    CHECK(status_of_failure([&] { bench.pipe->send({}); }) == ExitStatus::timed_out);
    CHECK(status_of_failure([&] { bench.pipe->send({}); }) == ExitStatus::unplugged);
}

TEST_CASE("a report comes whole or not at all")
{
    Bench bench;
    bench.open();
    bench.hidapi.reads = {{64, 0}, {0, 0}, {63, 0}, {-1, EINTR}, {-1, EIO}};
    const auto report = bench.pipe->receive(Milliseconds{1});
    REQUIRE(report);
    for (std::size_t at = 0; at < report_bytes; ++at)
        CHECK(report->bytes[at] == static_cast<std::byte>(at));
    CHECK_FALSE(bench.pipe->receive(Milliseconds{1})); // nothing has come
    CHECK_FALSE(bench.pipe->receive(Milliseconds{1}));
    CHECK_FALSE(bench.pipe->receive(Milliseconds{1}));
    CHECK(status_of_failure([&] { bench.pipe->receive(Milliseconds{1}); }) == ExitStatus::unplugged);
}

TEST_CASE("a device that cannot be opened is told with the reason")
{
    Bench bench;
    bench.hidapi.opens = false;
    try {
        bench.open();
        FAIL("it cannot be opened");
    } catch (const Failure& failure) {
        CHECK(failure.status() == ExitStatus::no_device);
        CHECK(std::string{failure.what()}.find("/dev/none: it is asleep") != std::string::npos);
    }
    for (const char* const path :
         {"/dev/none", "/dev/null"}) { // there is nothing; or it may be opened, but cannot
        const DeviceAddress address{DeviceAddress::Way::usb, path, "E6"};
        CHECK(status_of_failure([&] { open_device(address, Milliseconds{1}); }) == ExitStatus::no_device);
    }
}

}
