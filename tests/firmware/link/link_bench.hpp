#pragma once

#include "firmware/link/checksum.hpp"
#include "firmware/link/link.hpp"
#include "firmware/link/upload_message.hpp"
#include "tests/firmware/link/pretend_device.hpp"
#include "tests/firmware/slots/slot_bench.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace kfast::test {

using DeviceLink = link::Link<PretendDevice, PretendFlash>;

/// A device with its slots and its end of the link.
struct LinkBench {
    PretendFlash flash{small_flash_bytes};
    Store slots{flash, small_places};
    PretendDevice device;
    DeviceLink link{device, slots};
    Microseconds now{0xFFFF'0000}; // the clock wraps soon

    LinkBench() { device.built_in_scene = padded_scene(2000, 1000); }

    template <class M>
    void send(const M& message, std::uint8_t tag)
    {
        link.take(link::with_checksum(link::report_of(message, tag)).bytes, now);
    }
    /// What is fetched next, which must be an A with the tag.
    template <class A>
    A fetch(std::uint8_t tag)
    {
        const auto report = link.next_report();
        REQUIRE(report);
        REQUIRE(report->tag() == tag);
        REQUIRE(link::is_whole(*report));
        const auto message = link::message_of<A>(*report);
        REQUIRE(message);
        return *message;
    }
    template <class A, class M>
    A ask(const M& message, std::uint8_t tag = 9)
    {
        send(message, tag);
        return fetch<A>(tag);
    }
    template <class M>
    bool does(const M& message)
    {
        ask<link::Done<M::kind>>(message);
        return true;
    }
    /// Why it is not done.
    template <class M>
    StatusWithNumber refusal(const M& message)
    {
        const auto failure = ask<link::Failure>(message);
        CHECK(failure.request == static_cast<std::uint8_t>(M::kind));
        CHECK(failure.text.view() == status_text(failure.status));
        return {failure.status, failure.number};
    }

    void send_blocks(std::span<const std::byte> scene, std::uint8_t tag, std::size_t first = 0,
                     std::size_t count = link::max_blocks)
    {
        const std::size_t end = std::min<std::size_t>(first + count, link::blocks_of(size_of(scene)));
        for (std::size_t number = first; number < end; ++number)
            send(block_of(scene, number), tag);
    }
    /// From begin to commit, as if no report was ever lost.
    StatusWithNumber upload(const link::Begin& begin, std::span<const std::byte> scene, std::uint8_t tag)
    {
        send(begin, tag);
        send_blocks(scene, tag);
        send(link::Commit{}, tag);
        return last_failure();
    }

    static std::uint32_t size_of(std::span<const std::byte> scene)
    {
        return static_cast<std::uint32_t>(scene.size());
    }
    static link::Data block_of(std::span<const std::byte> scene, std::size_t number)
    {
        link::Data data{.block = static_cast<std::uint16_t>(number)};
        const auto rest = scene.subspan(number * link::block_bytes);
        std::ranges::copy(rest.first(std::min(rest.size(), link::block_bytes)), data.bytes.begin());
        return data;
    }
    static link::Begin begin_for_slot(std::uint8_t slot, std::string_view name,
                                      std::span<const std::byte> scene)
    {
        return {link::Home::slot, slot, size_of(scene), crc_of(scene), {name}};
    }
    static link::Begin begin_for_ram(std::span<const std::byte> scene)
    {
        return {link::Home::ram, link::no_slot, size_of(scene), crc_of(scene), {}};
    }

    /// Fetches all that there is; the failure among it.
    StatusWithNumber last_failure()
    {
        StatusWithNumber result;
        while (const auto report = link.next_report())
            if (const auto failure = link::message_of<link::Failure>(*report))
                result = {failure->status, failure->number};
        return result;
    }
    std::uint32_t link_errors() { return ask<link::Statistics>(link::AskStatistics{}).link_errors; }
    void wait(std::uint32_t milliseconds)
    {
        now = now + Microseconds{1000 * milliseconds};
        link.pass(now);
    }
};

}
