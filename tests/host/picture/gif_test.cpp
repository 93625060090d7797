#include "host/picture/gif.hpp"

#include "host/picture/picture.hpp"
#include "host/program/failure.hpp"
#include "tests/host/picture/painted_source.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <gif_lib.h>

namespace kfast::test {
namespace {

struct ReadFrame {
    int centiseconds = 0;
    Picture picture;
};

struct ReadGif {
    std::vector<ReadFrame> frames;
    bool endless = false;
};

bool is_loop(const ExtensionBlock& block)
{
    return block.Function == APPLICATION_EXT_FUNC_CODE && block.ByteCount == 11 &&
           std::string(block.Bytes, block.Bytes + 11) == "NETSCAPE2.0";
}

ReadFrame read_frame(GifFileType* gif, int index)
{
    GraphicsControlBlock control{};
    DGifSavedExtensionToGCB(gif, index, &control);
    const SavedImage& image = gif->SavedImages[index];
    const ColorMapObject* map =
        image.ImageDesc.ColorMap != nullptr ? image.ImageDesc.ColorMap : gif->SColorMap;
    ReadFrame frame{control.DelayTime, {{image.ImageDesc.Width, image.ImageDesc.Height}, {}}};
    for (int i = 0; i < image.ImageDesc.Width * image.ImageDesc.Height; ++i) {
        const GifColorType& colour = map->Colors[image.RasterBits[i]];
        frame.picture.pixels.push_back({colour.Red, colour.Green, colour.Blue});
    }
    return frame;
}

ReadGif read_gif(const std::filesystem::path& path)
{
    ReadGif result;
    GifFileType* gif = DGifOpenFileName(path.c_str(), nullptr);
    REQUIRE(gif != nullptr);
    REQUIRE(DGifSlurp(gif) == GIF_OK);
    for (int i = 0; i < gif->ImageCount; ++i) {
        const SavedImage& image = gif->SavedImages[i];
        result.endless =
            result.endless ||
            std::any_of(image.ExtensionBlocks, image.ExtensionBlocks + image.ExtensionBlockCount, is_loop);
        result.frames.push_back(read_frame(gif, i));
    }
    DGifCloseFile(gif, nullptr);
    return result;
}

ReadGif written(FrameSource& source, const Timeline& timeline)
{
    const TemporaryFolder folder;
    write_gif(folder / "a.gif", source, timeline);
    CHECK(folder.entries() == 1);
    return read_gif(folder / "a.gif");
}

Picture picture_of(FrameSource& source, int frame) { return widen(source.show(Time::frame(frame))); }

int largest_error(const Picture& a, const Picture& b)
{
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        largest = std::max({largest, std::abs(a.pixels[i].red - b.pixels[i].red),
                            std::abs(a.pixels[i].green - b.pixels[i].green),
                            std::abs(a.pixels[i].blue - b.pixels[i].blue)});
    return largest;
}

}

TEST_CASE("a GIF of few colours gives every pixel back, with its delays")
{
    PaintedSource source{{7, 5}, [](int frame, int x, int y) { return (frame + x) * 977 + y * 5; }};
    const ReadGif gif = written(source, {30000, {{}, Time::frame(4), Loop::repeat}});
    REQUIRE(gif.frames.size() == 4);
    for (int i = 0; i < 4; ++i)
        CHECK(gif.frames[static_cast<std::size_t>(i)].picture.pixels == picture_of(source, i).pixels);
    CHECK(gif.frames[0].centiseconds == 3);
    CHECK(gif.frames[2].centiseconds == 4);
}

TEST_CASE("frames of 256 colours are exact even when all together have more")
{
    PaintedSource source{{16, 16}, [](int frame, int x, int y) { return frame * 256 + 16 * y + x; }};
    const ReadGif gif = written(source, {10000, {{}, Time::frame(3), Loop::repeat}});
    for (int i = 0; i < 3; ++i)
        CHECK(gif.frames[static_cast<std::size_t>(i)].picture.pixels == picture_of(source, i).pixels);
}

TEST_CASE("a frame of more colours comes within an eighth of the range")
{
    PaintedSource source{{64, 32}, [](int, int x, int y) { return (x / 2) << 11 | y; }};
    const ReadGif gif = written(source, {10000, {{}, Time::frame(1), Loop::repeat}});
    CHECK(largest_error(gif.frames[0].picture, picture_of(source, 0)) < 256 / 8);
}

TEST_CASE("one colour makes a GIF too")
{
    PaintedSource source{{3, 3}, [](int, int, int) { return 0xFFFF; }};
    CHECK(written(source, {30000, {{}, Time::frame(1), Loop::once}}).frames[1].picture.at(2, 2).green == 255);
}

TEST_CASE("a GIF loops as its scene does")
{
    PaintedSource source{{2, 2}, [](int frame, int, int) { return frame; }};
    CHECK(written(source, {30000, {{}, Time::frame(2), Loop::repeat}}).endless);
    CHECK(written(source, {30000, {{}, Time::frame(2), Loop::ping_pong}}).endless);
    CHECK_FALSE(written(source, {30000, {{}, Time::frame(2), Loop::once}}).endless);
}

TEST_CASE("a GIF that cannot be written is a failure")
{
    PaintedSource source{{2, 2}, [](int frame, int, int) { return frame; }};
    CHECK_THROWS_AS(write_gif("/dev/full", source, {30000, {{}, Time::frame(2), Loop::once}}), Failure);
}

}
