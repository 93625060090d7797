#include "core/raster/outline/contour_cache.hpp"

#include <array>
#include <cstddef>
#include <doctest/doctest.h>
#include <optional>
#include <vector>

namespace kfast::raster::test {
namespace {

using Contour = std::vector<Corner>;

ContourName name_of(std::uint32_t drawing) { return {.drawing = drawing}; }

void keep(ContourCache& cache, const ContourName& name, const std::vector<Contour>& contours)
{
    cache.begin(name);
    for (const Contour& contour : contours)
        cache.add(contour, contour.size() + 2);
    cache.end(true);
}

std::optional<std::vector<Contour>> kept(ContourCache& cache, const ContourName& name)
{
    std::vector<Contour> contours;
    const bool are_kept = cache.each_contour(name, [&](const KeptContour& contour) {
        CHECK(contour.room == contour.corners.size() + 2);
        contours.emplace_back();
        for (const ShortCorner corner : contour.corners)
            contours.back().push_back({corner.x, corner.y});
    });
    return are_kept ? std::optional{contours} : std::nullopt;
}

/// Memory for so many sets of a triangle each, and not for one more.
struct Room {
    static constexpr std::size_t set_bytes = 16 + 4 + 3 * 4;

    explicit Room(std::size_t sets)
        : words(sets * set_bytes / 4 + 1), pictures{std::as_writable_bytes(std::span{words})}
    {
    }

    std::vector<std::uint32_t> words;
    PictureCache pictures;
    ContourCache cache{pictures};
};

const Contour triangle{{0, 0}, {640, -3}, {-32768, 32767}};

TEST_CASE("contours come back as they were kept")
{
    Room room{4};
    const std::vector<Contour> contours{triangle, {}, {{1, 2}, {3, 4}}};
    keep(room.cache, name_of(5), contours);
    CHECK(kept(room.cache, name_of(5)) == contours);
    CHECK_FALSE(kept(room.cache, name_of(6)));
    CHECK_FALSE(kept(room.cache, {.drawing = 5, .half_width = 0}));
    CHECK_FALSE(kept(room.cache, {.drawing = 5, .scale_bits = 1}));
    CHECK_FALSE(kept(room.cache, {.drawing = 5, .pen = 1}));
}

TEST_CASE("what finds no room, lies far away or is not complete is not kept")
{
    Room room{1};
    keep(room.cache, name_of(1), {triangle, triangle});
    CHECK_FALSE(kept(room.cache, name_of(1)));
    keep(room.cache, name_of(2), {{{0, 0}, {32768, 0}, {0, 5}}});
    CHECK_FALSE(kept(room.cache, name_of(2)));
    room.cache.begin(name_of(3));
    room.cache.add(triangle, triangle.size());
    room.cache.end(false);
    CHECK_FALSE(kept(room.cache, name_of(3)));
    room.cache.begin(name_of(3));
    room.cache.add(triangle, 65536);
    room.cache.end(true);
    CHECK_FALSE(kept(room.cache, name_of(3)));
    keep(room.cache, name_of(4), {triangle});
    CHECK(kept(room.cache, name_of(4)));
    PictureCache nothing;
    ContourCache none{nothing};
    keep(none, name_of(1), {triangle});
    CHECK_FALSE(kept(none, name_of(1)));
}

}
}
