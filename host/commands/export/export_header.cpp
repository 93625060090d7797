#include "host/commands/export/export_kinds.hpp"

#include "core/math/point.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/text/summary.hpp"
#include "host/compile/scene_file.hpp"
#include "host/file/atomic_file.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/words/scene_words.hpp"
#include "library/kfast.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <span>
#include <string>

namespace kfast {

namespace {

/// The names of a scene as source code.
struct SceneHeader {
    std::string name;   ///< of the array
    std::string source; ///< of the file it was made from
    Size panel;         ///< for which the memory is counted
};

/// What kfast_create() must be lent (library/kfast.h) on the header's panel.
std::size_t block_bytes(const SceneHeader& header, const SceneFile& scene);

constexpr std::size_t bytes_in_a_line = 16;

std::string in_capitals(const std::string& name)
{
    std::string text;
    std::ranges::transform(name, std::back_inserter(text), [](char letter) {
        return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
    });
    return text;
}

/// What kfast_features is to be for the scene, in the order of its members.
std::string features(const std::string& name, FeatureSet needed)
{
    std::string list;
    for (std::size_t number = 0; number < feature_count; ++number) {
        const auto feature = static_cast<Feature>(number);
        list += list.empty() ? "" : ", ";
        list += needed.has(feature) ? "&kfast_" + std::string{feature_name(feature)} : "0";
    }
    return "/* What it needs of the player, for a program that plays nothing else: kfast.h, kfast_features "
           "*/\n#define " +
           in_capitals(name) + "_FEATURES {" + list + "}\n";
}

std::string constant(const std::string& name, std::size_t value)
{
    return name + " = " + std::to_string(value);
}

std::string constants(const SceneHeader& header, const SceneFile& scene)
{
    const auto [width, height] = header.panel;
    return "enum {\n    " + constant(header.name + "_bytes", scene.bytes.size()) + ",\n    " +
           constant(header.name + "_width", static_cast<std::size_t>(width)) + ", /* of the panel */\n    " +
           constant(header.name + "_height", static_cast<std::size_t>(height)) + ",\n    " +
           constant(header.name + "_block_bytes", block_bytes(header, scene)) +
           " /* of memory to be lent: the player and what the scene needs on such a panel */\n};\n";
}

std::string line_of(std::span<const std::byte> bytes)
{
    std::string line = "   ";
    for (const std::byte byte : bytes) {
        char text[8];
        std::snprintf(text, sizeof text, " 0x%02x,", std::to_integer<unsigned>(byte));
        line += text;
    }
    return line + '\n';
}

std::string array(const std::string& name, std::span<const std::byte> bytes)
{
    std::string text = "static const unsigned char " + name + '[' + name + "_bytes] = {\n";
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), bytes_in_a_line)))
        text += line_of(bytes.first(std::min(bytes.size(), bytes_in_a_line)));
    return text + "};\n";
}

std::size_t block_bytes(const SceneHeader& header, const SceneFile& scene)
{
    return kfast_block_bytes(scene.bytes.data(), scene.bytes.size(), header.panel.width, header.panel.height);
}

/// A header for C99 and C++ with the scene as an array, its size, the panel's, and block_bytes(),
/// wherever it is compiled.
std::string header_text(const SceneHeader& header, const SceneFile& scene)
{
    const std::string macro = "KFAST_SCENE_" + in_capitals(header.name) + "_H";
    return "/* " + visible(header.source) + ", written by kfast export */\n#ifndef " + macro + "\n#define " +
           macro + "\n\n" + constants(header, scene) + '\n' +
           features(header.name, scene.view.needed_features()) + '\n' + array(header.name, scene.bytes) +
           "\n#endif\n";
}

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

namespace {

/// The name of an array made from that of a file: "robot_eyes" from "art/robot-eyes.kfast".
/// Throws Failure when that makes none.
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

void export_header(const ExportOptions& options)
{
    const std::string name = options.name ? *options.name : c_name_for(options.scene);
    const SceneFile scene = load_scene(options.scene);
    const std::filesystem::path output = export_path(options, ".h");
    const SceneHeader header{name, std::filesystem::path{options.scene}.filename().string(),
                             panel_size(options.picture, scene.view)};
    const std::string text = header_text(header, scene);
    write_file(output, std::as_bytes(std::span{text}));
    report_stream(options.quiet) << output.string() << ": " << name << "[], " << contents_summary(scene)
                                 << ", " << counted(block_bytes(header, scene), "byte") << " to be lent at "
                                 << header.panel.width << 'x' << header.panel.height
                                 << ", the player included\n";
}

}
