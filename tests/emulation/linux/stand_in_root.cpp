#include "tests/emulation/linux/stand_in_root.hpp"

#include "tests/emulation/linux/real_calls.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace kfast::test {
namespace {

constexpr std::array<std::string_view, 4> prefixes{"/dev/gpiochip", "/dev/spidev", "/sys/bus/gpio/",
                                                   "/sys/module/spidev/"};

/// Without iostreams, which call what stands in for the kernel.
std::string content(const std::string& path)
{
    std::string text;
    std::FILE* const file = real_fopen(path.c_str(), "r");
    if (file == nullptr)
        return text;
    for (int letter = std::fgetc(file); letter != EOF; letter = std::fgetc(file))
        text += static_cast<char>(letter);
    std::fclose(file);
    return text;
}

}

const std::string& stand_in_root()
{
    static const std::string root = [] {
        const char* const name = std::getenv("KFAST_STAND_IN");
        return std::string{name == nullptr ? "" : name};
    }();
    return root;
}

std::string below_root(std::string_view path)
{
    if (stand_in_root().empty())
        return "";
    for (const std::string_view prefix : prefixes)
        if (path.starts_with(prefix))
            return stand_in_root() + std::string{path};
    return path == "/dev" || path == "/dev/" ? stand_in_root() + "/dev" : "";
}

std::multimap<std::string, std::string> described(const std::string& file)
{
    std::multimap<std::string, std::string> words;
    const std::string text = content(file);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        const std::size_t blank = std::min(line.find(' '), line.size());
        words.emplace(line.substr(0, blank), blank < line.size() ? line.substr(blank + 1) : "");
        begin = end + 1;
    }
    return words;
}

long number_of(const std::multimap<std::string, std::string>& description, const std::string& word,
               long otherwise)
{
    const auto found = description.find(word);
    return found == description.end() ? otherwise : std::strtol(found->second.c_str(), nullptr, 0);
}

}
