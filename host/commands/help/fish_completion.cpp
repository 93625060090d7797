#include "host/commands/help/fish_completion.hpp"

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

/// fish's own __fish_complete_suffix takes one ending only.
constexpr std::string_view files_function =
    R"(function __kfast_files --description 'Folders, and files with these endings'
    set -l endings (string join '|' $argv)
    __fish_complete_path (commandline -ct) | string match -r -- '^[^\t]*(?:/|\.(?:'$endings'))(?:\t.*)?$'
end
)";

std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

/// When the words so far are those of the command.
std::string condition(const std::string& command)
{
    std::string text = "__fish_seen_subcommand_from " + command.substr(0, command.find(' '));
    if (command.find(' ') != std::string::npos)
        text += "; and __fish_seen_subcommand_from " + command.substr(command.find(' ') + 1);
    return text;
}

/// Likewise, and none of those inside of it follows yet.
std::string condition_of_inner(const CommandWords& command)
{
    std::string text = condition(command.name) + "; and not __fish_seen_subcommand_from";
    for (const CommandWords& inner : command.subcommands)
        text += ' ' + last_word(inner.name);
    return text;
}

std::string when(const std::string& condition) { return " -n " + single_quoted(condition); }

/// "-a" with what may stand there.
std::string values(const OptionWords& option)
{
    std::string words;
    for (const std::string& word : option.offered)
        words += word + ' ';
    if (option.takes_path && !option.endings.empty()) {
        words += "(__kfast_files";
        for (const std::string& ending : option.endings)
            words += ' ' + ending.substr(1); // without its dot
        words += ')';
    }
    return words.empty() ? "" : " -a " + single_quoted(words);
}

std::string line_of(const std::string& condition, const OptionWords& option)
{
    std::string line = "complete -c kfast" + when(condition);
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
        text += line_of(condition(command.name), option);
    for (const CommandWords& inner : command.subcommands) {
        text += "complete -c kfast -f" + when(condition_of_inner(command)) + " -a " + last_word(inner.name) +
                " -d " + single_quoted(inner.summary) + '\n' + lines_of(inner);
    }
    return text;
}

}

std::string fish_completion(const CommandWords& kfast)
{
    std::string text = "# Completes kfast in fish. Made by \"kfast completions fish\".\n\n" +
                       std::string{files_function} + "\ncomplete -c kfast -f\n";
    for (const CommandWords& command : kfast.subcommands)
        text += "complete -c kfast -n __fish_use_subcommand -a " + command.name + " -d " +
                single_quoted(command.summary) + '\n';
    for (const OptionWords& option : kfast.options)
        text += line_of("__fish_use_subcommand", option);
    for (const CommandWords& command : kfast.subcommands)
        text += lines_of(command);
    return text;
}

}
