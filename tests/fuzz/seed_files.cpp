#include "tests/fuzz/seed_files.hpp"

#include <dirent.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

// Of the C library alone: the memory sanitizer does not see what libstdc++ writes to streams and paths.
namespace kfast::test {
namespace {

[[noreturn]] void give_up(const std::string& why)
{
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(2);
}

/// Adds those of a folder; false if it is none.
bool add_folder(const std::string& folder, std::vector<std::string>& files)
{
    DIR* const entries = opendir(folder.c_str());
    if (entries == nullptr)
        return false;
    const std::size_t before = files.size();
    while (const dirent* const entry = readdir(entries))
        if (entry->d_name[0] != '.')
            files.push_back(folder + "/" + entry->d_name);
    closedir(entries);
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
    return true;
}

std::vector<std::byte> contents(const std::string& name)
{
    std::FILE* const file = std::fopen(name.c_str(), "rb");
    if (file == nullptr)
        give_up("There is no file " + name);
    std::vector<std::byte> bytes;
    std::array<std::byte, 4096> piece;
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), file))
        bytes.insert(bytes.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
    std::fclose(file);
    return bytes;
}

constexpr std::size_t fewest_bytes = 16; ///< of a scene; none is as short

bool is_no_scene(const std::vector<std::byte>& bytes)
{
    constexpr std::array magic{std::byte{'K'}, std::byte{'F'}, std::byte{'B'}};
    return bytes.size() < fewest_bytes || !std::equal(magic.begin(), magic.end(), bytes.begin());
}

}

std::vector<std::vector<std::byte>> read_files(std::span<const std::string> files_and_folders)
{
    std::vector<std::string> names;
    for (const std::string& name : files_and_folders)
        if (!add_folder(name, names))
            names.push_back(name);
    std::vector<std::vector<std::byte>> files;
    for (const std::string& name : names)
        if (std::vector<std::byte> bytes = contents(name); !bytes.empty())
            files.push_back(std::move(bytes));
    if (files.empty())
        give_up("There are no files to begin with");
    return files;
}

std::vector<std::vector<std::byte>> read_scenes(std::span<const std::string> files_and_folders)
{
    std::vector<std::vector<std::byte>> scenes = read_files(files_and_folders);
    std::erase_if(scenes, is_no_scene);
    if (scenes.empty())
        give_up("There are no compiled scenes to begin with");
    return scenes;
}

}
