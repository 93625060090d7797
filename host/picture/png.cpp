#include "host/picture/png.hpp"

#include "host/atomic_file.hpp"
#include "host/failure.hpp"

#include <cstdint>
#include <png.h>
#include <vector>

namespace kfast {
namespace {

/// Red, green and blue one after the other.
std::vector<std::uint8_t> channels(const Picture& picture)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * picture.pixels.size());
    for (const Colour pixel : picture.pixels)
        bytes.insert(bytes.end(), {pixel.red, pixel.green, pixel.blue});
    return bytes;
}

std::vector<std::byte> encoded(const Picture& picture)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.size.width);
    image.height = static_cast<png_uint_32>(picture.size.height);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::byte> bytes(size);
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, channels(picture).data(), 0, nullptr) == 0)
        throw Failure(std::string("cannot make a PNG: ") + image.message);
    bytes.resize(size);
    return bytes;
}

}

void write_png(const std::filesystem::path& target, const Picture& picture)
{
    write_file(target, encoded(picture));
}

}
