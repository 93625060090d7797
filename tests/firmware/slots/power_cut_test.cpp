#include "tests/firmware/slots/slot_bench.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <utility>

namespace kfast::test {
namespace {

/// Something that changes what the slots hold.
struct Change {
    const char* name;
    std::function<Status(Store&)> make;
};

std::vector<Change> changes()
{
    return {
        {"upload into an empty slot", [](Store& s) { return put(s, 4, "new", padded_scene(6000, 9)); }},
        {"replace", [](Store& s) { return put(s, 1, "replaced", padded_scene(9000, 8)); }},
        {"replace what is chosen", [](Store& s) { return put(s, 0, "other", padded_scene(4096, 7)); }},
        {"rename", [](Store& s) { return put(s, 0, "renamed", padded_scene(9000, 1)); }},
        {"erase", [](Store& s) { return s.erase(1); }},
        {"erase what is chosen", [](Store& s) { return s.erase(0); }},
        {"choose", [](Store& s) { return s.choose(1); }},
        {"choose the built-in scene", [](Store& s) { return s.choose(std::nullopt); }},
    };
}

/// Flash with two scenes of which the first is chosen; the newer copy of the directory is the second or, if
/// `is_odd`, the first. What is free holds remains of others.
PretendFlash used_flash(bool is_odd)
{
    PretendFlash flash{small_flash_bytes};
    flash.fill_with(5);
    Store store{flash, small_places};
    put(store, 0, "zero", padded_scene(9000, 1));
    put(store, 1, "one", padded_scene(5000, 2));
    store.choose(0);
    if (is_odd)
        put(store, 1, "first", padded_scene(5000, 2));
    return flash;
}

struct Cut {
    int operation = 0;
    Remains remains = Remains::nothing_done;
    std::uint32_t seed = 0;
};

/// Whether power went before the change was made.
bool goes_dark(PretendFlash& flash, const Change& change, const Cut& cut)
{
    Store store{flash, small_places};
    flash.cut(cut.operation, cut.remains, cut.seed);
    try {
        const Status status = change.make(store);
        flash.power_again();
        REQUIRE(status == Status::ok);
        return false;
    } catch (const PowerCut&) {
        flash.power_again();
        return true;
    }
}

struct Expected {
    SlotState old;
    SlotState made;
};

/// After a cut all is as it was or as it was to be, and making the change once more makes it. Power may go in
/// that as well.
void expect_one_of_both(PretendFlash flash, const Change& change, const Expected& expected, bool cuts_again)
{
    const SlotState found = state_of(Store{flash, small_places});
    const bool is_either = found == expected.old || found == expected.made;
    REQUIRE_MESSAGE(is_either, change.name);
    for (int operation = 0; cuts_again; operation += 3) {
        PretendFlash again = flash;
        cuts_again = goes_dark(again, change, {operation, Remains::random_bits, 77});
        expect_one_of_both(again, change, expected, false);
    }
    Store store{flash, small_places};
    if (found == expected.old)
        REQUIRE(change.make(store) == Status::ok);
    CHECK(state_of(Store{flash, small_places}) == expected.made);
}

/// Cuts power in every operation of the change; how many there are.
int cut_everywhere(const PretendFlash& flash, const Change& change, Remains remains, std::uint32_t seed)
{
    Expected expected;
    {
        PretendFlash whole = flash;
        expected.old = state_of(Store{whole, small_places});
        CHECK_FALSE(goes_dark(whole, change, {1 << 20}));
        expected.made = state_of(Store{whole, small_places});
        REQUIRE(expected.old != expected.made);
    }
    int operation = 0;
    for (;; ++operation) {
        PretendFlash cut = flash;
        const bool was_cut = goes_dark(cut, change, {operation, remains, seed});
        if (!was_cut)
            return operation;
        expect_one_of_both(cut, change, expected, operation % 5 == 0);
    }
}

}

TEST_CASE("whenever power is cut, the slots are as they were or as they were to be")
{
    for (const bool is_odd : {false, true}) {
        const PretendFlash flash = used_flash(is_odd);
        for (const Change& change : changes()) {
            CHECK(cut_everywhere(flash, change, Remains::nothing_done, 0) >= 3);
            CHECK(cut_everywhere(flash, change, Remains::half, 0) >= 3);
            for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(rounds(3)); ++seed) {
                CHECK(cut_everywhere(flash, change, Remains::random_bits, seed) >= 3);
                CHECK(cut_everywhere(flash, change, Remains::some_bits, seed) >= 3);
            }
        }
    }
}

TEST_CASE("whenever power is cut in the very first upload, there is nothing or all of it")
{
    PretendFlash flash{small_flash_bytes};
    const Change first{"first", [](Store& s) { return put(s, 0, "first", padded_scene(4097, 3)); }};
    for (const Remains remains :
         {Remains::nothing_done, Remains::random_bits, Remains::some_bits, Remains::half})
        CHECK(cut_everywhere(flash, first, remains, 4) == 2 + 17 + 4 * 3);
}

}
