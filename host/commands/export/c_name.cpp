#include "host/commands/export/c_name.hpp"

#include "host/program/failure.hpp"
#include "host/text/glyph.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <filesystem>

namespace kfast {
namespace {

/// C promises that 63 letters count; some are for what is appended.
constexpr std::size_t longest_name = 48;

/// Words of C99 to C23 and C++20, and common macros and functions.
constexpr std::string_view taken =
    " alignas alignof and and_eq asm assert auto bitand bitor bool break case catch char char16_t "
    "char32_t char8_t class co_await co_return co_yield compl complex concept const const_cast "
    "consteval constexpr constinit continue decltype default delete do double dynamic_cast else enum "
    "errno explicit export extern false float for friend goto if imaginary inline int linux long main "
    "mutable namespace new noexcept noreturn not not_eq nullptr offsetof operator or or_eq private "
    "protected public register reinterpret_cast requires restrict return short signbit signed sizeof "
    "static static_assert static_cast std stderr stdin stdout struct switch template this "
    "thread_local throw true try typedef typeid typename typeof typeof_unqual union unix unsigned "
    "using virtual void volatile wchar_t while xor xor_eq ";

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

bool is_of_names(char letter)
{
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || is_digit(letter) ||
           letter == '_';
}

/// What is wrong with a name; empty if nothing is.
std::string fault(std::string_view name)
{
    if (name.empty() || !std::ranges::all_of(name, is_of_names) || is_digit(name.front()))
        return "write letters, digits and _, a letter first";
    if (name.front() == '_' || name.back() == '_' || name.find("__") != name.npos)
        return "_ stands alone between others; such names belong to the compiler";
    if (name == "kfast" || name.starts_with("kfast_"))
        return "kfast and what begins with kfast_ are names of the library";
    if (taken.find(' ' + std::string{name} + ' ') != taken.npos)
        return "the word means something else in C or C++";
    return name.size() > longest_name ? "at most " + std::to_string(longest_name) + " letters" : "";
}

}

const std::string& checked_c_name(const std::string& name)
{
    const std::string wrong = fault(name);
    if (!wrong.empty())
        throw CLI::ValidationError("--array-name",
                                   in_quotes(name) + " cannot be the name of an array: " + wrong);
    return name;
}

std::string c_name_for(const std::string& file)
{
    std::string name;
    for (const char letter : std::filesystem::path{file}.stem().string()) {
        if (is_of_names(letter) && letter != '_')
            name += letter;
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    if (name.ends_with('_'))
        name.pop_back();
    const std::string wrong = fault(name);
    if (!wrong.empty())
        throw Failure(file + ": this name makes none for an array (" + in_quotes(name) + ": " + wrong +
                      "): choose one with --array-name");
    return name;
}

}
