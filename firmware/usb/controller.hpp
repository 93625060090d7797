#pragma once

#include "firmware/report.hpp"
#include "firmware/usb/endpoint.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::usb {

// Compound requirements would be torn apart.
// clang-format off

/// What HidDevice requires of a chip's unit for USB. The unit counts DATA0 and DATA1 by itself. In return it
/// notifies the device of what happens: bus_reset(), setup(), sent(), received(), suspended() and resumed(),
/// each after it has done what is said here.
///
/// - bus_reset(): the address is 0, and nothing is given, accepted or stalled.
/// - setup(): nothing is given or accepted on the control endpoints any more, neither is stalled, and the next
///   packet of both is DATA1.
/// - sent(): the computer has the packet that was given.
/// - received(): read() has a packet.
template <class C>
concept UsbController =
    requires(C& controller, Endpoint endpoint, std::span<const std::byte> packet,
             std::span<std::byte, packet_bytes> place, std::uint8_t address) {
    /// While one lives, the device is notified of nothing; it is later.
    typename C::EventsOff;

    /// Lets packets pass, the first of them as DATA0. What was given or accepted before is forgotten, and the
    /// endpoint no longer stalled. Not for the control endpoints, which are always open.
    { controller.open(endpoint) } -> std::same_as<void>;
    /// The endpoint is as if it were not there.
    { controller.close(endpoint) } -> std::same_as<void>;

    /// The computer gets this packet, of at most packet_bytes, when it asks. One at a time, and it is copied.
    { controller.give(endpoint, packet) } -> std::same_as<void>;
    /// One packet may come; others wait until this is called again.
    { controller.accept(endpoint) } -> std::same_as<void>;
    /// Copies the packet that came, and returns how many bytes it has.
    { controller.read(endpoint, place) } -> std::same_as<std::size_t>;

    /// Answers everything with STALL: the control endpoints until the next setup(), others until they are opened.
    { controller.stall(endpoint) } -> std::same_as<void>;

    { controller.set_address(address) } -> std::same_as<void>;
};

// clang-format on

}
