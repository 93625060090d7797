#include "host/program/failure.hpp"
#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("every controller has a model, whose glass is black at first")
{
    for (const ControllerFacts& facts : controller_facts) {
        const auto model = make_controller_model(facts.default_value);
        const Frame picture = model->picture();
        CHECK(picture.format == facts.format);
        CHECK(picture.size == facts.default_value.glass);
        CHECK(picture.pixels.size() == row_bytes(facts.format, facts.default_value.glass.width) *
                                           static_cast<std::size_t>(facts.default_value.glass.height));
        CHECK(std::ranges::all_of(picture.pixels, [](std::byte value) { return value == std::byte{}; }));
    }
}

TEST_CASE("a glass that is larger than the memory is refused")
{
    const auto refused = [](Size glass, int column, int row) {
        CHECK_THROWS_AS(make_controller_model(with_glass(Controller::st7789, glass, column, row)), Failure);
    };
    CHECK(make_controller_model(with_glass(Controller::st7789, {240, 240}, 0, 80)) != nullptr);
    refused({240, 241}, 0, 80);
    refused({240, 240}, 1, 80);
    refused({0, 240}, 0, 0);
    refused({240, 240}, -1, 0);
}

}
