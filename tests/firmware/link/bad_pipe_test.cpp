#include "tests/firmware/link/bad_pipe.hpp"
#include "tests/firmware/link/link_bench.hpp"
#include "tests/firmware/link/model_host.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

/// Whole uploads over links that lose, repeat, reorder, cut and damage reports.
namespace kfast::test {

using namespace link;

namespace {

/// Lets the computer upload for so many milliseconds, or until it has come to an end. The device is asked for
/// a report in each that `fetches` tells. How long it took.
int upload(LinkBench& bench, ModelHost& host, const Badness& badness, std::uint32_t seed, int milliseconds)
{
    BadPipe there{badness, seed};
    BadPipe back{badness, seed + 1};
    for (int time = 0; time < milliseconds; ++time) {
        if (host.has_ended())
            return time;
        bench.wait(1);
        if (const auto report = host.next_report())
            there.put(*report);
        while (const auto bytes = there.next())
            bench.link.take(*bytes, bench.now);
        if (const auto report = bench.link.next_report())
            back.put(*report);
        while (const auto bytes = back.next()) {
            if (bytes->size() != report_bytes)
                continue; // as the computer's driver would
            Report report;
            std::ranges::copy(*bytes, report.bytes.begin());
            host.take(report);
        }
    }
    return milliseconds;
}

/// What the scene is in the place that `begin` names.
Scene found(LinkBench& bench, const Begin& begin)
{
    if (begin.home == Home::slot)
        return state_of(Store{bench.flash, small_places}).slots[begin.slot].scene;
    bench.last_failure();
    bench.send(Play{.home = Home::ram}, 1);
    return bench.last_failure().is_ok() ? bench.device.ram : Scene{};
}

/// Slots 0, 1 and 3 have scenes, and that of slot 1 is chosen.
constexpr std::array<std::uint8_t, 3> other_slots{0, 1, 3};
Scene other_scene(std::uint8_t slot) { return padded_scene(300, slot); }

void fill_other_slots(LinkBench& bench)
{
    for (const std::uint8_t slot : other_slots) {
        const Scene scene = other_scene(slot);
        REQUIRE(bench.upload(LinkBench::begin_for_slot(slot, "other", scene), scene, 200).is_ok());
    }
    REQUIRE(bench.does(ChooseSlot{.slot = 1}));
}

bool has_other_slots(LinkBench& bench)
{
    const SlotState state = state_of(Store{bench.flash, small_places});
    const auto is_kept = [&](std::uint8_t slot) { return state.slots[slot].scene == other_scene(slot); };
    return state.chosen == 1 && std::ranges::all_of(other_slots, is_kept);
}

struct Counts {
    int right = 0; ///< uploads that succeeded
    int none = 0;  ///< others
};

/// One upload in which anything may happen, for so many milliseconds; then one in which nothing does.
void try_once(std::uint32_t seed, const Badness& badness, int milliseconds, Counts& counts)
{
    CAPTURE(seed);
    LinkBench bench;
    fill_other_slots(bench);
    const Scene old = padded_scene(1500, 7);
    const Scene scene = padded_scene(400 + seed * 37 % 9000, seed);
    const bool is_for_ram = seed % 3 == 0;
    const Begin begin =
        is_for_ram ? LinkBench::begin_for_ram(scene) : LinkBench::begin_for_slot(2, "s", scene);
    if (!is_for_ram)
        REQUIRE(bench.upload(LinkBench::begin_for_slot(2, "old", old), old, 200).is_ok());

    ModelHost host{begin, scene, 1};
    upload(bench, host, badness, seed, milliseconds);
    CHECK(has_other_slots(bench));
    CHECK_FALSE(bench.device.is_in_boot_loader);
    const Scene after = found(bench, begin);
    if (host.has_succeeded())
        CHECK(after == scene);
    else
        CHECK((after == scene || after == old || after.empty()));
    ++(host.has_succeeded() ? counts.right : counts.none);

    const Scene fresh = padded_scene(5000, seed + 1);
    const Begin anew =
        is_for_ram ? LinkBench::begin_for_ram(fresh) : LinkBench::begin_for_slot(2, "f", fresh);
    ModelHost next{anew, fresh, 100};
    upload(bench, next, {}, seed, 1000);
    CHECK(next.has_succeeded());
    CHECK(found(bench, anew) == fresh);
}

Counts try_often(const Badness& badness, int uploads, int milliseconds = 5000)
{
    Counts counts;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(rounds(uploads)); ++seed)
        try_once(seed, badness, milliseconds, counts);
    return counts;
}

}

TEST_CASE("a link that loses nothing never makes the computer wait")
{
    LinkBench bench;
    const Scene scene = padded_scene(30'000, 1);
    ModelHost host{LinkBench::begin_for_slot(0, "a", scene), scene, 1};
    const int blocks = static_cast<int>(blocks_of(30'000));
    CHECK(upload(bench, host, {}, 1, 10'000) <= blocks + 4);
    CHECK(host.has_succeeded());
}

TEST_CASE("a 2 KB scene is in RAM within 40 ms")
{
    LinkBench bench;
    const Scene scene = padded_scene(2048, 1);
    ModelHost host{LinkBench::begin_for_ram(scene), scene, 1};
    CHECK(upload(bench, host, {}, 1, 1000) <= 40);
    CHECK(bench.does(Play{.home = Home::ram}));
    CHECK(bench.device.ram == scene);
}

TEST_CASE("uploads over a link that loses, repeats and reorders reports succeed")
{
    CHECK(try_often({.lost = 20}, 500).none == 0);
    CHECK(try_often({.repeated = 200}, 300).none == 0);
    CHECK(try_often({.overtaken = 100}, 300).none == 0);
    CHECK(try_often({.lost = 10, .repeated = 50, .overtaken = 50, .truncated = 10}, 500).none == 0);
}

TEST_CASE("uploads over a link that damages reports bring the right scene or none")
{
    const Counts damaged = try_often({.damaged = 5}, 700);
    CHECK(damaged.right > rounds(500));
    const Counts all = try_often(
        {.lost = 10, .repeated = 10, .overtaken = 10, .truncated = 5, .damaged = 2, .garbage = 20}, 700);
    CHECK(all.right > rounds(350));
    try_often({.damaged = 100, .garbage = 100}, 10'000, 1000);
    try_often(
        {.lost = 300, .repeated = 300, .overtaken = 300, .truncated = 100, .damaged = 100, .garbage = 300},
        300);
}

}
