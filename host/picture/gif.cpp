#include "host/picture/gif.hpp"

#include "host/file/atomic_file.hpp"
#include "host/picture/film.hpp"
#include "host/picture/picture.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <gif_lib.h>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace kfast {

namespace {

/// The colours of some pictures, in the order of 0xRRGGBB.
class Palette {
public:
    static constexpr std::size_t max = 256;

    /// Returns false when they would become more than `max`; then the palette is of no use.
    bool add(const Picture& picture);

    std::vector<Colour> colours() const;
    /// Every pixel as an index into colours(). All of them must have been added.
    std::vector<std::uint8_t> indices(const Picture& picture) const;

private:
    std::set<std::uint32_t> words_;
};

/// A picture with a palette of its own.
struct IndexedPicture {
    std::vector<Colour> colours;
    std::vector<std::uint8_t> indices;
};

constexpr std::uint32_t word(Colour colour)
{
    return std::uint32_t{colour.red} << 16 | std::uint32_t{colour.green} << 8 | colour.blue;
}

constexpr Colour colour(std::uint32_t word)
{
    return {static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
            static_cast<std::uint8_t>(word)};
}

std::vector<std::uint8_t> channel(const Picture& picture, std::uint8_t Colour::*member)
{
    std::vector<std::uint8_t> values(picture.pixels.size());
    std::ranges::transform(picture.pixels, values.begin(), member);
    return values;
}

IndexedPicture quantized(const Picture& picture)
{
    std::vector<std::uint8_t> red = channel(picture, &Colour::red);
    std::vector<std::uint8_t> green = channel(picture, &Colour::green);
    std::vector<std::uint8_t> blue = channel(picture, &Colour::blue);
    std::array<GifColorType, Palette::max> map{};
    int count = Palette::max;
    IndexedPicture result{{}, std::vector<std::uint8_t>(picture.pixels.size())};
    if (GifQuantizeBuffer(static_cast<unsigned>(picture.size.width),
                          static_cast<unsigned>(picture.size.height), &count, red.data(), green.data(),
                          blue.data(), result.indices.data(), map.data()) != GIF_OK)
        throw Failure("cannot reduce a picture to 256 colours: not enough memory");
    for (const GifColorType& entry : map)
        result.colours.push_back({entry.Red, entry.Green, entry.Blue});
    return result;
}

bool Palette::add(const Picture& picture)
{
    std::optional<Colour> before; // most pixels are as the one before, and need no search
    for (const Colour pixel : picture.pixels) {
        if (pixel == before)
            continue;
        before = pixel;
        if (words_.insert(word(pixel)).second && words_.size() > max)
            return false;
    }
    return true;
}

std::vector<Colour> Palette::colours() const
{
    std::vector<Colour> list(words_.size());
    std::ranges::transform(words_, list.begin(), colour);
    return list;
}

std::vector<std::uint8_t> Palette::indices(const Picture& picture) const
{
    std::unordered_map<std::uint32_t, std::uint8_t> places;
    for (const std::uint32_t each : words_)
        places.emplace(each, static_cast<std::uint8_t>(places.size()));
    std::vector<std::uint8_t> result;
    result.reserve(picture.pixels.size());
    std::optional<Colour> before;
    for (const Colour pixel : picture.pixels) {
        result.push_back(pixel == before ? result.back() : places.at(word(pixel)));
        before = pixel;
    }
    return result;
}

/// Exact for at most 256 colours, otherwise the nearest of 256 that giflib chooses.
IndexedPicture indexed(const Picture& picture)
{
    Palette palette;
    if (!palette.add(picture))
        return quantized(picture);
    return {palette.colours(), palette.indices(picture)};
}

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

    // Netscape's extension, which every viewer supports: sub-block 1, repeat 0 (for ever).
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
