#include "host/commands/help/command_words.hpp"

#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"

#include <algorithm>
#include <string_view>

namespace kfast {
namespace {

/// The position among the options of the command; help comes last.
std::size_t place_in_lists(const OptionWords& option)
{
    const bool is_help = std::ranges::find(option.names, "--help") != option.names.end();
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
    words.facts = option_facts(option);
    if (words.is_positional)
        words.names = {option.get_name(true)};
    words.type = option.get_type_name();
    words.default_text = option.get_default_str();
    words.type.resize(std::min(words.type.find(':'), words.type.size()));
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
    if (const std::size_t at = text.rfind(default_mark);
        !option.facts.range.empty() && at != std::string::npos)
        text.insert(at + 1, option.facts.range + "; ");
    else if (!option.facts.range.empty())
        text += " (" + option.facts.range + ')';
    if (option.is_required && !option.is_positional)
        text += " (needed)";
    if (option.takes_value && !option.facts.offered.empty() &&
        text.find(option.facts.offered.front()) == std::string::npos) {
        text += ". One of:";
        for (const std::string& name : option.facts.offered)
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
