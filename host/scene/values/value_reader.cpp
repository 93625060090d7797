#include "host/scene/values/value_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/text/characters.hpp"
#include "host/words/scene_words.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::scene {

static_assert(schema::max_name_bytes == kfb::max_name_bytes);

namespace {

/// A number of frames or of this many milliseconds.
struct Unit {
    std::string_view name;
    double milliseconds;
};

constexpr std::array units{Unit{"s", 1000}, Unit{"ms", 1}};

std::optional<double> ticks_per(const kdl::Value& value, SceneContext& context)
{
    if (!value.type)
        return Time::ticks_per_frame;
    std::array<std::string_view, units.size()> known;
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (units[i].name == *value.type)
            return units[i].milliseconds * context.frame_rate * Time::ticks_per_frame / 1e6;
        known[i] = units[i].name;
    }
    context.report.error(value.place, "unknown unit " + in_quotes(*value.type),
                         suggestion(*value.type, known) + " (frames have no unit)");
    return std::nullopt;
}

/// The hint for an unknown colour: "orangered", "linear-gradient(red, blue)", "rgb(1,2,3)".
std::string hint_of(std::string_view colour, const Palette& palette)
{
    const std::string_view function = colour.substr(0, std::min(colour.find('('), colour.size()));
    if (std::string absent = hint_of_absent(function); !absent.empty())
        return absent;
    if (function != colour)
        return "write \"#rrggbb\"";
    if (std::string close = did_you_mean(colour, palette.names()); !close.empty())
        return close;
    return suggestion("", palette.common_names()) + ", another colour of CSS, or \"#rrggbb\"";
}

}

std::int32_t thousandths(double number) { return static_cast<std::int32_t>(std::lround(number * 1000)); }

std::optional<Time> read_signed_time(const kdl::Value& value, SceneContext& context)
{
    const auto number = number_of(value, context.report);
    const auto scale = number ? ticks_per(value, context) : std::nullopt;
    if (!scale)
        return std::nullopt;
    const double ticks = *number * *scale;
    if (std::abs(ticks) <= Time::frame(max_frames).ticks)
        return Time{static_cast<std::int32_t>(std::lround(ticks))};
    context.report.error(value.place, "this time is out of range",
                         "allowed: up to " + std::to_string(max_frames) + " frames");
    return std::nullopt;
}

std::optional<Time> read_time(const kdl::Value& value, SceneContext& context)
{
    const auto time = read_signed_time(value, context);
    if (!time || *time >= Time{})
        return time;
    context.report.error(value.place, "a time cannot be negative");
    return std::nullopt;
}

std::string text_of(Time time) { return text_of(in_frames(time)); }

std::optional<std::size_t> read_colour(const kdl::Value& value, SceneContext& context)
{
    if (value.string() == nullptr) {
        context.report.error(value.place, "a colour is expected here", "write its name or \"#rrggbb\"");
        return std::nullopt;
    }
    const auto text = read_text(value, context.report);
    if (!text)
        return std::nullopt;
    const auto colour = context.palette.find(std::string{*text});
    if (!colour) {
        report_unknown_colour(value, *text, context.palette, context);
        return std::nullopt;
    }
    const auto index = context.palette.use(*colour);
    if (!index)
        report_too_many_colours(value.place, context);
    return index;
}

bool report_too_many_colours(SourceSpan place, SceneContext& context)
{
    return context.report.error(place, "too many colours",
                                "a scene holds at most " + std::to_string(max_colours) +
                                    ", background included");
}

void report_unknown_colour(const kdl::Value& value, std::string_view text, const Palette& palette,
                           SceneContext& context)
{
    std::string hexadecimal{'#'};
    hexadecimal += text;
    if (text.starts_with('#'))
        context.report.error(value.place, in_quotes(text) + " is no colour",
                             "write \"#rgb\", \"#rrggbb\" or, with opacity, \"#rgba\", \"#rrggbbaa\"");
    else if (text.size() >= 6 && hex_colour(hexadecimal))
        context.report.error(value.place, in_quotes(text) + " is no colour",
                             "write " + in_quotes(hexadecimal) + ", with the quotes");
    else if (text == "none" || text == "transparent")
        context.report.error(value.place, in_quotes(text) + " is no colour",
                             "leave the property out; a colour that is not seen is \"#0000\"");
    else
        context.report.error(value.place, "unknown colour " + in_quotes(text), hint_of(text, palette));
}

std::optional<Loop> read_loop(const kdl::Value& value, SceneContext& context)
{
    return read_word(value, loops, context.report);
}

}
