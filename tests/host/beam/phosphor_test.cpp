#include "host/beam/phosphor.hpp"

#include <doctest/doctest.h>
#include <set>
#include <tuple>

namespace kfast::test {

TEST_CASE("more light is never darker, none is black, and very much is nearly white")
{
    for (const PhosphorName& name : phosphor_names()) {
        CAPTURE(name.name);
        const Film film{name.value};
        CHECK(film.developed({}) == Colour{0, 0, 0});
        Colour before{0, 0, 0};
        for (float light = 0; light < 20; light = light * 1.01F + 1e-5F) {
            const Colour colour = film.developed({light, light, light});
            CHECK(colour.red >= before.red);
            CHECK(colour.green >= before.green);
            CHECK(colour.blue >= before.blue);
            before = colour;
        }
        CHECK(before.green > 230);
        CHECK(film.developed({1e9F, 1e9F, 1e9F}) == before);
    }
}

TEST_CASE("a phosphor of one colour takes no more colours than a GIF has, without steps where it is dark")
{
    for (const PhosphorName& name : phosphor_names()) {
        const Film film{name.value};
        if (film.channels() == 3)
            continue;
        std::set<std::tuple<int, int, int>> colours;
        int largest_step = 0;
        Colour before = film.developed({});
        for (float light = 0; light < 9; light = light * 1.0005F + 1e-7F) {
            const Colour colour = film.developed({light});
            colours.insert({colour.red, colour.green, colour.blue});
            largest_step = std::max(largest_step, colour.green - before.green);
            before = colour;
        }
        CAPTURE(name.name);
        CHECK(colours.size() <= 256);
        CHECK(colours.size() > 150);
        CHECK(largest_step <= 4);
    }
}

TEST_CASE("a phosphor of one colour shines as bright as the scene's colour, rgb in it")
{
    const Film green{Phosphor::green};
    CHECK(green.light_of({255, 255, 255})[0] == 1);
    CHECK(green.light_of({0, 0, 0})[0] == 0);
    CHECK(green.light_of({0, 255, 0})[0] > green.light_of({255, 0, 0})[0]);
    const Film rgb{Phosphor::rgb};
    CHECK(rgb.light_of({255, 0, 255}) == Light{1, 0, 1});
    const Colour red = rgb.developed(rgb.light_of({255, 0, 0}));
    CHECK(red.red > 220);
    CHECK(red.green < 140);
    CHECK(red.green == red.blue);
}

}
