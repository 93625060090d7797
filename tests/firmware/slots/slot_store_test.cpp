#include "tests/firmware/slots/slot_bench.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

struct Bench {
    PretendFlash flash{small_flash_bytes};
    Store store{flash, small_places};

    /// What a start finds.
    SlotState restarted() { return state_of(Store{flash, small_places}); }
};

/// Where the copy of the directory is that counts.
std::uint32_t newest_copy(const PretendFlash& flash)
{
    std::uint32_t newest = 0;
    std::optional<SlotDirectory> found;
    for (std::uint32_t number = 0; number < FlashPlaces::directory_sectors; ++number) {
        const std::uint32_t place = small_places.directory_sector(number);
        const auto copy = read_slot_directory(flash.contents().subspan(place, sector_bytes),
                                              small_places.former_pool_bytes());
        if (!copy || (found && !is_newer(*copy, *found)))
            continue;
        newest = place;
        found = copy;
    }
    return newest;
}

/// After a start, all of an upload but its last byte.
void begin_upload(PretendFlash& flash, const Scene& scene)
{
    Store store{flash, small_places};
    REQUIRE(store.begin(upload_of(2, "begun", scene), {}).is_ok());
    write_in_pieces(store, std::span{scene}.first(scene.size() - 1));
}

}

TEST_CASE("flash that was never written has empty slots, whatever its bytes are")
{
    PretendFlash flash{small_flash_bytes};
    CHECK(state_of(Store{flash, small_places}) == SlotState{});
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        flash.fill_with(seed);
        CHECK(state_of(Store{flash, small_places}) == SlotState{});
    }
}

TEST_CASE("a scene that was put into a slot is there after a restart")
{
    Bench bench;
    const Scene eyes = padded_scene(9000, 1);
    const Scene walker = padded_scene(700, 2);
    REQUIRE(put(bench.store, 2, "eyes", eyes) == Status::ok);
    REQUIRE(put(bench.store, 7, "walker", walker) == Status::ok);
    SlotState expected;
    expected.slots[2] = {"eyes", eyes};
    expected.slots[7] = {"walker", walker};
    CHECK(state_of(bench.store) == expected);
    CHECK(bench.restarted() == expected);
}

TEST_CASE("replacing, erasing and choosing change nothing else")
{
    Bench bench;
    const Scene first = padded_scene(5000, 1);
    const Scene second = padded_scene(6000, 2);
    put(bench.store, 0, "first", first);
    put(bench.store, 1, "second", second);
    SlotState expected = state_of(bench.store);

    CHECK(bench.store.choose(1) == Status::ok);
    expected.chosen = 1;
    CHECK(bench.restarted() == expected);

    const Scene third = padded_scene(7000, 3);
    CHECK(put(bench.store, 1, "third", third) == Status::ok);
    expected.slots[1] = {"third", third};
    CHECK(bench.restarted() == expected);

    CHECK(bench.store.erase(1) == Status::ok);
    expected.slots[1] = {};
    expected.chosen = {};
    CHECK(bench.restarted() == expected);
    CHECK(bench.store.erase(1) == Status::empty_slot);
    CHECK(bench.store.choose(1) == Status::empty_slot);
    CHECK(bench.store.choose(std::nullopt) == Status::ok);
    CHECK(bench.restarted() == expected);
}

TEST_CASE("a scene for which there is no room is refused, with the room that there is")
{
    Bench bench;
    put(bench.store, 0, "a", padded_scene(5 * sector_bytes, 1));
    const auto refused = upload_of(1, "b", padded_scene(7 * sector_bytes + 1, 2));
    CHECK(bench.store.begin(refused, {}) == StatusWithNumber{Status::no_room, 7 * sector_bytes});
    CHECK(put(bench.store, 1, "b", padded_scene(7 * sector_bytes, 2)) == Status::ok);
    CHECK(bench.store.longest_room({}) == 0);
    // The old scene stays whole while the new one arrives, so there is no room to replace it.
    const SlotState before = state_of(bench.store);
    CHECK(bench.store.begin(upload_of(0, "c", padded_scene(600, 3)), {}) ==
          StatusWithNumber{Status::no_room, 0});
    CHECK(bench.restarted() == before);
}

TEST_CASE("what plays is not written to, though no slot holds it any more")
{
    Bench bench;
    const Scene old = padded_scene(4 * sector_bytes, 1);
    put(bench.store, 0, "old", old);
    const auto played = bench.store.scene(0);
    REQUIRE(bench.store.erase(0) == Status::ok);
    CHECK(bench.store.longest_room({}) == 12 * sector_bytes);
    CHECK(bench.store.longest_room(played) == 8 * sector_bytes);
    for (std::uint32_t seed = 2; seed < 9; ++seed)
        REQUIRE(put(bench.store, 0, "new", padded_scene(3 * sector_bytes, seed), played) == Status::ok);
    CHECK(std::ranges::equal(played, old));
    const auto elsewhere = bench.flash.contents().first(sector_bytes);
    CHECK(bench.store.longest_room(elsewhere) == bench.store.longest_room({}));
    const auto also_behind = bench.flash.contents().subspan(small_places.pool + sector_bytes);
    CHECK(bench.store.longest_room(also_behind) == bench.store.longest_room({})); // no scene is there
}

TEST_CASE("bytes that are not those that were announced are refused, and the slot stays as it was")
{
    Bench bench;
    put(bench.store, 0, "a", padded_scene(5000, 1));
    const SlotState before = state_of(bench.store);
    Scene other = padded_scene(5000, 2);
    REQUIRE(bench.store.begin(upload_of(0, "b", other), {}).is_ok());
    other[4999] ^= std::byte{1};
    write_in_pieces(bench.store, other);
    CHECK(bench.store.finish() == Status::flash_failed); // the link looks at the checksum of what comes
    CHECK(state_of(bench.store) == before);

    SUBCASE("also if they are announced as what the slot holds already")
    {
        Scene same = padded_scene(5000, 1);
        REQUIRE(bench.store.begin(upload_of(0, "a", same), {}).is_ok());
        same[10] ^= std::byte{1};
        write_in_pieces(bench.store, same);
        CHECK(bench.store.finish() == Status::bad_checksum);
    }
    CHECK(bench.restarted() == before);
}

TEST_CASE("what is no scene is refused, and the slot stays as it was")
{
    Bench bench;
    put(bench.store, 0, "a", padded_scene(5000, 1));
    const SlotState before = state_of(bench.store);
    const Scene scene = padded_scene(5000, 2);
    Scene none = scene;
    none[0] = std::byte{'X'};
    CHECK(put(bench.store, 0, "none", none) == Status::bad_magic);
    CHECK(put(bench.store, 1, "short", std::span{scene}.first(5)) == Status::truncated);
    CHECK(bench.restarted() == before);
}

TEST_CASE("what a slot holds already is not written again")
{
    Bench bench;
    const Scene scene = padded_scene(9000, 1);
    put(bench.store, 3, "scene", scene);
    const int before = bench.flash.operations();
    CHECK(put(bench.store, 3, "scene", scene) == Status::ok);
    CHECK(bench.store.choose(std::nullopt) == Status::ok);
    CHECK(bench.flash.operations() == before);

    CHECK(put(bench.store, 3, "other name", scene) == Status::ok);
    CHECK(bench.flash.operations() == before + 3); // the directory: a sector, two pages
    CHECK(bench.restarted().slots[3] == SlotState::Slot{"other name", scene});
}

TEST_CASE("a scene whose flash has lost a bit is written anew")
{
    Bench bench;
    const Scene scene = padded_scene(9000, 1);
    put(bench.store, 3, "scene", scene);
    bench.flash.damage(small_places.pool + 5000);
    CHECK(put(bench.store, 3, "scene", scene) == Status::ok);
    CHECK(bench.restarted().slots[3].scene == scene);
}

TEST_CASE("sectors that hold what they are to hold are neither erased nor programmed")
{
    Bench bench;
    const Scene scene = padded_scene(5 * sector_bytes, 1);
    REQUIRE(bench.store.begin(upload_of(0, "a", scene), {}).is_ok());
    write_in_pieces(bench.store,
                    std::span{scene}.first(3 * sector_bytes + 100)); // and then the cable is pulled
    CHECK(bench.flash.erased() == 3 + 3);                            // with copies of the directory as it was
    REQUIRE(put(bench.store, 0, "a", scene) == Status::ok);
    CHECK(bench.flash.erased() == 5 + 4);
    CHECK(bench.flash.operations() == 5 * 17 + 4 * 3);
}

TEST_CASE("uploads wear the sectors of the pool alike")
{
    Bench bench;
    put(bench.store, 0, "stays", padded_scene(2 * sector_bytes, 1));
    for (std::uint32_t seed = 2; seed < 302; ++seed)
        REQUIRE(put(bench.store, 1, "changes", padded_scene(sector_bytes + 100, seed)) == Status::ok);
    const auto& erased = bench.flash.erased_sectors();
    const auto free = std::span{erased}.subspan(3 + 2, pool_sectors - 2);
    CHECK(*std::ranges::min_element(free) >= 60);
    CHECK(*std::ranges::max_element(free) <= 60);
    for (std::uint32_t number = 0; number < FlashPlaces::directory_sectors; ++number) {
        const int times = erased[small_places.directory_sector(number) / sector_bytes];
        CHECK(times == 304 / 4);
    }
    CHECK(erased[3] == 1); // what stays
    CHECK(erased.front() == 0);
    CHECK(erased.back() == 0);
}

TEST_CASE("where the wear goes on is not forgotten by a restart")
{
    PretendFlash flash{small_flash_bytes};
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        Store store{flash, small_places};
        REQUIRE(put(store, 0, "changes", padded_scene(600, seed)) == Status::ok);
    }
    const auto pool = std::span{flash.erased_sectors()}.subspan(3, pool_sectors);
    CHECK(*std::ranges::max_element(pool) <= 11);
    CHECK(*std::ranges::min_element(pool) >= 9);
}

TEST_CASE("the older copy of the directory counts when the newer one is damaged")
{
    Bench bench; // the first change is written behind three copies of what was before
    put(bench.store, 0, "a", padded_scene(700, 1));
    const SlotState one = state_of(bench.store);
    put(bench.store, 1, "b", padded_scene(700, 2));
    const SlotState two = state_of(bench.store);
    PretendFlash older_damaged = bench.flash;
    older_damaged.damage(small_places.directory_sector(3) + 100);
    CHECK(state_of(Store{older_damaged, small_places}) == two);
    PretendFlash newer_damaged = bench.flash;
    newer_damaged.damage(small_places.directory_sector(0) + 100);
    CHECK(state_of(Store{newer_damaged, small_places}) == one);
}

TEST_CASE(
    "the first change after a start writes three copies of the directory as it was, and later ones none")
{
    PretendFlash flash{small_flash_bytes};
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        Store store{flash, small_places};
        const int before = flash.operations();
        REQUIRE(put(store, 0, "a", padded_scene(700, seed)) == Status::ok);
        CHECK(flash.operations() == before + 4 * 3 + 4);
        REQUIRE(store.choose(0) == Status::ok);
        REQUIRE(store.choose(std::nullopt) == Status::ok);
        CHECK(flash.operations() == before + 6 * 3 + 4);
    }
    Store store{flash, small_places};
    const int before = flash.operations();
    CHECK(store.choose(std::nullopt) == Status::ok); // which is no change, but must not rest on an old copy
    CHECK(flash.operations() == before + 3 * 3);
    CHECK(store.choose(std::nullopt) == Status::ok);
    CHECK(flash.operations() == before + 3 * 3);
}

TEST_CASE("a copy of the directory that is read rightly at one start and wrongly at the next loses no slot")
{
    for (std::uint8_t steps = 0; steps < FlashPlaces::directory_sectors; ++steps) {
        PretendFlash flash{small_flash_bytes};
        {
            Store store{flash, small_places};
            REQUIRE(put(store, 0, "old", padded_scene(3 * sector_bytes, 1)) == Status::ok);
            REQUIRE(put(store, 1, "stays", padded_scene(5 * sector_bytes, 2)) == Status::ok);
            for (std::uint8_t step = 0; step < steps; ++step)
                REQUIRE(store.choose(step % 2) == Status::ok);
            REQUIRE(put(store, 0, "new", padded_scene(3 * sector_bytes, 3)) == Status::ok);
        }
        const SlotState made = state_of(Store{flash, small_places});
        const std::uint32_t newest = newest_copy(flash);
        begin_upload(flash, padded_scene(3 * sector_bytes, 4)); // goes where the old scene was
        flash.damage(newest + 100);
        CHECK(state_of(Store{flash, small_places}) == made);
    }
}

TEST_CASE("copies of the directory during which power was cut, start for start, do not come back later")
{
    PretendFlash flash{small_flash_bytes};
    {
        Store store{flash, small_places};
        REQUIRE(put(store, 0, "old", padded_scene(3 * sector_bytes, 1)) == Status::ok);
        REQUIRE(put(store, 1, "stays", padded_scene(5 * sector_bytes, 2)) == Status::ok);
    }
    const SlotState old = state_of(Store{flash, small_places});
    std::vector<std::uint32_t> doubtful;
    {
        Store store{flash, small_places};
        REQUIRE(put(store, 0, "new", padded_scene(3 * sector_bytes, 3)) == Status::ok);
        doubtful.push_back(newest_copy(flash));
    }
    for (int start = 0; start < 2; ++start) { // each of them reads the copy before rightly
        Store store{flash, small_places};
        flash.cut(3, Remains::nothing_done, 1);
        CHECK_THROWS_AS(store.choose(1), PowerCut);
        doubtful.push_back(newest_copy(flash));
    }
    flash.power_again();
    for (const std::uint32_t copy : doubtful)
        flash.damage(copy + 100);
    REQUIRE(state_of(Store{flash, small_places}) == old);
    begin_upload(flash, padded_scene(4 * sector_bytes, 4)); // goes where the new scene was
    flash.damage(doubtful.back() + 100);
    CHECK(state_of(Store{flash, small_places}) == old);
}

}
