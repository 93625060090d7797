#include "tests/firmware/slots/first_version.hpp"
#include "tests/firmware/slots/slot_bench.hpp"

#include <doctest/doctest.h>

#include <algorithm>

/// Slots of a board whose firmware had a directory of two sectors and a pool up to the end of what now are
/// four.
namespace kfast::test {
namespace {

void write(PretendFlash& flash, std::uint32_t offset, std::span<const std::byte> bytes)
{
    CHECK(write_sector(flash, offset, bytes));
}

/// Puts `scene` where the former pool ended, and a directory with it in slot 5 into sector `number`.
PretendFlash former_flash(const Scene& scene, std::uint32_t number)
{
    PretendFlash flash{small_flash_bytes};
    const std::uint32_t offset =
        small_places.former_pool_bytes() - whole_sectors(static_cast<std::uint32_t>(scene.size()));
    for (std::uint32_t at = 0; at < scene.size(); at += sector_bytes)
        write(flash, small_places.pool + offset + at,
              std::span{scene}.subspan(at, std::min<std::size_t>(sector_bytes, scene.size() - at)));
    SlotDirectory directory{.generation = 7, .chosen = 5, .next = small_places.former_pool_bytes()};
    directory.slots[5] = {{"old"}, offset, static_cast<std::uint32_t>(scene.size()), crc_of(scene)};
    write(flash, small_places.directory_sector(number), first_version_of(directory));
    --directory.generation;
    directory.chosen = SlotDirectory::none;
    write(flash, small_places.directory_sector(1 - number), first_version_of(directory));
    return flash;
}

}

TEST_CASE("slots of firmware with a directory of two sectors are found")
{
    for (const std::uint32_t number : {0U, 1U}) {
        const Scene scene = padded_scene(3 * sector_bytes, 1);
        PretendFlash flash = former_flash(scene, number);
        Store store{flash, small_places};
        CHECK(store.chosen() == 5);
        CHECK(store.entry(5).name.view() == "old");
        CHECK(std::ranges::equal(store.scene(5), scene));
        CHECK(store.is_whole(5));
        CHECK(store.longest_room({}) == (pool_sectors - 1) * sector_bytes);
    }
}

TEST_CASE("a scene of former firmware in the last sector leaves the one before it to the directory")
{
    PretendFlash flash = former_flash(padded_scene(700, 1), 0);
    Store store{flash, small_places};
    const SlotState before = state_of(store);
    REQUIRE(store.choose(5) == Status::ok);
    const auto times = [&](std::uint32_t copy) {
        return flash.erased_sectors()[small_places.directory_sector(copy) / sector_bytes];
    };
    CHECK(times(2) == 1); // with a copy
    CHECK(times(3) == 1); // with the scene
    CHECK(state_of(store) == before);
}

TEST_CASE("no copy of the directory goes to where a scene of former firmware lies or plays")
{
    for (const std::uint32_t number : {0U, 1U}) {
        const Scene scene = padded_scene(sector_bytes + 1, 1);
        PretendFlash flash = former_flash(scene, number);
        std::optional<Store> store{std::in_place, flash, small_places};
        const auto played = store->scene(5);
        SlotState expected = state_of(*store);
        for (std::uint32_t seed = 0; seed < 5; ++seed) {
            expected.slots[0] = {"new", padded_scene(5000, seed)};
            REQUIRE(put(*store, 0, "new", expected.slots[0].scene) == Status::ok);
            store.emplace(flash, small_places);
            REQUIRE(state_of(*store) == expected);
        }
        REQUIRE(put(*store, 5, "new", padded_scene(5000, 7), played) == Status::ok);
        REQUIRE(store->erase(0) == Status::ok);
        CHECK(std::ranges::equal(played, scene));
        const auto times = [&](std::uint32_t copy) {
            return flash.erased_sectors()[small_places.directory_sector(copy) / sector_bytes];
        };
        CHECK(times(2) == 1); // when it was written
        store.emplace(flash, small_places);
        REQUIRE(store->erase(5) == Status::ok);
        CHECK(times(2) == 2);
        CHECK(times(3) == 2);
    }
}

}
