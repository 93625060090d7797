#include "host/commands/import/import_options.hpp"

#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/import/extent.hpp"
#include "host/scene/context/palette.hpp"
#include "host/scene/values/law_reader.hpp"
#include "host/schema/report.hpp"
#include "host/words/law_words.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

namespace {

VelocityLaw read_law(const std::string& option, const std::string& text)
{
    const SourceText source{.name = option, .text = text};
    Diagnostics diagnostics;
    schema::Report report{source, diagnostics};
    const kdl::Value value{.type = {}, .data = text, .place = {0, text.size()}, .text_offset = 0};
    if (const auto law = scene::read_law(value, report))
        return *law;
    const Diagnostic first = diagnostics.sorted().front();
    throw CLI::ValidationError(option, first.message + (first.hint.empty() ? "" : ": " + first.hint));
}

double control(std::int16_t number) { return static_cast<double>(number) / VelocityLaw::control_one; }

}

namespace {

bool is_importable(VelocityLaw::Kind kind)
{
    return kind == VelocityLaw::Kind::constant || kind == VelocityLaw::Kind::hold ||
           kind == VelocityLaw::Kind::bezier;
}

/// "constant, hold, ease or bezier(x1,y1,x2,y2)"
std::string importable_laws()
{
    std::vector<std::string_view> forms;
    for (const LawWord& word : law_words)
        if (is_importable(word.law.kind))
            forms.push_back(word.form);
    std::string text;
    for (const std::string_view form : forms)
        text.append(text.empty() ? "" : form == forms.back() ? " or " : ", ").append(form);
    return text;
}

}

art::Ease read_ease(const std::string& option, const std::string& text)
{
    const VelocityLaw law = read_law(option, text);
    switch (law.kind) {
    case VelocityLaw::Kind::constant:
        return {};
    case VelocityLaw::Kind::hold:
        return {.kind = art::EaseKind::hold};
    case VelocityLaw::Kind::bezier:
        return {art::EaseKind::cubic, control(law.x1), control(law.y1), control(law.x2), control(law.y2)};
    case VelocityLaw::Kind::accelerate:
    case VelocityLaw::Kind::decelerate:
    case VelocityLaw::Kind::accelerate_decelerate:
    case VelocityLaw::Kind::steps:
    case VelocityLaw::Kind::bounce:
    case VelocityLaw::Kind::spring:
        break;
    }
    throw CLI::ValidationError(option, '\'' + text + "' cannot be imported: take " + importable_laws());
}

namespace {

constexpr double widest_tolerance = 64;

Size canvas_size(const std::string& text)
{
    const Size size = read_size("--canvas", text);
    if (std::max(size.width, size.height) > importing::longest_side)
        throw CLI::ValidationError("--canvas", "'" + text + "' is too large: a canvas has sides of at most " +
                                                   std::to_string(importing::longest_side) + " pixels");
    return size;
}

Colour background(const std::string& text)
{
    const std::optional<Colour> colour = scene::Palette{}.find(text);
    if (!colour)
        throw CLI::ValidationError("--background", '\'' + text +
                                                       "' is no colour: take a name like white or navy, or "
                                                       "red, green and blue like \"#ff8000\"");
    if (colour->opacity != 255)
        throw CLI::ValidationError("--background", "the background cannot be transparent");
    return *colour;
}

}

CLI::Option* reads_scene(CLI::Option* option)
{
    return reads_file(option, {".lottie", ".svg", ".sif", ".kfast", ".kfb", ".json"});
}

void declare_import_options(CLI::App& app, ImportChoice& choice)
{
    importing::Options& options = choice.options;
    const std::array only_for_imports{
        app.add_option("--tolerance", options.tolerance,
                       "How far simplification may move anything, in pixels of the canvas (default: 1/32)")
            ->type_name("PX")
            ->check(number_within(0, widest_tolerance)),
        app.add_option_function<std::string>(
               "--canvas", [&options](const std::string& text) { options.size = canvas_size(text); },
               "Scale it so that its canvas just lies within this (default: as it is)")
            ->type_name("WxH"),
        app.add_option_function<std::string>(
               "--background", [&options](const std::string& text) { options.background = background(text); },
               "Behind a file that says nothing of its background (default: white for SVG, otherwise black)")
            ->type_name("COLOR"),
        app.add_option("--animation", options.animation,
                       "Which one of a .lottie file that has several (default: the one it begins with)")
            ->type_name("ID")};
    for (CLI::Option* option : only_for_imports)
        option->group(option_group::imports)->each([&choice, name = option->get_name()](const std::string&) {
            choice.only_for_imports = name;
        });
    app.add_flag_callback(
           "--strict", [&choice] { choice.on_loss = OnLoss::refuse; },
           "Refuse a file of which something is not carried over")
        ->group(option_group::imports);
}

}
