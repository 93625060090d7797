#include "host/commands/import_options.hpp"

#include "host/commands/number_range.hpp"
#include "host/commands/size_text.hpp"
#include "host/import/canvas_size.hpp"
#include "host/scene/palette.hpp"

#include <algorithm>
#include <string>

namespace kfast {
namespace {

constexpr const char* group = "Files of other programs (docs/import.md)";

constexpr double widest_tolerance = 64;

Size canvas_size(const std::string& text)
{
    const Size size = read_size("--size", text);
    if (std::max(size.width, size.height) > importing::longest_side)
        throw CLI::ValidationError("--size", "'" + text + "' is too large: a canvas has sides of at most " +
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

void declare_import_options(CLI::App& app, ImportChoice& choice)
{
    app.add_option("--tolerance", choice.options.tolerance,
                   "How far simplification may move anything, in pixels of the canvas (default: 1/32)")
        ->type_name("PX")
        ->check(number_within(0, widest_tolerance))
        ->group(group);
    app.add_option_function<std::string>(
           "--size", [&choice](const std::string& text) { choice.options.size = canvas_size(text); },
           "Scale it so that its canvas just lies within this (default: as it is)")
        ->type_name("WxH")
        ->group(group);
    app.add_option_function<std::string>(
           "--background",
           [&choice](const std::string& text) { choice.options.background = background(text); },
           "Behind a file that says nothing of its background (default: white for SVG, otherwise black)")
        ->type_name("COLOR")
        ->group(group);
    app.add_option("--animation", choice.options.animation,
                   "Which one of a .lottie file that has several (default: the one it begins with)")
        ->type_name("ID")
        ->group(group);
    app.add_flag_callback(
           "--strict", [&choice] { choice.on_loss = OnLoss::refuse; },
           "Refuse a file of which something is not carried over")
        ->group(group);
}

}
