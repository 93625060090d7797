#include "host/link/remote_device.hpp"
#include "host/program/interruption.hpp"
#include "tests/host/link/scripted_pipe.hpp"

#include <doctest/doctest.h>

#include <latch>
#include <memory>
#include <stdexcept>

namespace kfast::test {

namespace {

std::vector<RemoteDevice> three_devices()
{
    std::vector<RemoteDevice> devices;
    for (const char* const serial : {"A", "B", "C"}) {
        auto pipe = std::make_unique<ScriptedPipe>();
        pipe->answer = [serial](const Report& request) {
            return std::optional{link::report_of(link::Capabilities{.serial = {serial}}, request.tag())};
        };
        devices.emplace_back(std::move(pipe), Session::Options{}, "it");
    }
    return devices;
}

}

TEST_CASE("devices are talked to at the same time")
{
    auto devices = three_devices();
    std::latch all{3};
    std::vector<std::string> names(3);
    on_each(devices, [&](RemoteDevice& device, std::size_t index) {
        all.arrive_and_wait(); // one after the other would wait for ever
        names[index] = device.name();
    });
    CHECK(names == std::vector<std::string>{"A", "B", "C"});
}

TEST_CASE("what fails is told with the names of the devices, when all have ended")
{
    auto devices = three_devices();
    std::latch others{2};
    try {
        on_each(devices, [&](RemoteDevice&, std::size_t index) {
            if (index == 1)
                return others.wait();
            others.count_down();
            throw Failure{index == 0 ? "is gone" : "is slow",
                          index == 0 ? ExitStatus::unplugged : ExitStatus::timed_out};
        });
        FAIL("two have failed");
    } catch (const Failure& failure) {
        CHECK(std::string{failure.what()} == "A: is gone\nkfast: C: is slow");
        CHECK(failure.status() == ExitStatus::unplugged);
    }
}

TEST_CASE("an interruption is told once, and other exceptions do not end the program")
{
    auto devices = three_devices();
    CHECK_THROWS_AS(on_each(devices, [](RemoteDevice&, std::size_t) { throw Interrupted{}; }), Interrupted);
    CHECK_THROWS_AS(on_each(devices, [](RemoteDevice&, std::size_t) { throw std::runtime_error{"x"}; }),
                    Failure);
}

}
