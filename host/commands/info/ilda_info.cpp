#include "host/commands/info/ilda_info.hpp"

#include "host/beam/ilda_reader.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/file/input_file.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"

#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

constexpr InputKind ilda_input{"ILDA file", "an .ild file", "copy it again", std::size_t{256} << 20};

IldaContents load_ilda(const std::string& path)
try {
    const std::string file = read_input(path, ilda_input);
    return read_ilda(std::as_bytes(std::span{file}));
} catch (const std::invalid_argument& reason) {
    throw Failure(path + ": no proper ILDA file: " + reason.what());
}

/// In percent of the field's side, which is 65536 units.
double percent(double length) { return std::round(length * 1000 / field_side) / 10; }

Json point_facts(FieldPoint at) { return {{"x", at.x}, {"y", at.y}}; }

Json facts_of(const std::string& path, const IldaContents& contents, std::uint32_t rate)
{
    const IldaFacts facts = ilda_facts(contents);
    const IldaFrame& first = contents.frames.front();
    return {{"file", path},
            {"name", first.name},
            {"company", first.company},
            {"formats", facts.formats},
            {"palettes", contents.palettes},
            {"frames", contents.frames.size()},
            {"points", facts.points},
            {"lit_points", facts.lit_points},
            {"most_points", facts.max_points},
            {"rate", rate},
            {"seconds", static_cast<double>(facts.points) / rate},
            {"least", point_facts(facts.min)},
            {"most", point_facts(facts.max)},
            {"longest_lit_step", std::round(facts.longest_lit_step)},
            {"longest_blanked_step", std::round(facts.longest_blanked_step)}};
}

std::string format_list(const Json& formats)
{
    std::string list;
    for (const Json& format : formats)
        list += (list.empty() ? "" : ", ") + std::to_string(format.get<int>());
    return list;
}

std::string range_text(const Json& facts, const char* axis)
{
    return std::to_string(facts["least"][axis].get<int>()) + " to " +
           std::to_string(facts["most"][axis].get<int>());
}

std::string percent_text(const Json& length) { return rounded_text(percent(length.get<double>())) + " %"; }

void print_ilda_facts(const Json& facts)
{
    const auto rate = facts["rate"].get<std::uint32_t>();
    const auto max = facts["most_points"].get<std::size_t>();
    std::cout << facts["file"].get<std::string>() << '\n'
              << "  name        " << visible(facts["name"].get<std::string>()) << ", by "
              << visible(facts["company"].get<std::string>()) << '\n'
              << "  format      " << format_list(facts["formats"]) << ", palettes: " << facts["palettes"]
              << '\n'
              << "  frames      " << facts["frames"] << '\n'
              << "  points      " << facts["points"] << ", " << facts["lit_points"]
              << " of them lit, at most " << max << " in a frame\n"
              << "  length      " << rounded_text(facts["seconds"].get<double>()) << " s at " << rate
              << " points a second, each frame once, at least "
              << rounded_text(std::floor(rate * 10.0 / static_cast<double>(max)) / 10) << " frames a second\n"
              << "  reach       x " << range_text(facts, "x") << ", y " << range_text(facts, "y") << '\n'
              << "  steps       lit up to " << percent_text(facts["longest_lit_step"])
              << " of the field, blanked up to " << percent_text(facts["longest_blanked_step"]) << '\n';
}

}

bool is_ilda(const std::string& path)
{
    std::ifstream file{path, std::ios::binary};
    auto begin = ilda_magic;
    begin.fill(0);
    return file.read(begin.data(), begin.size()) && begin == ilda_magic;
}

void print_ilda_info(const std::string& path, std::uint32_t rate, bool as_json)
{
    const Json facts = facts_of(path, load_ilda(path), rate);
    if (as_json)
        std::cout << json_text(facts);
    else
        print_ilda_facts(facts);
}

}
