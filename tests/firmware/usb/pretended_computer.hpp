#pragma once

#include "firmware/usb/hid_device.hpp"
#include "tests/firmware/usb/pretended_controller.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kfast::usb::test {

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
