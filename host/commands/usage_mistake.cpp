#include "host/commands/usage_mistake.hpp"

#include "host/commands/command_words.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace kfast {
namespace {

std::vector<std::string> long_options(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const OptionWords& option : words_of_command(command).options)
        std::ranges::copy_if(option.names, std::back_inserter(names),
                             [](const std::string& name) { return name.starts_with("--"); });
    return names;
}

/// The first that `command` does not have; empty: there is none. What follows "--" is no option.
std::string_view unknown_option(const std::vector<std::string>& known, std::span<const char* const> arguments)
{
    for (const std::string_view argument : arguments) {
        if (argument == "--")
            break;
        const std::string_view name = argument.substr(0, argument.find('='));
        if (name.starts_with("--") && std::ranges::find(known, name) == known.end())
            return name;
    }
    return {};
}

/// Of "Could not convert: --frame = 1e3", which all options for whole numbers have in common.
std::string not_whole(std::string_view what)
{
    constexpr std::string_view begin = "Could not convert: ";
    constexpr std::string_view middle = " = ";
    const std::size_t at = what.find(middle);
    if (!what.starts_with(begin) || at == std::string_view::npos)
        return std::string{what};
    return std::string{what.substr(begin.size(), at - begin.size())} + ": '" +
           std::string{what.substr(at + middle.size())} + "' is no whole number: write digits alone, like 12";
}

}

std::string usage_mistake(const CLI::App& command, const CLI::Error& error,
                          std::span<const char* const> arguments)
{
    const std::vector<std::string> known = long_options(command);
    if (const std::string_view unknown = unknown_option(known, arguments); !unknown.empty())
        return "there is no option " + std::string{unknown} + ": " +
               suggestion(unknown, std::vector<std::string_view>{known.begin(), known.end()});
    return error.get_name() == "ConversionError" ? not_whole(error.what()) : error.what();
}

}
