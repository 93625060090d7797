#include "host/import/import_scene.hpp"
#include "host/program/failure.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a command without importers says how to build them")
{
    constexpr const char* words = "scripts/build command adds it";
    CHECK_THROWS_WITH_AS(importing::import_scene("ball.json", "{}", {}), doctest::Contains(words), Failure);
    CHECK_THROWS_WITH_AS(importing::import_scene("ball.json", "{}", {}), doctest::Contains("ball.json: "),
                         Failure);
    CHECK_THROWS_WITH_AS(importing::import_key_drawings({SourceText{"a.svg", "<svg/>"}}, {}, {}),
                         doctest::Contains("a.svg: "), Failure);
}

}
