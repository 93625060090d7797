#include "host/commands/fish_completion.hpp"

#include <string_view>

namespace kfast {
namespace {

std::string single_quoted(const std::string& text)
{
    std::string result{'\''};
    for (const char letter : text) {
        if (letter == '\'' || letter == '\\')
            result += '\\';
        result += letter;
    }
    return result + '\'';
}

/// When the words so far are those of the command.
std::string condition(const std::string& command)
{
    std::string text = "__fish_seen_subcommand_from " + command.substr(0, command.find(' '));
    if (command.find(' ') != std::string::npos)
        text += "; and __fish_seen_subcommand_from " + command.substr(command.find(' ') + 1);
    return " -n " + single_quoted(text);
}

/// "-a" with what may stand there.
std::string values(const OptionWords& option)
{
    std::string words;
    for (const std::string& word : option.offered)
        words += word + ' ';
    if (option.takes_path && !option.endings.empty()) {
        words += "(__fish_complete_suffix";
        for (const std::string& ending : option.endings)
            words += ' ' + ending;
        words += ')';
    }
    return words.empty() ? "" : " -a " + single_quoted(words);
}

std::string line_of(const CommandWords& command, const OptionWords& option)
{
    std::string line = "complete -c kfast" + condition(command.name);
    if (option.is_positional)
        return values(option).empty() && !option.takes_path
                   ? ""
                   : line + (option.takes_path && option.endings.empty() ? " -F" : " -f") + values(option) +
                         '\n';
    for (const std::string& name : option.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (option.takes_value)
        line += (option.takes_path && option.endings.empty() ? " -r -F" : " -x") + values(option);
    return line + " -d " + single_quoted(option.help) + '\n';
}

std::string lines_of(const CommandWords& command)
{
    std::string text;
    for (const OptionWords& option : command.options)
        text += line_of(command, option);
    for (const CommandWords& inner : command.subcommands) {
        const std::string name = inner.name.substr(inner.name.rfind(' ') + 1);
        text += "complete -c kfast -f" + condition(command.name) + " -a " + name + " -d " +
                single_quoted(inner.summary) + '\n' + lines_of(inner);
    }
    return text;
}

}

std::string fish_completion(const CommandWords& kfast)
{
    std::string text =
        "# Completes kfast in fish. Made by \"kfast completions fish\".\n\ncomplete -c kfast -f\n";
    for (const CommandWords& command : kfast.subcommands)
        text += "complete -c kfast -n __fish_use_subcommand -a " + command.name + " -d " +
                single_quoted(command.summary) + '\n';
    for (const CommandWords& command : kfast.subcommands)
        text += lines_of(command);
    return text;
}

}
