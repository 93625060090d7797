#include "firmware/usb/control_pipe.hpp"

#include "tests/firmware/usb/pretended_controller.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kfast::usb::test {
namespace {

/// What the computer fetches of as many bytes, for which it has room: the sizes of the packets, whose bytes
/// follow each other. Then the pipe waits for the computer's acknowledgement.
std::vector<std::size_t> packets(std::size_t size, std::size_t room)
{
    Bytes data(size);
    for (std::size_t at = 0; at < size; ++at)
        data[at] = static_cast<std::byte>(at);
    PretendedController controller;
    ControlPipe pipe;
    pipe.answer(controller, data, room);
    Bytes fetched;
    std::vector<std::size_t> sizes;
    while (const auto packet = std::exchange(controller.of(Endpoint::control_in).given, {})) {
        CHECK_FALSE(controller.of(Endpoint::control_out).is_accepting);
        sizes.push_back(packet->size());
        fetched.insert(fetched.end(), packet->begin(), packet->end());
        CHECK_FALSE(pipe.sent(controller));
    }
    CHECK(controller.of(Endpoint::control_out).is_accepting);
    data.resize(std::min(size, room));
    CHECK(fetched == data);
    return sizes;
}

}

TEST_CASE("data come in full packets and a shorter one, which is empty if it has to be")
{
    using Sizes = std::vector<std::size_t>;
    CHECK(packets(150, 255) == Sizes{64, 64, 22});
    CHECK(packets(150, 150) == Sizes{64, 64, 22});
    CHECK(packets(150, 129) == Sizes{64, 64, 1});
    CHECK(packets(150, 128) ==
          Sizes{64, 64}); // as many as the computer has room for: it knows that no more come
    CHECK(packets(128, 128) == Sizes{64, 64});
    CHECK(packets(128, 129) == Sizes{64, 64, 0});
    CHECK(packets(0, 10) == Sizes{0});
}

TEST_CASE("that all is done is known once, and only where the device acknowledges")
{
    PretendedController controller;
    ControlPipe pipe;
    pipe.acknowledge(controller);
    controller.of(Endpoint::control_in).given.reset();
    CHECK(pipe.sent(controller));
    CHECK_FALSE(pipe.sent(controller));
}

}
