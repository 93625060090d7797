#include "host/config/firmware_images.hpp"
#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;
using Folders = std::vector<fs::path>;

}

TEST_CASE("images are looked for where kfast is installed or was built")
{
    CHECK(config::image_folders(nullptr, "/usr/local/bin/kfast") ==
          Folders{"/usr/local/share/kfast/firmware", "/usr/pico"});
    CHECK(config::image_folders(nullptr, "/home/somebody/kfast/build/host/bin/kfast") ==
          Folders{"/home/somebody/kfast/build/host/share/kfast/firmware", "/home/somebody/kfast/build/pico"});
    CHECK(config::image_folders("", "/usr/bin/kfast").size() == 2);
    CHECK(config::image_folders(nullptr, std::nullopt).empty());
}

TEST_CASE("a folder that is named is the only one")
{
    CHECK(config::image_folders("images", "/usr/local/bin/kfast") == Folders{"images"});
}

TEST_CASE("the first folder that has the image of the bus is taken")
{
    const test::TemporaryFolder folder;
    const Folders folders{folder / "none", folder / "one", folder / "two"};
    fs::create_directories(folders[1] / "pico-spi.bin"); // no file
    fs::create_directory(folders[2]);
    for (const auto* name : {"pico-spi.bin", "pico-i2c.bin"})
        std::ofstream{folders[2] / name} << 'x';
    CHECK(config::image_for(BusKind::spi, folders) == folders[2] / "pico-spi.bin");
    std::ofstream{folders[1] / "pico-i2c.bin"} << 'x';
    CHECK(config::image_for(BusKind::i2c, folders) == folders[1] / "pico-i2c.bin");
    CHECK_THROWS_WITH_AS(
        config::image_for(BusKind::parallel_8, folders),
        ("there is no pico-parallel.bin in " + folders[0].string() + " and in " + folders[1].string() +
         " and in " + folders[2].string() +
         ": build it with 'scripts/build pico', or name a firmware with --firmware FILE, or the folder of "
         "all images with KFAST_FIRMWARE=FOLDER; --no-firmware leaves what the board has")
            .c_str(),
        Failure);
}

TEST_CASE("an image is called by where it is installed, or else by where it is built")
{
    const test::TemporaryFolder folder;
    const Folders folders{folder / "installed", folder / "built"};
    for (const fs::path& place : folders) {
        CHECK(config::image_of(BusKind::spi, folders) == "build/pico/pico-spi.bin");
        fs::create_directory(place);
    }
    std::ofstream{folders[1] / "pico-spi.bin"} << 'x';
    CHECK(config::image_of(BusKind::spi, folders) == "build/pico/pico-spi.bin");
    std::ofstream{folders[0] / "pico-spi.bin"} << 'x';
    CHECK(config::image_of(BusKind::spi, folders) == folders[0] / "pico-spi.bin");
    CHECK(config::image_of(BusKind::i2c, {}) == "build/pico/pico-i2c.bin");
}

}
