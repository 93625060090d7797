#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace kfast {

/// What the value of an option or of an argument names.
enum class OptionKind : std::uint8_t {
    word,   ///< described only by the help: a word, a time, a number of any size
    number, ///< within bounds
    file_to_read,
    file_to_write, ///< or a socket
    folder,
};

/// What is known of the value of an option or of an argument. It is said where that is declared; help, manual
/// pages and the completions of shells read it.
struct OptionFacts {
    OptionKind kind = OptionKind::word;
    std::string range = {};                ///< of a number: "0.1 to 3600"
    std::vector<std::string> endings = {}; ///< of the files that are meant, ".kfast"; none: all
    std::vector<std::string> offered = {}; ///< words that may be meant; others may be allowed as well

    bool takes_path() const { return kind >= OptionKind::file_to_read; }
};

/// All that has been said of `option`; the last word on its kind counts.
OptionFacts option_facts(const CLI::Option& option);

/// Each says what `option` names, checks nothing, and returns `option`. Files with these endings, besides
/// folders, are offered; all files if there are none.
CLI::Option* reads_file(CLI::Option* option, std::vector<std::string> endings = {});
CLI::Option* writes_file(CLI::Option* option, std::vector<std::string> endings = {});
CLI::Option* names_folder(CLI::Option* option, std::vector<std::string> endings = {});

/// Says which words it takes; it may take others as well, or be a file in place of them.
CLI::Option* offer(CLI::Option* option, const std::vector<std::string_view>& words);

/// The same for the names of rows that have one.
template <class Rows>
CLI::Option* offer_names(CLI::Option* option, const Rows& rows)
{
    std::vector<std::string_view> names;
    names.reserve(std::size(rows));
    for (const auto& row : rows)
        names.push_back(row.name);
    return offer(option, names);
}

/// `check`, which goes on as before, and from which option_facts() has `facts`.
CLI::Validator with_facts(CLI::Validator check, OptionFacts facts);

/// A validator of CLI11 for these words or whole numbers and no others, which it offers.
template <class T>
CLI::Validator one_of(std::initializer_list<T> values)
{
    OptionFacts facts;
    for (const T& value : values)
        if constexpr (std::is_integral_v<T>)
            facts.offered.push_back(std::to_string(value));
        else
            facts.offered.emplace_back(value);
    return with_facts(CLI::IsMember(values), facts);
}

/// A validator of CLI11 for numbers within bounds, which it describes as "0.1 to 3600". CLI::Range takes what
/// is no number at all ("nan") for one within them.
CLI::Validator number_within(double min, double max);

}
