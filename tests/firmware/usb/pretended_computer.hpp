#pragma once

#include "firmware/usb/hid_device.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
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
        REQUIRE(number_of(endpoint) != 0);
        const int times = of(endpoint).times_opened;
        of(endpoint) = {.is_open = true, .times_opened = times + 1};
    }
    void close(Endpoint endpoint)
    {
        REQUIRE(number_of(endpoint) != 0);
        of(endpoint) = {};
    }
    void give(Endpoint endpoint, std::span<const std::byte> packet)
    {
        require_free(endpoint);
        REQUIRE(is_in(endpoint));
        REQUIRE(packet.size() <= packet_bytes);
        of(endpoint).given = Bytes{packet.begin(), packet.end()};
    }
    void accept(Endpoint endpoint)
    {
        require_free(endpoint);
        REQUIRE_FALSE(is_in(endpoint));
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
        REQUIRE(of(endpoint).is_open);
        REQUIRE_FALSE(of(endpoint).is_stalled);
        REQUIRE_FALSE(of(endpoint).given);
        REQUIRE_FALSE(of(endpoint).is_accepting);
    }
};

/// A computer with a device in its plug. What a device refuses is nothing.
class PretendedComputer {
public:
    PretendedComputer() { device.begin({"Maker", "Product", "0123456789ABCDEF"}); }

    void reset()
    {
        controller.states = PretendedController{}.states;
        controller.address = 0;
        device.bus_reset();
    }

    void configure() { REQUIRE(ask(0x0009, 1)); }

    /// A request whose data, if any, come from the device.
    std::optional<Bytes> ask(unsigned kind, unsigned value = 0, unsigned index = 0, unsigned length = 0)
    {
        setup(kind, value, index, length);
        if (length == 0)
            return take_packet(Endpoint::control_in);
        Bytes data;
        while (true) {
            const auto packet = take_packet(Endpoint::control_in);
            if (!packet)
                return {};
            data.insert(data.end(), packet->begin(), packet->end());
            REQUIRE(data.size() <= length);
            if (data.size() == length || packet->size() < packet_bytes)
                break;
        }
        REQUIRE_FALSE(controller.of(Endpoint::control_in).given);
        REQUIRE(put_packet(Endpoint::control_out, {}));
        return data;
    }

    /// A request whose data go to the device.
    bool control_write(unsigned kind, unsigned value, unsigned index, const Bytes& data)
    {
        setup(kind, value, index, static_cast<unsigned>(data.size()));
        return put_packet(Endpoint::control_out, data) &&
               take_packet(Endpoint::control_in) == std::optional{Bytes{}};
    }

    void setup(unsigned kind, unsigned value, unsigned index, unsigned length)
    {
        controller.of(Endpoint::control_in) = {.is_open = true};
        controller.of(Endpoint::control_out) = {.is_open = true};
        const std::array<std::byte, setup_bytes> bytes{high(kind), low(kind),   low(value),  high(value),
                                                       low(index), high(index), low(length), high(length)};
        device.setup(bytes);
    }

    /// Nothing if the device has none.
    std::optional<Bytes> take_packet(Endpoint endpoint)
    {
        auto packet = std::exchange(controller.of(endpoint).given, {});
        if (packet)
            device.sent(endpoint);
        return packet;
    }

    /// False if the device has no room.
    bool put_packet(Endpoint endpoint, const Bytes& packet)
    {
        auto& state = controller.of(endpoint);
        if (!state.is_accepting)
            return false;
        state.is_accepting = false;
        state.arrived = packet;
        device.received(endpoint);
        return true;
    }

    HidDevice<PretendedController> device;
    PretendedController& controller = device.controller();

private:
    static std::byte low(unsigned word) { return static_cast<std::byte>(word); }
    static std::byte high(unsigned word) { return static_cast<std::byte>(word >> 8); }
};

/// Of so many bytes that differ by where they are and by the seed.
inline Bytes packet(int seed, std::size_t size = report_bytes)
{
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<std::byte>(static_cast<std::size_t>(seed) * 31 + i);
    return bytes;
}

inline Report report(int seed, std::size_t size = report_bytes)
{
    Report result{};
    std::ranges::copy(packet(seed, size), result.bytes.begin());
    return result;
}

}
