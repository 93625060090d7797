#include "host/svg/style/style.hpp"

#include "host/svg/markup/length.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace kfast::svg {

namespace {

constexpr auto read = Care::read;
constexpr auto silent = Care::silent;
constexpr auto reported = Care::reported;

constexpr std::array properties = std::to_array<Property>({
    {"clip-path", read},
    {"clip-rule", silent, true},
    {"color", read, true},
    {"cx", read},
    {"cy", read},
    {"d", read},
    {"display", read},
    {"fill", read, true},
    {"fill-opacity", read, true},
    {"fill-rule", read, true},
    {"font-size", read, true},
    {"height", read},
    {"marker", read},
    {"marker-end", read, true},
    {"marker-mid", read, true},
    {"marker-start", read, true},
    {"mask", read},
    {"opacity", read},
    {"overflow", read},
    {"paint-order", read, true},
    {"r", read},
    {"rx", read},
    {"ry", read},
    {"stop-color", read},
    {"stop-opacity", read},
    {"stroke", read, true},
    {"stroke-dasharray", read, true},
    {"stroke-dashoffset", read, true},
    {"stroke-linecap", read, true},
    {"stroke-linejoin", read, true},
    {"stroke-miterlimit", read, true},
    {"stroke-opacity", read, true},
    {"stroke-width", read, true},
    {"transform", read},
    {"transform-box", read},
    {"transform-origin", read},
    {"vector-effect", read},
    {"visibility", read, true},
    {"width", read},
    {"x", read},
    {"y", read},

    {"animation", reported, false, "none", "it does not move"},
    {"animation-name", reported, false, "none", "it does not move"},
    {"backdrop-filter", reported, false, "none", "nothing is filtered"},
    {"filter", reported, false, "none", "drawn without it"},
    {"mix-blend-mode", reported, false, "normal", "drawn over what lies below"},
    {"offset-path", reported, false, "none", "it stays in its place"},
    {"perspective", reported, false, "none", "seen flat"},
    {"rotate", reported, false, "none", "not turned; write it as a transform"},
    {"scale", reported, false, "none", "not scaled; write it as a transform"},
    {"translate", reported, false, "none", "not moved; write it as a transform"},
});

/// Properties of texts, of rendering speed and quality, of pointers and of pages.
constexpr std::array<std::string_view, 30> silent_beginnings{
    "-",        "alignment-", "animation-", "background", "baseline-",  "block-",    "border", "box-",
    "color-",   "cursor",     "direction",  "dominant-",  "enable-",    "flood-",    "font",   "glyph-",
    "image-",   "inline-",    "isolation",  "kerning",    "letter-",    "lighting-", "line-",  "mask-type",
    "pointer-", "shape-",     "solid-",     "text",       "transition", "word-"};
constexpr std::array<std::string_view, 17> silent_names{
    "all",         "content",     "margin",       "max-width", "min-width",      "outline",
    "padding",     "position",    "speak",        "tab-size",  "user-select",    "unicode-bidi",
    "white-space", "will-change", "writing-mode", "z-index",   "shape-rendering"};

constexpr std::array<std::string_view, 32> attributes{"class",
                                                      "dx",
                                                      "dy",
                                                      "externalResourcesRequired",
                                                      "gradientTransform",
                                                      "gradientUnits",
                                                      "href",
                                                      "id",
                                                      "lang",
                                                      "name",
                                                      "nonce",
                                                      "offset",
                                                      "pathLength",
                                                      "points",
                                                      "preserveAspectRatio",
                                                      "requiredExtensions",
                                                      "requiredFeatures",
                                                      "role",
                                                      "spreadMethod",
                                                      "style",
                                                      "systemLanguage",
                                                      "tabindex",
                                                      "target",
                                                      "type",
                                                      "version",
                                                      "viewBox",
                                                      "x1",
                                                      "x2",
                                                      "y1",
                                                      "y2",
                                                      "zoomAndPan",
                                                      "baseProfile"};

bool is_silent(std::string_view name)
{
    return std::ranges::any_of(silent_beginnings,
                               [&](auto beginning) { return name.starts_with(beginning); }) ||
           std::ranges::find(silent_names, name) != silent_names.end();
}

}

Property property_of(std::string_view name)
{
    const auto found = std::ranges::find(properties, name, &Property::name);
    if (found != properties.end())
        return *found;
    return {name, is_silent(name) ? silent : Care::unknown};
}

bool is_known_attribute(std::string_view name)
{
    return name.find(':') != name.npos || name.starts_with("xmlns") || name.starts_with("data-") ||
           name.starts_with("aria-") || std::ranges::find(attributes, name) != attributes.end() ||
           property_of(name).care != Care::unknown;
}

namespace {

/// The declarations of an element itself, the winner last.
std::vector<Declaration> said(pugi::xml_node element, StyleSheet& sheet)
{
    std::vector<Declaration> result;
    for (const auto attribute : element.attributes())
        if (property_of(attribute.name()).care != Care::unknown)
            result.push_back({attribute.name(), attribute.value(), false});
    for (const Rule* rule : sheet.matching(element))
        result.insert(result.end(), rule->declarations->begin(), rule->declarations->end());
    for (Declaration& own : declarations(element.attribute("style").value()))
        result.push_back(std::move(own));
    std::stable_partition(result.begin(), result.end(),
                          [](const Declaration& each) { return !each.important; });
    return result;
}

bool is_custom(std::string_view property) { return property.starts_with("--"); }

/// "marker" is a shorthand for three properties.
void add(std::vector<Declaration>& all, const Declaration& each)
{
    if (each.property != "marker") {
        all.push_back(each);
        return;
    }
    for (const char* name : {"marker-start", "marker-mid", "marker-end"})
        all.push_back({name, each.value, each.important});
}

}

Style::Style(const Style& outer, pugi::xml_node element, StyleSheet& sheet)
{
    for (const auto& [name, value] : outer.values_)
        if (is_custom(name) || property_of(name).inherited)
            values_.emplace(name, value);
    std::vector<Declaration> all;
    for (const Declaration& each : said(element, sheet))
        add(all, each);
    for (const Declaration& each : all) {
        const bool inherits =
            each.value == "inherit" || (each.value == "unset" && property_of(each.property).inherited);
        if (inherits)
            set(each.property, outer[each.property]);
        else if (each.value == "initial" || each.value == "unset")
            values_.erase(each.property);
        else
            set(each.property, each.value);
    }
    if ((*this)["color"] == "currentColor")
        set("color", outer["color"]);
    put_in_custom_properties();
}

std::string_view Style::operator[](std::string_view property) const
{
    const auto found = values_.find(property);
    return found == values_.end() ? std::string_view{} : found->second;
}

std::string_view Style::get(std::string_view property, std::string_view default_value) const
{
    const std::string_view value = (*this)[property];
    return value.empty() ? default_value : value;
}

void Style::set(const std::string& property, std::string_view value)
{
    values_.insert_or_assign(property, std::string{value});
}

std::size_t Style::bytes() const
{
    std::size_t sum = 0;
    for (const auto& [name, value] : values_)
        sum += value.size();
    return sum;
}

/// Replaces "var(--name, fallback)" as a whole value; the value of a variable may be one itself.
void Style::put_in_custom_properties()
{
    for (auto& [name, value] : values_)
        for (int deep = 0; deep < 8 && value.starts_with("var(") && value.ends_with(')'); ++deep) {
            const std::string_view inside = std::string_view{value}.substr(4, value.size() - 5);
            const std::size_t comma = std::min(inside.find(','), inside.size());
            const std::string_view held = (*this)[trimmed(inside.substr(0, comma))];
            value =
                std::string{held.empty() && comma < inside.size() ? trimmed(inside.substr(comma + 1)) : held};
        }
}

void Style::report(const std::string& layer, art::Losses& losses) const
{
    for (const auto& [name, value] : values_) {
        if (is_custom(name))
            continue;
        const Property property = property_of(name);
        if (property.care == Care::unknown)
            losses.add({"property \"" + shortened(name) + '"', layer, {}, "it is ignored"});
        else if (property.care == Care::reported && !value.empty() && value != property.default_value)
            losses.add({name, layer, {}, std::string{property.instead}});
        if (value.find("var(") != value.npos || value.find("calc(") != value.npos)
            losses.add({name + ": " + shortened(value), layer, {}, "it is as if it were not set"});
    }
}

}
