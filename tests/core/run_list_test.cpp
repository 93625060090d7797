#include "core/run_list.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

TEST_CASE("runs come from left to right, joined where they are nearer than the gap")
{
    RunList runs{3};
    runs.add(10, 12);
    runs.add(20, 25);
    runs.add(14, 15); // two columns from the first
    runs.add(1, 2);
    runs.add(28, 30); // three from the second
    const std::vector<Run> expected{{1, 2}, {10, 15}, {20, 25}, {28, 30}};
    CHECK(std::ranges::equal(runs.runs(), expected));
    CHECK(runs.width() == 13);
}

TEST_CASE("random runs cover what was added, and no more than the nearest gaps besides")
{
    std::mt19937 random{5};
    for (int round = 0; round < 2000; ++round) {
        RunList runs;
        std::vector<bool> wanted(200);
        const auto count = 1 + random() % 30;
        for (unsigned i = 0; i < count; ++i) {
            const int begin = static_cast<int>(random() % 190);
            const int end = begin + 1 + static_cast<int>(random() % 6);
            runs.add(begin, end);
            std::fill(wanted.begin() + begin, wanted.begin() + end, true);
        }
        std::vector<bool> covered(200);
        int last = -1;
        for (const Run run : runs.runs()) {
            CHECK(run.begin > last);
            last = run.end;
            std::fill(covered.begin() + run.begin, covered.begin() + run.end, true);
        }
        std::size_t stretches = 0;
        for (std::size_t x = 0; x < 200; ++x) {
            REQUIRE((covered[x] || !wanted[x]));
            stretches += wanted[x] && (x == 0 || !wanted[x - 1]) ? 1 : 0;
        }
        CHECK(runs.runs().size() <= RunList::most);
        if (stretches <= RunList::most / 2)
            CHECK(covered == wanted);
    }
}

}
}
