#include "host/commands/help/zsh_completion.hpp"

#include <string_view>

namespace kfast {
namespace {

/// Inside of '[…]' of a specification, in single quotes.
std::string help_text(const std::string& help)
{
    std::string text;
    for (const char letter : help)
        if (letter == '\'')
            text += "'\\''";
        else if (letter == '[' || letter == ']' || letter == ':' || letter == '\\')
            text.append("\\").append(1, letter);
        else
            text += letter;
    return text;
}

/// ":message:action" for a value.
std::string action(const OptionWords& option)
{
    const std::string type = option.is_positional ? option.names.front() : option.type;
    std::string text = ':' + help_text(type) + ':';
    std::string words;
    for (const std::string& word : option.offered)
        words.append(words.empty() ? "" : " ").append(word);
    std::string glob;
    for (const std::string& ending : option.endings)
        glob.append(glob.empty() ? "" : "|").append(ending.substr(1));
    const std::string files = glob.empty() ? "_files" : "_files -g \"*.(" + glob + ")\"";
    if (!words.empty() && option.takes_path)
        return text + "{ compadd " + words + "; " + files + " }";
    if (!words.empty())
        return text + '(' + words + ')';
    return text + (option.takes_path ? files : "");
}

std::string specification(const OptionWords& option)
{
    std::string text;
    if (option.is_positional)
        return std::string{"        '"} +
               (option.takes_many    ? "*"
                : option.is_required ? ""
                                     : ":") +
               action(option) + "' \\\n";
    for (const std::string& name : option.names) {
        const bool is_long = name.starts_with("--");
        text += "        '*" + name +
                (!option.takes_value ? ""
                 : is_long           ? "="
                                     : "+") +
                '[' + help_text(option.help) + ']' + (option.takes_value ? action(option) : "") + "' \\\n";
    }
    return text;
}

std::string function_name(const std::string& command)
{
    std::string name = "_kfast";
    name += command.empty() ? "" : "_" + command;
    for (char& letter : name)
        if (letter == ' ' || letter == '-')
            letter = '_';
    return name;
}

/// An element of an array for _describe.
std::string described(const std::string& word, const std::string& help)
{
    return "        '" + word + ':' + help_text(help) + "'\n";
}

std::string functions_of(const CommandWords& command)
{
    std::string text;
    for (const CommandWords& inner : command.subcommands)
        text += functions_of(inner);
    text += function_name(command.name) + "() {\n";
    if (command.subcommands.empty()) {
        text += "    _arguments \\\n";
        for (const OptionWords& option : command.options)
            text += specification(option);
        return text + "        && return\n}\n\n";
    }
    text += "    local -a commands=(\n";
    for (const CommandWords& inner : command.subcommands)
        text += described(inner.name.substr(inner.name.rfind(' ') + 1), inner.summary);
    text += "    )\n    local -a flags=(\n";
    for (const OptionWords& option : command.options)
        for (const std::string& name : option.names)
            text += described(name, option.help);
    text += "    )\n    if ((CURRENT == 2)); then\n        _describe command commands\n"
            "        _describe -o option flags\n        return\n    fi\n"
            "    shift words\n    ((CURRENT--))\n    case \"$words[1]\" in\n";
    for (const CommandWords& inner : command.subcommands)
        text += "    " + inner.name.substr(inner.name.rfind(' ') + 1) + ") " + function_name(inner.name) +
                " ;;\n";
    return text + "    esac\n}\n\n";
}

}

std::string zsh_completion(const CommandWords& kfast)
{
    return "#compdef kfast\n# Completes kfast in zsh. Made by \"kfast completions zsh\".\n\n" +
           functions_of(kfast) +
           "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then\n    _kfast \"$@\"\nelse\n"
           "    compdef _kfast kfast\nfi\n";
}

}
