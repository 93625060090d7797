#include "host/commands/help/bash_completion.hpp"

#include <string_view>

namespace kfast {
namespace {

std::string joined(const std::vector<std::string>& words, std::string_view separator)
{
    std::string text;
    for (const std::string& word : words)
        text.append(text.empty() ? "" : separator).append(word);
    return text;
}

std::string names_of_commands(const CommandWords& command)
{
    std::string names;
    for (const CommandWords& inner : command.subcommands)
        names.append(names.empty() ? "" : " ").append(inner.name.substr(inner.name.rfind(' ') + 1));
    return names;
}

/// What completes a value, as a call of a function of the script.
std::string value_call(const OptionWords& option)
{
    std::string call = "_kfast_words \"" + joined(option.offered, " ") + '"';
    if (option.takes_path)
        call += "; _kfast_files " + joined(option.endings, " ");
    return call;
}

std::string offered_options(const CommandWords& command)
{
    std::string names;
    for (const OptionWords& option : command.options)
        if (!option.is_positional)
            names.append(names.empty() ? "" : " ").append(joined(option.names, " "));
    return names;
}

std::string case_of(const CommandWords& command)
{
    std::string text = "    '" + command.name + "')\n        case \"$before\" in\n";
    std::string positional;
    for (const OptionWords& option : command.options) {
        if (option.is_positional)
            positional += "; " + value_call(option);
        else if (option.takes_value)
            text += "        " + joined(option.names, "|") + ") " + value_call(option) + "; return ;;\n";
    }
    text += "        esac\n        if [[ $current == -* ]]; then\n            _kfast_words '" +
            offered_options(command) + "'\n        else\n            :" + positional +
            "\n        fi\n        ;;\n";
    return text;
}

std::string cases_of(const CommandWords& command)
{
    if (command.subcommands.empty())
        return case_of(command);
    std::string text = "    '" + command.name + "') _kfast_words '" + names_of_commands(command) + ' ' +
                       offered_options(command) + "' ;;\n";
    for (const CommandWords& inner : command.subcommands)
        text += cases_of(inner);
    return text;
}

/// Of the commands that others follow.
std::string names_of_holders(const CommandWords& kfast)
{
    std::string names;
    for (const CommandWords& command : kfast.subcommands)
        if (!command.subcommands.empty())
            names += '|' + command.name;
    return names.empty() ? "''" : names.substr(1);
}

constexpr std::string_view functions = R"(# Completes kfast in bash. Made by "kfast completions bash".

# Adds a line each of what is read, as it is: what expanded it would take [a].kfast for a.kfast.
_kfast_offer() {
    local -a lines
    mapfile -t lines
    COMPREPLY+=("${lines[@]}")
}

_kfast_words() {
    _kfast_offer < <(compgen -W "$1" -- "$current")
}

# Folders, and files with these endings; all files if there are none.
_kfast_files() {
    local ending
    compopt -o filenames 2>/dev/null
    if (($# == 0)); then
        _kfast_offer < <(compgen -f -- "$current")
        return
    fi
    _kfast_offer < <(compgen -d -- "$current")
    for ending in "$@"; do
        _kfast_offer < <(compgen -f -X "!*$ending" -- "$current")
    done
}

_kfast() {
    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=
    COMPREPLY=()
    if [[ $current == = ]]; then # bash takes --option=value apart
        current=
    elif [[ $before == = ]]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    if ((COMP_CWORD > 1)); then
        command=${COMP_WORDS[1]}
    fi
    case "$command" in
)";

}

std::string bash_completion(const CommandWords& kfast)
{
    std::string text{functions};
    text += "    " + names_of_holders(kfast) +
            ")\n        if ((COMP_CWORD > 2)); then\n            command+=\" ${COMP_WORDS[2]}\"\n        "
            "fi\n        ;;\n"
            "    esac\n    case \"$command\" in\n";
    text += cases_of(kfast);
    return text + "    esac\n}\n\ncomplete -F _kfast kfast\n";
}

}
