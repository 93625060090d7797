#pragma once

#include "firmware/settings/image_mark.hpp"
#include "host/config/setting_words.hpp"
#include "host/flash/boot_checksum.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

namespace kfast::test {

/// Bytes that a Pico takes for a firmware for this bus, two sectors and a half.
inline std::vector<std::byte> pretend_image(BusKind bus)
{
    constexpr std::uint32_t size = 10'240;
    std::vector<std::byte> image(size, static_cast<std::byte>(0x40 + static_cast<int>(bus)));
    std::ranges::copy(with_boot_checksum({}), image.begin());
    const ImageMark mark{bus};
    std::ranges::copy(std::as_bytes(std::span{&mark, 1}), image.begin() + ImageMark::place);
    std::ranges::copy(std::as_bytes(std::span{&size, 1}), image.begin() + ImageMark::length_place);
    return image;
}

inline void write_bytes(const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    std::ofstream{path, std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                                static_cast<std::streamsize>(bytes.size()));
}

/// A folder of images for all buses.
class PretendImages {
public:
    PretendImages()
    {
        for (const BusKind bus : {BusKind::spi, BusKind::i2c, BusKind::parallel_8, BusKind::dac})
            write_bytes(file(bus), pretend_image(bus));
    }

    std::filesystem::path file(BusKind bus) const { return folder_ / config::image_name(bus).c_str(); }
    std::vector<std::filesystem::path> folders() const { return {folder_ / "."}; }
    /// A file of that name with such a text.
    std::string text(const char* name, const std::string& content) const
    {
        std::ofstream{folder_ / name} << content;
        return (folder_ / name).string();
    }

private:
    TemporaryFolder folder_;
};

}
