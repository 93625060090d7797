#include "host/commands/command.hpp"
#include "host/commands/help/command_words.hpp"
#include "host/commands/options/option_facts.hpp"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::test {
namespace {

using Words = std::vector<std::string>;

/// What a user reads in the help where a path is meant: the type of an option, the name of an argument.
constexpr std::array<std::string_view, 8> words_for_paths{"FILE", "FILES", "FOLDER",  "INPUT",
                                                          "OUT",  "PATH",  "PROFILE", "SCENE"};

struct Declared {
    std::string name; ///< with its command: "render --output"
    OptionWords words;
};

/// Options and arguments that take a value, of all commands.
void add_declared(const CommandWords& command, std::vector<Declared>& all)
{
    for (const OptionWords& option : command.options)
        if (option.takes_value)
            all.push_back({command.name + ' ' + option.names.back(), option});
    for (const CommandWords& inner : command.subcommands)
        add_declared(inner, all);
}

std::vector<Declared> all_declared()
{
    CLI::App kfast{"", "kfast"};
    declare_commands(kfast);
    std::vector<Declared> all;
    add_declared(words_of_command(kfast), all);
    return all;
}

std::string_view shown_type(const OptionWords& option)
{
    return option.is_positional ? option.names.front() : option.type;
}

OptionFacts facts_in(std::string_view name)
{
    const std::vector<Declared> all = all_declared();
    const auto found = std::ranges::find(all, name, &Declared::name);
    REQUIRE(found != all.end());
    return found->words.facts;
}

struct OneOption {
    CLI::App app;
    std::string text;
    CLI::Option* option = app.add_option("--it", text)->type_name("IT");
};

}

TEST_CASE("what is called a file or a folder in the help is declared as one, and nothing else is")
{
    const std::vector<Declared> all = all_declared();
    CHECK(all.size() > 150);
    for (const auto& declared : all) {
        const std::string& name = declared.name;
        const OptionWords& words = declared.words;
        const bool is_path = std::ranges::find(words_for_paths, shown_type(words)) != words_for_paths.end();
        CHECK_MESSAGE(words.facts.takes_path() == is_path, name);
        CHECK_MESSAGE((words.facts.kind == OptionKind::folder) == (shown_type(words) == "FOLDER"), name);
    }
}

TEST_CASE("endings stand in the help, and only numbers have a range")
{
    for (const auto& declared : all_declared()) {
        const std::string& name = declared.name;
        const OptionWords& words = declared.words;
        for (const std::string& ending : words.facts.endings)
            CHECK_MESSAGE(words.help.find(ending) != std::string::npos, name);
        CHECK_MESSAGE((words.facts.kind == OptionKind::number) == !words.facts.range.empty(), name);
        CHECK_MESSAGE((words.facts.takes_path() || words.facts.endings.empty()), name);
    }
}

TEST_CASE("commands say what they read and write")
{
    const Words loaded{".lottie", ".svg", ".sif", ".kfast", ".kfb", ".json"};
    for (const char* const name : {"render FILE", "upload SCENE", "uf2 pack --scene"}) {
        const OptionFacts scene = facts_in(name);
        CHECK(scene.kind == OptionKind::file_to_read);
        CHECK(scene.endings == loaded);
    }
    CHECK(facts_in("new SCENE").kind == OptionKind::file_to_write);
    CHECK(facts_in("render --output").kind == OptionKind::file_to_write);
    CHECK(facts_in("uf2 unpack --output").kind == OptionKind::folder);
    CHECK(facts_in("flash --beam").offered == Words{"scope", "crt", "galvo"});
    CHECK(facts_in("flash --beam").kind == OptionKind::file_to_read);
    CHECK(facts_in("devices --timeout").kind == OptionKind::number);
    CHECK(facts_in("upload --name").kind == OptionKind::word);
}

TEST_CASE("an option of which nothing was said takes a word")
{
    const OneOption plain;
    const OptionFacts facts = option_facts(*plain.option);
    CHECK(facts.kind == OptionKind::word);
    CHECK_FALSE(facts.takes_path());
    CHECK(facts.endings.empty());
    CHECK(facts.offered.empty());
    CHECK(facts.range.empty());
}

TEST_CASE("what is said of an option adds up, changes no help, and checks nothing")
{
    OneOption one;
    CHECK(offer(writes_file(one.option, {".png"}), {"left", "right"}) == one.option);
    CHECK(one.option->get_type_name() == "IT");
    CHECK(option_facts(*one.option).kind == OptionKind::file_to_write);
    CHECK(option_facts(*one.option).endings == Words{".png"});
    CHECK(option_facts(*one.option).offered == Words{"left", "right"});
    names_folder(one.option); // as an output that is one
    CHECK(option_facts(*one.option).kind == OptionKind::folder);
    CHECK(option_facts(*one.option).endings.empty());
    one.app.parse("--it any");
    CHECK(one.text == "any");
}

TEST_CASE("checks with facts go on checking")
{
    OneOption word;
    word.option->check(one_of({"x", "y"}));
    CHECK(option_facts(*word.option).offered == Words{"x", "y"});
    CHECK(word.option->get_type_name() == "IT:{x,y}");
    CHECK_THROWS_WITH_AS(word.app.parse("--it z"), "--it: z not in {x,y}", CLI::ValidationError);
    OneOption whole;
    whole.option->check(one_of({0, 90}));
    CHECK(option_facts(*whole.option).offered == Words{"0", "90"});
    CHECK_THROWS_WITH_AS(whole.app.parse("--it 9"), "--it: 9 not in {0,90}", CLI::ValidationError);
    OneOption number;
    number.option->check(number_within(0.5, 768'000));
    CHECK(option_facts(*number.option).range == "0.5 to 768000");
    CHECK(number.option->get_type_name() == "IT:0.5 to 768000");
    CHECK_THROWS_WITH_AS(number.app.parse("--it nan"), "--it: 'nan' is not a number from 0.5 to 768000",
                         CLI::ValidationError);
}

}
