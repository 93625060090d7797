#include "host/picture/gif.hpp"

#include "host/file/atomic_file.hpp"
#include "host/picture/gif_moment.hpp"
#include "host/picture/palette.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <gif_lib.h>
#include <memory>
#include <optional>
#include <string>

namespace kfast {
namespace {

using Bytes = std::vector<std::byte>;
using ColourMap = std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)>;

int append(GifFileType* gif, const GifByteType* bytes, int count)
{
    const auto all = std::as_bytes(std::span{bytes, static_cast<std::size_t>(count)});
    auto& sink = *static_cast<Bytes*>(gif->UserData);
    sink.insert(sink.end(), all.begin(), all.end());
    return count;
}

void require(bool good)
{
    if (!good)
        throw Failure("cannot make the GIF: not enough memory");
}

/// A GIF map has a power of two of entries; those beyond `colours` stay black and unused.
ColourMap colour_map(const std::vector<Colour>& colours)
{
    const int entries = 1 << GifBitSize(static_cast<int>(colours.size()));
    ColourMap map{GifMakeMapObject(entries, nullptr), GifFreeMapObject};
    require(map != nullptr);
    std::ranges::transform(colours, map->Colors, [](Colour c) {
        return GifColorType{c.red, c.green, c.blue};
    });
    return map;
}

class GifEncoder {
public:
    GifEncoder(Size size, const FilmLimit& limit)
        : size_{size}, limit_{limit}, gif_{EGifOpen(&bytes_, append, nullptr)}
    {
        require(gif_ != nullptr);
        EGifSetGifVersion(gif_, true);
    }
    ~GifEncoder() { close(); }
    GifEncoder(const GifEncoder&) = delete;
    GifEncoder& operator=(const GifEncoder&) = delete;

    void begin(const ColorMapObject* colours, bool endless)
    {
        require(EGifPutScreenDesc(gif_, size_.width, size_.height, 8, 0, colours) == GIF_OK);
        if (endless)
            put_loop();
    }

    void add(const std::vector<std::uint8_t>& indices, const ColorMapObject* colours, int centiseconds)
    {
        put_delay(centiseconds);
        require(EGifPutImageDesc(gif_, 0, 0, size_.width, size_.height, false, colours) == GIF_OK);
        std::vector<GifByteType> copy = indices; // giflib masks the line it is given in place
        for (auto* line = copy.data(); line != copy.data() + copy.size(); line += size_.width)
            require(EGifPutLine(gif_, line, size_.width) == GIF_OK);
        limit_.require(bytes_.size(), "GIF");
    }

    /// Ends the file; nothing may follow.
    const Bytes& finish()
    {
        require(close());
        return bytes_;
    }

private:
    bool close() { return gif_ == nullptr || EGifCloseFile(std::exchange(gif_, nullptr), nullptr) == GIF_OK; }

    // Netscape's extension, which every viewer knows: sub-block 1, repeat 0 (for ever).
    void put_loop()
    {
        constexpr std::array<GifByteType, 3> for_ever{1, 0, 0};
        require(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
                EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0") == GIF_OK &&
                EGifPutExtensionBlock(gif_, for_ever.size(), for_ever.data()) == GIF_OK &&
                EGifPutExtensionTrailer(gif_) == GIF_OK);
    }

    void put_delay(int centiseconds)
    {
        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, centiseconds, NO_TRANSPARENT_COLOR};
        std::array<GifByteType, 4> bytes{};
        EGifGCBToExtension(&control, bytes.data());
        require(EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, bytes.size(), bytes.data()) == GIF_OK);
    }

    Size size_;
    FilmLimit limit_;
    Bytes bytes_;
    GifFileType* gif_;
};

/// None when the pictures have more than 256 colours together.
std::optional<Palette> shared_palette(FrameSource& source, const std::vector<GifMoment>& moments,
                                      const std::function<void()>& on_picture)
{
    Palette palette;
    for (const GifMoment& moment : moments) {
        on_picture();
        if (!palette.add(widen(source.show(moment.time))))
            return std::nullopt;
    }
    return palette;
}

void add_with_own_colours(GifEncoder& encoder, const Picture& picture, int centiseconds)
{
    const IndexedPicture own = indexed(picture);
    encoder.add(own.indices, colour_map(own.colours).get(), centiseconds);
}

}

void write_gif(const std::filesystem::path& target, FrameSource& source, const Timeline& timeline,
               const ProgressCallback& on_progress, const FilmLimit& limit)
{
    const std::vector<GifMoment> moments = gif_moments(timeline);
    const std::size_t steps = 2 * moments.size();
    std::size_t done = 0;
    const std::optional<Palette> palette =
        shared_palette(source, moments, [&] { on_progress(done++, steps); });
    const ColourMap colours = palette ? colour_map(palette->colours()) : ColourMap{nullptr, GifFreeMapObject};
    GifEncoder encoder{source.show(moments.front().time).size, limit};
    encoder.begin(colours.get(), timeline.stretch.loop != Loop::once);
    done = moments.size(); // the search for colours may have ended early
    for (const auto& [time, centiseconds] : moments) {
        on_progress(done++, steps);
        const Picture picture = widen(source.show(time));
        if (palette)
            encoder.add(palette->indices(picture), nullptr, centiseconds);
        else
            add_with_own_colours(encoder, picture, centiseconds);
    }
    write_file(target, encoder.finish());
}

}
