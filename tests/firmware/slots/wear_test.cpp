#include "firmware/settings/rp2040_flash.hpp"
#include "tests/firmware/slots/slot_bench.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

constexpr int endurance = 100; ///< a thousandth of what flash is good for

/// Uploads until one is refused for good, with `restarts` before each; how many have succeeded. The last of
/// them is there all the time.
int uploads_until_refusal(PretendFlash flash, const FlashPlaces& places, std::size_t size, bool restarts)
{
    flash.wear_out_after(endurance);
    std::optional<Store> store{std::in_place, flash, places};
    Scene last;
    for (int count = 0;; ++count) {
        if (restarts)
            store.emplace(flash, places);
        const Scene scene = padded_scene(size, static_cast<std::uint32_t>(count));
        Status status = put(*store, 0, "scene", scene);
        if (status == Status::flash_failed) // there may be room once what had to be moved is none any more
            status = put(*store, 0, "scene", scene);
        if (status == Status::ok)
            last = scene;
        REQUIRE(std::ranges::equal(Store{flash, places}.scene(0), last));
        if (status != Status::ok)
            return count;
    }
}

int uploads_to_pico(bool restarts)
{
    return uploads_until_refusal(PretendFlash{rp2040::flash_bytes}, rp2040::slot_places, 700, restarts);
}

}

TEST_CASE("the slots of a Pico take uploads until the directory is worn out")
{
    CHECK(uploads_to_pico(false) == 397); // 4 sectors, one of them for each upload, 3 for the start
    CHECK(uploads_to_pico(true) == 100);  // all 4 for each upload
}

TEST_CASE("a pool takes uploads until all its sectors are worn out")
{
    constexpr int sectors = 4;
    const PretendFlash flash{small_flash_bytes};
    CHECK(uploads_until_refusal(flash, small_places, sectors * sector_bytes, false) ==
          pool_sectors / sectors * endurance);
}

}
