#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

namespace kfast::test {

// Runs in the root of the repository.
TEST_CASE("the first example has no mistakes and no seam")
{
    std::ifstream file{"examples/first-light.kfast"};
    REQUIRE(file);
    const auto [scene, findings] = read(std::string{std::istreambuf_iterator{file}, {}});
    REQUIRE(scene);
    CHECK(findings == "");
    CHECK(scene->length == Time::frame(60));
    for (const scene::Item& item : scene->items) {
        const auto& object = std::get<scene::Object>(item.content);
        CHECK((object.keys.size() == 1 || object.keys.back().time == scene->length));
        CHECK(object.keys.back().drawing == object.keys.front().drawing);
    }
}

}
