#pragma once

#include "firmware/link/checksum.hpp"
#include "firmware/link/upload_message.hpp"
#include "tests/firmware/link/test_playback_board.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::test {

/// A computer that asks a staged board, with time going on meanwhile.
class PlaybackBench {
public:
    explicit PlaybackBench(const BoardSettings& settings = {}, std::size_t block_bytes = 40'000)
        : board{settings, block_bytes}
    {
        board.pipe.plug_in();
        board.pipe.room = 1000;
    }

    template <class M>
    void send(const M& message, std::uint8_t tag)
    {
        board.pipe.to_device.push_back(link::with_checksum(link::report_of(message, tag)));
    }
    /// The answer, which comes within a frame or two.
    template <class A, class M>
    A ask(const M& message, std::uint8_t tag = 9)
    {
        send(message, tag);
        for (int wait = 0; wait < 200; ++wait) {
            board.run_for(5);
            for (; !board.pipe.to_computer.empty(); board.pipe.to_computer.pop_front()) {
                const Report report = board.pipe.to_computer.front();
                const auto answer = link::message_of<A>(report);
                if (answer && report.tag() == tag) {
                    board.pipe.to_computer.pop_front();
                    return *answer;
                }
                REQUIRE_FALSE((report.tag() == tag && link::message_of<link::Failure>(report)));
            }
        }
        REQUIRE(false);
        return {};
    }
    template <class M>
    void does(const M& message, std::uint8_t tag = 9)
    {
        ask<link::Done<M::kind>>(message, tag);
    }
    template <class M>
    StatusWithNumber refusal(const M& message, std::uint8_t tag = 9)
    {
        const auto failure = ask<link::Failure>(message, tag);
        return {failure.status, failure.number};
    }
    link::Playing playing() { return ask<link::Playing>(link::AskPlaying{}); }

    void begin(const link::Begin& what, std::uint8_t tag) { ask<link::Begun>(what, tag); }
    void send_blocks(const Scene& scene, std::uint8_t tag)
    {
        for (std::size_t number = 0; number < link::blocks_of(static_cast<std::uint32_t>(scene.size()));
             ++number) {
            link::Data data{.block = static_cast<std::uint16_t>(number)};
            const auto rest = std::span{scene}.subspan(number * link::block_bytes);
            std::ranges::copy(rest.first(std::min(rest.size(), link::block_bytes)), data.bytes.begin());
            send(data, tag);
        }
    }
    void upload(const link::Begin& what, const Scene& scene, std::uint8_t tag)
    {
        begin(what, tag);
        send_blocks(scene, tag);
        does(link::Commit{}, tag);
    }
    static link::Begin for_ram(const Scene& scene)
    {
        return {link::Home::ram, link::no_slot, static_cast<std::uint32_t>(scene.size()), crc_of(scene), {}};
    }
    static link::Begin for_slot(std::uint8_t slot, const Scene& scene)
    {
        return {link::Home::slot, slot, static_cast<std::uint32_t>(scene.size()), crc_of(scene), {"scene"}};
    }

    TestPlaybackBoard board;
};

/// The memory that a player of `scene` takes.
inline std::size_t needed(const Scene& scene)
{
    return Player::block_bytes(*SceneView::parse(scene), small_panel);
}

inline bool is_scene(const Scene& begun, const Scene& sent)
{
    return !begun.empty() && begun.size() <= sent.size() &&
           std::equal(begun.begin(), begun.end(), sent.begin());
}

/// Plays `scene` from RAM.
inline void play_from_ram(PlaybackBench& bench, const Scene& scene, std::uint8_t tag = 42)
{
    bench.upload(PlaybackBench::for_ram(scene), scene, tag);
    bench.does(link::Play{.home = link::Home::ram});
}

}
