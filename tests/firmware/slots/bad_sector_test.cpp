#include "tests/firmware/slots/slot_bench.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>

namespace kfast::test {
namespace {

/// Flash that was used by others, and slots in it.
struct Bench {
    PretendFlash flash = used_flash();
    std::optional<Store> store;

    Bench() { restart(); }
    void restart() { store.emplace(flash, small_places); }

    static PretendFlash used_flash()
    {
        PretendFlash flash{small_flash_bytes};
        flash.fill_with(5);
        return flash;
    }
    void spoil_directory(std::initializer_list<std::uint32_t> numbers, Fault fault)
    {
        for (const std::uint32_t number : numbers)
            flash.spoil(small_places.directory_sector(number), fault);
    }
    int times_erased(std::uint32_t offset) const { return flash.erased_sectors()[offset / sector_bytes]; }
};

constexpr std::uint32_t pool_sector(std::uint32_t number)
{
    return small_places.pool + number * sector_bytes;
}

/// What goes round the pool more than once, with a restart between any two.
SlotState upload_for_long(Bench& bench)
{
    SlotState expected = state_of(*bench.store);
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const Scene scene = padded_scene(700 + 1000 * (seed % 5), seed);
        const auto slot = static_cast<std::uint8_t>(seed % 2);
        REQUIRE(put(*bench.store, slot, "scene", scene) == Status::ok);
        expected.slots[slot] = {"scene", scene};
        REQUIRE(state_of(*bench.store) == expected);
        bench.restart();
        REQUIRE(state_of(*bench.store) == expected);
    }
    return expected;
}

}

TEST_CASE("a sector of the pool that does not hold is not used again, nor after a restart")
{
    for (const Fault fault : every_fault)
        for (std::uint32_t number = 0; number < pool_sectors; ++number) {
            Bench bench;
            bench.flash.spoil(pool_sector(number), fault);
            upload_for_long(bench);
            CHECK(bench.times_erased(pool_sector(number)) == 1);
        }
}

TEST_CASE("uploads succeed as long as the pool has room besides its bad sectors")
{
    for (const Fault fault : every_fault) {
        Bench bench;
        for (const std::uint32_t number : {0U, 2U, 3U, 5U, 8U, 11U})
            bench.flash.spoil(pool_sector(number), fault);
        const Scene longest = padded_scene(2 * sector_bytes, 1);
        REQUIRE(put(*bench.store, 0, "one", padded_scene(100, 2)) == Status::ok);
        REQUIRE(put(*bench.store, 1, "two", longest) == Status::ok);
        REQUIRE(put(*bench.store, 2, "three", longest) == Status::ok);
        CHECK(state_of(*bench.store).slots[2].scene == longest);
        // All that is left: what was not written yet may be bad.
        for (int i = 0; i < 3; ++i)
            put(*bench.store, 3, "four", longest);
        CHECK(put(*bench.store, 3, "four", padded_scene(100, 2)) == Status::ok);
        bench.restart();
        CHECK(bench.store->longest_room({}) == 0);
        CHECK(put(*bench.store, 4, "five", padded_scene(100, 3)) == Status::no_room);
    }
}

TEST_CASE("a bad sector is remembered, even if the upload that has met it never ends")
{
    Bench bench;
    bench.flash.spoil(pool_sector(1), Fault::program_does_nothing);
    const Scene scene = padded_scene(2 * sector_bytes + 100, 1);
    REQUIRE(bench.store->begin(upload_of(0, "never", scene), {}).is_ok());
    write_in_pieces(*bench.store, std::span{scene}.first(2 * sector_bytes));
    bench.restart();
    CHECK(bench.store->longest_room({}) == (pool_sectors - 2) * sector_bytes);
    CHECK(put(*bench.store, 0, "now", scene) == Status::ok);
    CHECK(bench.times_erased(pool_sector(1)) == 1);
}

TEST_CASE("an upload moves also to where it overlaps what of it was written")
{
    for (const Fault fault : every_fault) {
        Bench bench;
        REQUIRE(put(*bench.store, 0, "stays", padded_scene(8 * sector_bytes, 1)) == Status::ok);
        REQUIRE(put(*bench.store, 1, "goes", padded_scene(sector_bytes, 2)) == Status::ok);
        REQUIRE(bench.store->erase(1) == Status::ok);
        bench.flash.spoil(pool_sector(11), fault);
        const Scene scene = padded_scene(3 * sector_bytes, 3);
        REQUIRE(put(*bench.store, 1, "moves", scene) == Status::ok);
        CHECK(bench.store->entry(1).offset == 8 * sector_bytes);
        CHECK(std::ranges::equal(bench.store->scene(1), scene));
    }
}

TEST_CASE("an upload that moves does not go where something plays, though no slot holds it any more")
{
    for (const bool is_held : {false, true}) {
        Bench bench;
        const Scene old = padded_scene(3 * sector_bytes, 1);
        REQUIRE(put(*bench.store, 0, "other", padded_scene(5 * sector_bytes, 2)) == Status::ok);
        REQUIRE(put(*bench.store, 1, "plays", old) == Status::ok);
        const auto played = bench.store->scene(1);
        if (is_held)
            REQUIRE(bench.store->erase(1) == Status::ok);
        bench.flash.spoil(pool_sector(9), Fault::program_error);
        const Scene scene = padded_scene(2 * sector_bytes, 3);
        REQUIRE(
            bench.store->begin(upload_of(2, "moves", scene), is_held ? played : std::span<const std::byte>{})
                .is_ok());
        if (!is_held)
            REQUIRE(bench.store->erase(1) == Status::ok);
        write_in_pieces(*bench.store, scene);
        CHECK(bench.store->finish() == Status::ok);
        CHECK(bench.store->entry(2).offset == 10 * sector_bytes);
        bench.flash.spoil(pool_sector(0), Fault::program_error);
        CHECK(std::ranges::equal(played, old));
    }
}

TEST_CASE("an upload that finds no other place than that of what plays fails")
{
    Bench bench;
    const Scene old = padded_scene(10 * sector_bytes, 1);
    REQUIRE(put(*bench.store, 1, "plays", old) == Status::ok);
    const auto played = bench.store->scene(1);
    bench.flash.spoil(pool_sector(11), Fault::erase_does_nothing);
    const Scene scene = padded_scene(2 * sector_bytes, 3);
    REQUIRE(bench.store->begin(upload_of(2, "new", scene), {}).is_ok());
    REQUIRE(bench.store->erase(1) == Status::ok);
    write_in_pieces(*bench.store, scene);
    CHECK(bench.store->finish() == Status::flash_failed);
    CHECK(std::ranges::equal(played, old));
    CHECK(put(*bench.store, 2, "new", scene, played) == Status::no_room);
    CHECK(put(*bench.store, 2, "new", scene) == Status::ok);
}

TEST_CASE("an upload that meets a bad sector fails where the directory cannot remember it")
{
    Bench bench;
    const Scene old = padded_scene(700, 1);
    REQUIRE(put(*bench.store, 1, "old", old) == Status::ok);
    const SlotState before = state_of(*bench.store);
    const Scene scene = padded_scene(3 * sector_bytes, 2);
    bench.flash.spoil(pool_sector(2), Fault::program_does_nothing);
    REQUIRE(bench.store->begin(upload_of(1, "new", scene), {}).is_ok());
    bench.spoil_directory({0, 1, 2, 3}, Fault::program_does_nothing);
    write_in_pieces(*bench.store, scene);
    CHECK(bench.store->finish() == Status::flash_failed);
    CHECK(state_of(*bench.store) == before);
    CHECK(bench.times_erased(pool_sector(3)) == 0); // it has not moved
    bench.restart();
    CHECK(state_of(*bench.store) == before);
}

TEST_CASE("two bad sectors of the directory do not stop changes, and are not used again")
{
    for (const Fault fault : every_fault)
        for (std::uint32_t first = 0; first < FlashPlaces::directory_sectors; ++first)
            for (std::uint32_t second = 0; second < first; ++second) {
                Bench bench;
                bench.spoil_directory({first, second}, fault);
                upload_for_long(bench);
                for (const std::uint32_t number : {first, second})
                    CHECK(bench.times_erased(small_places.directory_sector(number)) == 1);
            }
}

TEST_CASE("a sector of the directory that turns bad loses nothing, until the last but one does")
{
    for (const Fault fault : every_fault) {
        Bench bench;
        SlotState expected = upload_for_long(bench);
        for (const std::uint32_t number : {2U, 0U}) {
            bench.spoil_directory({number}, fault);
            expected = upload_for_long(bench);
        }
        bench.spoil_directory({1}, fault);
        for (int i = 0; i < 3; ++i) {
            const Scene scene = padded_scene(700, 100);
            const Status status = put(*bench.store, 1, "no more", scene);
            if (status == Status::ok) // the bad sector has the newest copy, and the other one took this
                expected.slots[1] = {"no more", scene};
            else
                CHECK(status == Status::flash_failed);
            bench.restart();
            CHECK(state_of(*bench.store) == expected);
        }
        CHECK(put(*bench.store, 2, "none", padded_scene(700, 101)) == Status::flash_failed);
        CHECK(bench.store->erase(1) == Status::flash_failed);
        bench.restart();
        CHECK(state_of(*bench.store) == expected);
    }
}

}
