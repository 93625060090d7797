#include "host/picture/png.hpp"

#include "host/atomic_file.hpp"
#include "host/failure.hpp"
#include "host/picture/channel_bytes.hpp"

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

void write_png(const std::filesystem::path& target, const Picture& picture)
{
    write_file(target, encoded_png(picture));
}

}
