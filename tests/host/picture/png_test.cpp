#include "host/picture/png.hpp"

#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>
#include <png.h>
#include <string>

namespace kfast::test {
namespace {

Picture read_png(const std::filesystem::path& path)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&image, path.c_str()) != 0);
    image.format = PNG_FORMAT_RGBA;
    Picture picture{{static_cast<int>(image.width), static_cast<int>(image.height)}, {}};
    picture.pixels.resize(std::size_t{image.width} * image.height);
    REQUIRE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr) != 0);
    return picture;
}

Picture gradient(Size size)
{
    Picture picture{size, {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            picture.pixels.push_back({static_cast<std::uint8_t>(x * 7), static_cast<std::uint8_t>(y * 5),
                                      static_cast<std::uint8_t>(x ^ y)});
    return picture;
}

}

TEST_CASE("a PNG gives every pixel back")
{
    const TemporaryFolder folder;
    for (const Size size : {Size{1, 1}, Size{3, 2}, Size{37, 41}}) {
        const Picture picture = gradient(size);
        write_png(folder / "a.png", picture);
        const Picture read = read_png(folder / "a.png");
        CHECK(read.size == size);
        CHECK(read.pixels == picture.pixels);
    }
    CHECK(folder.entries() == 1);
}

TEST_CASE("what was encoded is decoded, and what is no PNG is a failure")
{
    const Picture picture = gradient({37, 41});
    const std::vector<std::byte> encoded = encoded_png(picture);
    std::string bytes;
    for (const std::byte byte : encoded)
        bytes += static_cast<char>(byte);
    const Picture decoded = decoded_png(bytes);
    CHECK(decoded.size == picture.size);
    CHECK(decoded.pixels == picture.pixels);
    for (std::size_t length = 0; length < bytes.size() / 2; length += 13) // the very end has no pixels
        CHECK_THROWS_AS(decoded_png(bytes.substr(0, length)), Failure);
    CHECK_THROWS_AS(decoded_png("kfast 1\ncanvas 20 20"), Failure);
    const std::vector<std::byte> wide = encoded_png(gradient({4097, 1}));
    std::string too_wide;
    for (const std::byte byte : wide)
        too_wide += static_cast<char>(byte);
    CHECK_THROWS_WITH_AS(decoded_png(too_wide), "is a PNG of more than 4096 pixels at a side", Failure);
}

TEST_CASE("a PNG that cannot be written is a failure and leaves nothing")
{
    const TemporaryFolder folder;
    CHECK_THROWS_AS(write_png("/dev/full", gradient({9, 9})), Failure);
    CHECK_THROWS_AS(write_png(folder / "no/a.png", gradient({9, 9})), Failure);
    CHECK(folder.entries() == 0);
}

}
