#include "host/commands/help/usage_mistake.hpp"

#include "host/commands/help/command_words.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <optional>
#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast {

namespace {

constexpr std::array renamed_options{
    OldName{"check", "--format", "--json", "json"},
    OldName{"check", "--format", "", "text"}, // now the default
    OldName{"check", "--name", "--stdin-filename"},
    OldName{"check", "--size", "--canvas"},
    OldName{"compile", "--size", "--canvas"},
    OldName{"export", "--invert", "--mirror"},
    OldName{"export", "--name", "--array-name"},
    OldName{"export", "--rate", "--sample-rate"},
    OldName{"fit", "--size", "--canvas"},
    OldName{"flash", "--serial", "--device"},
    OldName{"hash", "--fit", "--scaling"},
    OldName{"import", "--size", "--canvas"},
    OldName{"info", "--rate", "--point-rate"},
    OldName{"preview", "--fit", "--scaling"},
    OldName{"preview", "--invert", "--mirror"},
    OldName{"preview", "--keys", "--press"},
    OldName{"preview", "--rate", "--sample-rate"},
    OldName{"render", "--fit", "--scaling"},
    OldName{"simulate", "--flash", "--flash-file"},
    OldName{"simulate", "--frames", "--print-frames"},
};

std::string written(const OldName& name)
{
    return std::string{name.before} + (name.value.empty() ? "" : ' ' + std::string{name.value});
}

/// The rest of a command line, whose options are renamed to the current names.
class Renaming {
public:
    Renaming(std::span<const char* const> arguments, std::string_view command, std::ostream& notes)
        : rest_{arguments}, command_{command}, notes_{notes}
    {
    }

    std::vector<std::string> run()
    {
        while (!rest_.empty()) {
            const std::string_view word = rest_.front();
            if (word == "--")
                break;
            rest_ = rest_.subspan(1);
            if (auto now = word_of_now(word))
                renamed_.push_back(*std::move(now));
        }
        renamed_.insert(renamed_.end(), rest_.begin(), rest_.end());
        return renamed_;
    }

private:
    /// Nothing for an option that is not needed any more.
    std::optional<std::string> word_of_now(std::string_view word)
    {
        const std::size_t sign = std::min(word.find('='), word.size());
        const std::string_view assigned = word.substr(sign); // "=json", or nothing
        const auto* const row = std::ranges::find_if(renamed_options, [&](const OldName& name) {
            return name.command == command_ && name.before == word.substr(0, sign) &&
                   (name.value.empty() || name.value == value_behind(assigned));
        });
        if (row == renamed_options.end())
            return std::string{word};
        if (!row->value.empty() && assigned.empty())
            rest_ = rest_.subspan(1); // the value goes with the option
        note(*row);
        if (row->now.empty())
            return std::nullopt;
        return std::string{row->now} + std::string{row->value.empty() ? assigned : ""};
    }

    std::string_view value_behind(std::string_view assigned) const
    {
        if (!assigned.empty())
            return assigned.substr(1);
        return rest_.empty() ? "" : rest_.front();
    }

    void note(const OldName& name) const
    {
        notes_ << "kfast: " << written(name);
        if (name.now.empty())
            notes_ << " is the default; the next version drops the option\n";
        else
            notes_ << " is now called " << name.now << "; the next version drops the old name\n";
    }

    std::span<const char* const> rest_;
    std::string_view command_;
    std::ostream& notes_;
    std::vector<std::string> renamed_ = {};
};

}

std::span<const OldName> old_names() { return renamed_options; }

std::vector<std::string> with_names_of_now(std::span<const char* const> arguments, std::ostream& notes)
{
    return Renaming{arguments, arguments.size() > 1 ? arguments[1] : "", notes}.run();
}

namespace {

std::vector<std::string> option_names(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const OptionWords& option : words_of_command(command).options)
        if (!option.is_positional)
            std::ranges::copy(option.names, std::back_inserter(names));
    return names;
}

/// "--fps" of "--fps=12", "-o" of "-oout.kfb"; empty: the argument is no option, as "-1" is none.
std::string_view option_name(std::string_view argument)
{
    if (argument.starts_with("--"))
        return argument.substr(0, argument.find('='));
    const bool is_short = argument.size() > 1 && argument[0] == '-' &&
                          std::isalpha(static_cast<unsigned char>(argument[1])) != 0;
    return argument.substr(0, is_short ? 2 : 0);
}

/// The first that `command` does not have; empty: there is none. What follows "--" is no option.
std::string_view unknown_option(const std::vector<std::string>& known, std::span<const char* const> arguments)
{
    for (const std::string_view argument : arguments) {
        if (argument == "--")
            break;
        const std::string_view name = option_name(argument);
        if (!name.empty() && std::ranges::find(known, name) == known.end())
            return name;
    }
    return {};
}

/// The option that may be meant, or else those of the same kind, long or short.
std::string hint_of(std::string_view unknown, const std::vector<std::string>& known)
{
    std::vector<std::string_view> alike;
    std::ranges::copy_if(known, std::back_inserter(alike), [unknown](std::string_view name) {
        return name.starts_with("--") == unknown.starts_with("--");
    });
    return suggestion(unknown, alike);
}

bool is_whole(std::string_view number)
{
    const std::string_view digits = number.substr(number.starts_with('-') ? 1 : 0);
    return !digits.empty() && digits.find_first_not_of("0123456789") == digits.npos;
}

/// The message for "12,x", the numbers of an option or an argument as CLI11 joins them.
std::string wrong_number(std::string_view numbers)
{
    for (std::string_view rest = numbers; !rest.empty();) {
        const std::string_view number = rest.substr(0, rest.find(','));
        if (!is_whole(number))
            return in_quotes(number) + " is no whole number: write digits alone, like 12";
        rest.remove_prefix(std::min(number.size() + 1, rest.size()));
    }
    return std::string{numbers} + " is out of range";
}

/// The message for "Could not convert: --frame = 1e3", which all options for whole numbers have in common.
std::string conversion_mistake(std::string_view what)
{
    constexpr std::string_view begin = "Could not convert: ";
    constexpr std::string_view middle = " = ";
    const std::size_t at = what.find(middle);
    if (!what.starts_with(begin) || at == std::string_view::npos)
        return std::string{what};
    return std::string{what.substr(begin.size(), at - begin.size())} + ": " +
           wrong_number(what.substr(at + middle.size()));
}

/// The message for "Exactly 1 option from [--ild,--wav] is required" and for too many of them: "choose one
/// of --ild, --wav".
std::string choice_mistake(std::string_view what)
{
    const std::size_t begin = what.find("[--");
    const std::size_t end = what.find(']', std::min(begin, what.size()));
    if (end == std::string_view::npos)
        return std::string{what};
    std::string text = "choose one of ";
    for (const char letter : what.substr(begin + 1, end - begin - 1))
        letter == ',' ? text.append(", ") : text.append(1, letter);
    return text;
}

/// All, however many they are: without a command the user does not know what there is.
std::string list_of_all(std::span<const std::string_view> names)
{
    std::string list = names.empty() ? "nothing is allowed here" : "allowed:";
    for (const std::string_view name : names)
        list.append(list.back() == ':' ? " " : ", ").append(name);
    return list;
}

}

void require_command_among(std::span<const std::string_view> known, std::string_view word)
{
    if (word.starts_with('-') || std::ranges::find(known, word) != known.end())
        return;
    const std::string wrong =
        word.empty() ? "a command is missing" : "there is no command '" + std::string(word) + '\'';
    const std::string close = did_you_mean(word, known);
    throw Failure(wrong + ": " + (close.empty() ? list_of_all(known) : close) + "\nTry 'kfast --help'.",
                  ExitStatus::wrong_usage);
}

std::string usage_mistake(const CLI::App& command, const CLI::Error& error,
                          std::span<const char* const> arguments)
{
    const std::vector<std::string> known = option_names(command);
    if (const std::string_view unknown = unknown_option(known, arguments); !unknown.empty())
        return "there is no option " + std::string{unknown} + ": " + hint_of(unknown, known);
    if (error.get_name() == "RequiredError")
        return choice_mistake(error.what());
    return error.get_name() == "ConversionError" ? conversion_mistake(error.what()) : error.what();
}

}
