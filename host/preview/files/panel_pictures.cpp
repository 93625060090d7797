#include "host/preview/files/panel_pictures.hpp"

#include "host/file/input_file.hpp"
#include "host/picture/png.hpp"
#include "host/program/failure.hpp"

#include <charconv>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace kfast {
namespace {

namespace fs = std::filesystem;

constexpr InputKind picture_input{"picture", "a .png file", "write it again"};
constexpr std::size_t max_pixels = std::size_t{1} << 26; // 256 MB

std::string in_words(Size size) { return std::to_string(size.width) + 'x' + std::to_string(size.height); }

std::optional<int> frame_of(const fs::path& file)
{
    const std::string name = file.stem().string();
    int frame = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), frame);
    if (file.extension() != ".png" || error != std::errc{} || end != name.data() + name.size() || frame < 0)
        return std::nullopt;
    return frame;
}

Picture picture_of(const fs::path& file)
{
    const std::string bytes = read_input(file, picture_input);
    try {
        return decoded_png(bytes);
    } catch (const Failure& failure) {
        throw Failure(file.string() + ' ' + failure.what());
    }
}

}

PanelPictures::PanelPictures(const fs::path& folder, Size panel)
{
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder, error})
        if (const auto frame = frame_of(entry.path()))
            read(entry.path(), *frame, panel);
    if (error)
        throw Failure("cannot look into the folder " + folder.string() + ": " + error.message());
    if (pictures_.empty())
        throw Failure(
            folder.string() +
            " has no pictures 0000.png, 0001.png ...: \"kfast render --all -o FOLDER\" writes such");
}

void PanelPictures::read(const fs::path& file, int frame, Size panel)
{
    Picture picture = picture_of(file);
    if (picture.size != panel)
        throw Failure(file.string() + " has " + in_words(picture.size) +
                      " pixels and the panel of the preview " + in_words(panel) +
                      ": choose the same one with --panel or --size");
    if ((pictures_.size() + 1) * picture.pixels.size() > max_pixels)
        throw Failure(file.parent_path().string() +
                      " has more pictures than the preview keeps: leave some out");
    pictures_.insert_or_assign(frame, std::move(picture));
}

const Picture& PanelPictures::at(int frame) const
{
    const auto after = pictures_.upper_bound(frame);
    return after == pictures_.begin() ? after->second : std::prev(after)->second;
}

}
