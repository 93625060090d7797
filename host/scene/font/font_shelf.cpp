#include "host/scene/font/font_shelf.hpp"

#include "host/file/input_file.hpp"
#include "host/fonts/dejavu_faces.hpp"
#include "host/program/failure.hpp"
#include "host/scene/font/hershey_font.hpp"
#include "host/scene/font/outline_font.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <vector>

namespace kfast::scene {

namespace {

struct FilledFace {
    std::string_view name;
    std::string_view (*file)();
};

constexpr std::array filled_faces{
    FilledFace{"dejavu-sans", dejavu_sans},
    FilledFace{"dejavu-sans-bold", dejavu_sans_bold},
    FilledFace{"dejavu-sans-mono", dejavu_sans_mono},
};

std::unique_ptr<Font> font_file(const std::filesystem::path& path)
{
    std::string bytes = read_input(path, font_input);
    try {
        return std::make_unique<OutlineFont>(std::move(bytes));
    } catch (const Failure& failure) {
        throw Failure(path.string() + ": " + failure.what());
    }
}

}

std::span<const std::string_view> FontShelf::bundled_names()
{
    static const auto names = [] {
        std::vector<std::string_view> list;
        std::ranges::transform(filled_faces, std::back_inserter(list), &FilledFace::name);
        std::ranges::transform(hershey_faces(), std::back_inserter(list), &HersheyFace::name);
        return list;
    }();
    return names;
}

Font& FontShelf::font(const std::string& name)
{
    auto known = fonts_.find(name);
    if (known == fonts_.end())
        known = fonts_.emplace(name, load(name)).first;
    return *known->second;
}

std::vector<std::string_view> FontShelf::bundled_with(char32_t character)
{
    std::vector<std::string_view> names;
    std::ranges::copy_if(bundled_names(), std::back_inserter(names), [&](std::string_view name) {
        return font(std::string{name}).letter(character) != nullptr;
    });
    return names;
}

std::unique_ptr<Font> FontShelf::load(const std::string& name) const
{
    const auto filled = std::ranges::find(filled_faces, name, &FilledFace::name);
    if (filled != filled_faces.end())
        return std::make_unique<OutlineFont>(std::string{filled->file()});
    const auto face = std::ranges::find(hershey_faces(), name, &HersheyFace::name);
    if (face != hershey_faces().end())
        return std::make_unique<HersheyFont>(face->jhf);
    return font_file(std::filesystem::path{folder_.value()} / name);
}

}
