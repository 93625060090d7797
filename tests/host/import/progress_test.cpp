#include "host/import/import_scene.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <utility>
#include <vector>

namespace kfast::test {

TEST_CASE("an import tells how far it has come, most of all while it is compiled")
{
    std::vector<std::pair<std::size_t, std::size_t>> told;
    importing::Options options;
    options.tell = [&](std::size_t done, std::size_t total) { told.emplace_back(done, total); };
    const char* const drawing = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"60\" height=\"40\">"
                                "<circle cx=\"20\" cy=\"20\" r=\"8\"/></svg>";
    importing::import_key_drawings({{"one.svg", drawing}, {"two.svg", drawing}}, std::vector<double>{0, 99},
                                   options);
    REQUIRE(told.size() > 100);
    CHECK(std::ranges::is_sorted(told));
    CHECK(told.front().first > 0);
    CHECK(told.back().first > told.back().second * 9 / 10);
    for (const auto& [done, total] : told) {
        CHECK(done <= total);
        CHECK(total == told.front().second);
    }
}

}
