#pragma once

#include "firmware/usb/controller.hpp"
#include "tests/demand.hpp"
#include "tests/known.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace kfast::usb::test {

using Bytes = std::vector<std::byte>;

/// A unit for USB in which packets lie until the test moves them. It fails where a device breaks the rules of
/// UsbController.
class PretendedController {
public:
    struct EventsOff {
        EventsOff() {}
    };

    struct State {
        bool is_open = false;
        bool is_stalled = false;
        bool is_accepting = false;
        std::optional<Bytes> given{};
        Bytes arrived{};
        int times_opened = 0;
    };

    void open(Endpoint endpoint)
    {
        demand(number_of(endpoint) != 0);
        const int times = of(endpoint).times_opened;
        of(endpoint) = {.is_open = true, .times_opened = times + 1};
    }
    void close(Endpoint endpoint)
    {
        demand(number_of(endpoint) != 0);
        of(endpoint) = {};
    }
    void give(Endpoint endpoint, std::span<const std::byte> packet)
    {
        require_free(endpoint);
        demand(is_in(endpoint));
        demand(packet.size() <= packet_bytes);
        kfast::test::demand_known(packet);
        of(endpoint).given = Bytes{packet.begin(), packet.end()};
    }
    void accept(Endpoint endpoint)
    {
        require_free(endpoint);
        demand(!is_in(endpoint));
        of(endpoint).is_accepting = true;
    }
    std::size_t read(Endpoint endpoint, std::span<std::byte, packet_bytes> place)
    {
        const Bytes& packet = of(endpoint).arrived;
        std::ranges::copy(packet, place.begin());
        return packet.size();
    }
    void stall(Endpoint endpoint)
    {
        of(endpoint).is_stalled = true;
        of(endpoint).is_accepting = false;
        of(endpoint).given.reset();
    }
    void set_address(std::uint8_t value) { address = value; }

    State& of(Endpoint endpoint) { return states[endpoint]; }

    std::map<Endpoint, State> states{{Endpoint::control_in, {.is_open = true}},
                                     {Endpoint::control_out, {.is_open = true}}};
    int address = 0;

private:
    void require_free(Endpoint endpoint)
    {
        demand(of(endpoint).is_open);
        demand(!of(endpoint).is_stalled);
        demand(!of(endpoint).given);
        demand(!of(endpoint).is_accepting);
    }
};

}
