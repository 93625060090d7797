#include "tests/firmware/slots/slot_history.hpp"
#include "tests/rounds.hpp"

namespace kfast::test {
namespace {

constexpr int histories = 50'000;

void run_histories(bool is_fickle)
{
    std::uint64_t cuts = 0;
    std::uint64_t bad_sectors = 0;
    for (int number = 0; number < rounds(histories); ++number) {
        CAPTURE(number);
        SlotHistory history{static_cast<std::uint32_t>(number), is_fickle};
        for (int step = 0; step < 4; ++step)
            history.change();
        history.expect_bad_sectors_at_rest();
        cuts += history.cuts();
        bad_sectors += history.bad_sectors();
    }
    CHECK(cuts > static_cast<std::uint64_t>(rounds(histories)) / 2);
    CHECK(bad_sectors > static_cast<std::uint64_t>(rounds(histories)));
}

}

TEST_CASE("in random histories with power cuts and bad sectors, slots are as they were or as they were to be")
{
    run_histories(false);
}

TEST_CASE("in random histories, what a power cut leaves may be read differently at each start")
{
    run_histories(true);
}

}
