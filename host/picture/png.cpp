#include "host/picture/png.hpp"

#include "host/file/atomic_file.hpp"
#include "host/picture/picture.hpp"
#include "host/program/failure.hpp"

#include <cstdint>
#include <memory>
#include <png.h>
#include <string>

namespace kfast {

std::vector<std::byte> encoded_png(const Picture& picture)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.size.width);
    image.height = static_cast<png_uint_32>(picture.size.height);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::byte> bytes(size);
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, channel_bytes(picture).data(), 0,
                                  nullptr) == 0)
        throw Failure(std::string("cannot make a PNG: ") + image.message);
    bytes.resize(size);
    return bytes;
}

Picture decoded_png(std::string_view bytes)
{
    constexpr png_uint_32 max_side = 4096;
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
        throw Failure(std::string("is no PNG: ") + image.message);
    const std::unique_ptr<png_image, void (*)(png_image*)> reading{&image, &png_image_free};
    if (image.width > max_side || image.height > max_side)
        throw Failure("is a PNG of more than " + std::to_string(max_side) + " pixels at a side");
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> channels(PNG_IMAGE_SIZE(image));
    const png_color below{0, 0, 0};
    if (png_image_finish_read(&image, &below, channels.data(), 0, nullptr) == 0)
        throw Failure(std::string("is a damaged PNG: ") + image.message);
    Picture picture{{static_cast<int>(image.width), static_cast<int>(image.height)}, {}};
    picture.pixels.reserve(channels.size() / 3);
    for (std::size_t at = 0; at < channels.size(); at += 3)
        picture.pixels.push_back({channels[at], channels[at + 1], channels[at + 2]});
    return picture;
}

void write_png(const std::filesystem::path& target, const Picture& picture, Sync sync)
{
    write_file(target, encoded_png(picture), sync);
}

}
