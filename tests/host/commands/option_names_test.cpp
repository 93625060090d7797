#include "host/commands/command.hpp"
#include "host/commands/help/command_words.hpp"
#include "host/commands/help/usage_mistake.hpp"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

namespace kfast::test {
namespace {

CommandWords all_words()
{
    CLI::App kfast{"", "kfast"};
    declare_commands(kfast);
    return words_of_command(kfast);
}

std::set<std::string> names_of(const CommandWords& kfast, std::string_view command)
{
    std::set<std::string> names;
    const auto found = std::ranges::find(kfast.subcommands, command, &CommandWords::name);
    REQUIRE(found != kfast.subcommands.end());
    for (const OptionWords& option : found->options)
        names.insert(option.names.begin(), option.names.end());
    return names;
}

struct Renamed {
    std::vector<std::string> words;
    std::string notes;
};

Renamed renamed(const std::vector<std::string>& words)
{
    std::vector<const char*> arguments;
    arguments.reserve(words.size());
    for (const std::string& word : words)
        arguments.push_back(word.c_str());
    std::ostringstream notes;
    auto now = with_names_of_now(arguments, notes);
    return {std::move(now), notes.str()};
}

void add_descriptions(const CommandWords& command, std::map<std::string, std::set<std::string>>& all)
{
    for (const OptionWords& option : command.options)
        if (!option.is_positional)
            for (const std::string& name : option.names)
                all[name].insert(option.help);
    for (const CommandWords& inner : command.subcommands)
        add_descriptions(inner, all);
}

/// Options that mean one thing in all commands, of which each says what is particular to it.
constexpr std::array<std::string_view, 12> described_apart{
    "--board",          // which ones there are: those to fit, or with firmware
    "--device",         // flash takes one alone
    "--firmware",       // what is installed is the default of flash
    "--fps",            // to be made, or to be reached
    "--headless",       // what is printed in place of a window
    "--list",           // of what
    "--loops",          // ends a preview, repeats a video
    "--output",   "-o", // kinds of files
    "--panel",          // which ones there are: drivers, ready configurations, those to fit
    "--pin",            // GPIO of a Pico, or line of a computer
    "--slot",           // to play, or to fill
};

}

TEST_CASE("each old name of an option works, with a note, and is not offered")
{
    const CommandWords kfast = all_words();
    for (const OldName& name : old_names()) {
        const std::string command{name.command};
        const std::string before{name.before};
        const std::string now{name.now};
        CAPTURE(command);
        CAPTURE(before);
        CHECK_FALSE(names_of(kfast, command).contains(before));
        if (now.empty())
            continue; // has a test of its own
        CHECK(names_of(kfast, command).contains(now));
        const std::string value{name.value.empty() ? "9x9" : name.value};
        const bool is_flag = !name.value.empty();
        const auto apart = renamed({"kfast", command, before, value, "a.kfast"});
        CHECK(apart.words == (is_flag ? std::vector<std::string>{"kfast", command, now, "a.kfast"}
                                      : std::vector<std::string>{"kfast", command, now, value, "a.kfast"}));
        CHECK(apart.notes == "kfast: " + before + (is_flag ? ' ' + value : "") + " is now called " + now +
                                 "; the next version drops the old name\n");
        const auto joined = renamed({"kfast", command, before + '=' + value});
        CHECK(joined.words == std::vector<std::string>{"kfast", command, is_flag ? now : now + '=' + value});
        CHECK(joined.notes == apart.notes);
    }
}

TEST_CASE("an option that is the default by now is left out, with a note")
{
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"kfast", "check", "--format", "text", "", "a.kfast"},
          {"kfast", "check", "--format=text", "", "a.kfast"}}) {
        const auto now = renamed(words);
        CHECK(now.words == std::vector<std::string>{"kfast", "check", "", "a.kfast"});
        CHECK(now.notes == "kfast: --format text is the default; the next version drops the option\n");
    }
}

TEST_CASE("what is no old name stays")
{
    for (const std::vector<std::string>& words : {std::vector<std::string>{"kfast"},
                                                  {"kfast", "--fit"},
                                                  {"kfast", "upload", "--name", "eyes"},
                                                  {"kfast", "render", "--", "--fit", "cover"},
                                                  {"kfast", "render", "--fitting"},
                                                  {"kfast", "check", "--format", "xml"},
                                                  {"kfast", "check", "--format=jsn"},
                                                  {"kfast", "check", "--format"}}) {
        const auto same = renamed(words);
        CHECK(same.words == words);
        CHECK(same.notes.empty());
    }
}

TEST_CASE("an option means one thing in all commands")
{
    std::map<std::string, std::set<std::string>> descriptions;
    add_descriptions(all_words(), descriptions);
    for (const auto& entry : descriptions) {
        const std::string& name = entry.first;
        if (std::ranges::find(described_apart, name) == described_apart.end())
            CHECK_MESSAGE(entry.second.size() == 1, name);
    }
}

}
