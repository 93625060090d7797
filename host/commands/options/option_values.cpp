#include "host/commands/options/option_values.hpp"

#include <sstream>

namespace kfast {

namespace {

/// In front of the names in the name of a check that checks nothing.
constexpr std::string_view mark = "offers ";

std::vector<std::string> split(std::string text, char separator)
{
    std::vector<std::string> words;
    std::istringstream stream{text};
    for (std::string word; std::getline(stream, word, separator);)
        words.push_back(word);
    return words;
}

const CLI::Validator* check_of(const CLI::Option& option, int index)
{
    try {
        // Only this way leads to a check by its place, and nothing is changed.
        return const_cast<CLI::Option&>(option).get_validator(index);
    } catch (const CLI::OptionNotFound&) {
        return nullptr;
    }
}

}

CLI::Option* offer(CLI::Option* option, const std::vector<std::string_view>& names)
{
    std::string text{mark};
    for (const std::string_view name : names)
        text.append(name).append(" ");
    CLI::Validator none;
    none.name(text).active(false);
    return option->check(none);
}

std::vector<std::string> offered_names(const CLI::Option& option)
{
    for (int i = 0; const CLI::Validator* check = check_of(option, i); ++i) {
        if (check->get_name().starts_with(mark))
            return split(check->get_name().substr(mark.size()), ' ');
        const std::string set = check->get_description();
        if (set.starts_with('{') && set.ends_with('}'))
            return split(set.substr(1, set.size() - 2), ',');
    }
    return {};
}

}
