#include "host/scene/font_shelf.hpp"

#include "host/failure.hpp"
#include "host/input_file.hpp"
#include "host/scene/hershey_faces.hpp"
#include "host/scene/hershey_font.hpp"
#include "host/scene/outline_font.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace kfast::scene {
namespace {

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
        for (const HersheyFace& face : hershey_faces())
            list.push_back(face.name);
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

std::unique_ptr<Font> FontShelf::load(const std::string& name) const
{
    const auto face = std::ranges::find(hershey_faces(), name, &HersheyFace::name);
    if (face != hershey_faces().end())
        return std::make_unique<HersheyFont>(face->jhf);
    return font_file(std::filesystem::path{folder_.value()} / name);
}

}
