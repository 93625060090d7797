#include "host/import/import_scene.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <utility>
#include <vector>

namespace kfast::test {

TEST_CASE("an import tells how far it has come, most of all while it is compiled")
{
    std::vector<std::pair<std::size_t, std::size_t>> progress;
    importing::Options options;
    options.on_progress = [&](std::size_t done, std::size_t total) { progress.emplace_back(done, total); };
    const char* const drawing = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"60\" height=\"40\">"
                                "<circle cx=\"20\" cy=\"20\" r=\"8\"/></svg>";
    importing::import_key_drawings({{"one.svg", drawing}, {"two.svg", drawing}}, std::vector<double>{0, 99},
                                   options);
    REQUIRE(progress.size() > 100);
    CHECK(std::ranges::is_sorted(progress));
    CHECK(progress.front().first > 0);
    CHECK(progress.back().first > progress.back().second * 9 / 10);
    for (const auto& [done, total] : progress) {
        CHECK(done <= total);
        CHECK(total == progress.front().second);
    }
}

}
