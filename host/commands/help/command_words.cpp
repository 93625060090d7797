#include "host/commands/help/command_words.hpp"

#include "host/commands/options/option_values.hpp"
#include "host/commands/options/option_groups.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace kfast {
namespace {

constexpr std::array path_types{"FILE", "FILES", "FOLDER", "OUT", "INPUT", "PROFILE", "PATH"};
/// Positional arguments have no type of their own.
constexpr std::array path_names{"FILE", "SCENE", "INPUT", "FOLDER"};

/// ".kfast" of "A scene text (.kfast)": what begins with a point between blanks and brackets.
std::vector<std::string> endings_in(const std::string& help)
{
    std::vector<std::string> endings;
    for (std::size_t at = help.find(" ."); at != std::string::npos; at = help.find(" .", at + 1))
        endings.push_back(help.substr(at + 1));
    for (std::size_t at = help.find("(."); at != std::string::npos; at = help.find("(.", at + 1))
        endings.push_back(help.substr(at + 1));
    for (std::string& ending : endings)
        ending.resize(std::min(ending.find_first_of(" ,;:)", 1), ending.size()));
    std::erase(endings, ".");
    return endings;
}

template <class Names>
bool is_among(const Names& names, const std::string& name)
{
    return std::ranges::find(names, name) != names.end();
}

/// Of "SECONDS:0.1 to 3600", as number_within() has it.
std::string range_of(const std::string& type)
{
    const std::size_t begin = type.find(':');
    return begin != std::string::npos && type.find(" to ", begin) != std::string::npos
               ? type.substr(begin + 1)
               : "";
}

/// Among those of the command; help comes last.
std::size_t place_in_lists(const OptionWords& option)
{
    const bool is_help = is_among(option.names, "--help");
    return option.is_positional ? 0 : 1 + place_of_group(option.group) + (is_help ? 1 : 0);
}

OptionWords words_of(const CLI::Option& option)
{
    OptionWords words;
    words.is_positional = option.get_positional();
    for (const std::string& name : option.get_snames())
        words.names.push_back('-' + name);
    for (const std::string& name : option.get_lnames())
        words.names.push_back("--" + name);
    words.takes_value = option.get_items_expected_max() > 0;
    words.is_required = option.get_required();
    words.takes_many = option.get_items_expected_max() > 1;
    words.help = option.get_description();
    words.group = option.get_group();
    words.offered = offered_names(option);
    if (words.is_positional)
        words.names = {option.get_name(true)};
    words.type = option.get_type_name();
    words.range = range_of(words.type);
    words.default_text = option.get_default_str();
    words.type.resize(std::min(words.type.find(':'), words.type.size()));
    const bool is_output = is_among(words.names, "--output");
    words.takes_path =
        words.takes_value && (is_output || (words.is_positional ? is_among(path_names, words.names.front())
                                                                : is_among(path_types, words.type)));
    if (words.takes_path && !is_output)
        words.endings = endings_in(words.help);
    return words;
}

/// Those of groups too, which the parser takes for commands without a name, and gives a help of their own.
void add_options(const CLI::App& app, CommandWords& words)
{
    const bool is_group = app.get_parent() != nullptr && app.get_name().empty();
    for (const CLI::Option* option : app.get_options())
        if (!is_group || option != app.get_help_ptr())
            words.options.push_back(words_of(*option));
    for (const CLI::App* inner : app.get_subcommands([](const CLI::App*) { return true; }))
        if (inner->get_name().empty())
            add_options(*inner, words);
}

}

std::string whole_help(const OptionWords& option)
{
    constexpr std::string_view default_mark = "(default:";
    std::string text = option.help;
    if (!option.default_text.empty())
        text += ' ' + std::string{default_mark} + ' ' + option.default_text + ')';
    if (const std::size_t at = text.rfind(default_mark); !option.range.empty() && at != std::string::npos)
        text.insert(at + 1, option.range + "; ");
    else if (!option.range.empty())
        text += " (" + option.range + ')';
    if (option.is_required && !option.is_positional)
        text += " (needed)";
    if (option.takes_value && !option.offered.empty() &&
        text.find(option.offered.front()) == std::string::npos) {
        text += ". One of:";
        for (const std::string& name : option.offered)
            text += ' ' + name;
    }
    return text;
}

CommandWords words_of_command(const CLI::App& app, const std::string& name)
{
    CommandWords words{.name = name,
                       .summary = app.get_description(),
                       .group = app.get_group(),
                       .footer = app.get_footer(),
                       .options = {},
                       .subcommands = {}};
    add_options(app, words);
    std::ranges::stable_sort(words.options, {}, place_in_lists);
    for (const CLI::App* inner : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!inner->get_name().empty())
            words.subcommands.push_back(
                words_of_command(*inner, name.empty() ? inner->get_name() : name + ' ' + inner->get_name()));
    return words;
}

}
