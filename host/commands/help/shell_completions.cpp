#include "host/commands/help/shell_completions.hpp"

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
    std::string call = "_kfast_words \"" + joined(option.facts.offered, " ") + '"';
    if (option.facts.takes_path())
        call += "; _kfast_files " + joined(option.facts.endings, " ");
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

/// The names of the commands that have subcommands.
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
    for (const std::string& word : option.facts.offered)
        words.append(words.empty() ? "" : " ").append(word);
    std::string glob;
    for (const std::string& ending : option.facts.endings)
        glob.append(glob.empty() ? "" : "|").append(ending.substr(1));
    const std::string files = glob.empty() ? "_files" : "_files -g \"*.(" + glob + ")\"";
    if (!words.empty() && option.facts.takes_path())
        return text + "{ compadd " + words + "; " + files + " }";
    if (!words.empty())
        return text + '(' + words + ')';
    return text + (option.facts.takes_path() ? files : "");
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

/// The same, and none of those inside of it follows yet.
std::string condition_of_inner(const CommandWords& command)
{
    std::string text = condition(command.name) + "; and not __fish_seen_subcommand_from";
    for (const CommandWords& inner : command.subcommands)
        text += ' ' + last_word(inner.name);
    return text;
}

std::string when(const std::string& condition) { return " -n " + single_quoted(condition); }

/// "-a" with the possible values.
std::string values(const OptionWords& option)
{
    std::string words;
    for (const std::string& word : option.facts.offered)
        words += word + ' ';
    if (option.facts.takes_path() && !option.facts.endings.empty()) {
        words += "(__kfast_files";
        for (const std::string& ending : option.facts.endings)
            words += ' ' + ending.substr(1); // without its dot
        words += ')';
    }
    return words.empty() ? "" : " -a " + single_quoted(words);
}

std::string line_of(const std::string& condition, const OptionWords& option)
{
    std::string line = "complete -c kfast" + when(condition);
    if (option.is_positional)
        return values(option).empty() && !option.facts.takes_path()
                   ? ""
                   : line + (option.facts.takes_path() && option.facts.endings.empty() ? " -F" : " -f") +
                         values(option) + '\n';
    for (const std::string& name : option.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (option.takes_value)
        line +=
            (option.facts.takes_path() && option.facts.endings.empty() ? " -r -F" : " -x") + values(option);
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
