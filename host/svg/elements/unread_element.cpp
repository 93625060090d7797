#include "host/svg/elements/unread_element.hpp"

#include "host/svg/markup/length.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/style/style.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace kfast::svg {

namespace {

bool is_english(std::string_view language)
{
    const std::string_view beginning = language.substr(0, language.find('-'));
    return beginning == "en" || beginning == "EN" || beginning == "En";
}

bool has_english(std::string_view languages)
{
    while (!languages.empty()) {
        const std::size_t end = std::min(languages.find(','), languages.size());
        if (is_english(trimmed(languages.substr(0, end))))
            return true;
        languages.remove_prefix(std::min(end + 1, languages.size()));
    }
    return false;
}

std::string text_of(const pugi::xml_attribute& attribute)
{
    return std::string{attribute.name()} + " \"" + shortened(attribute.value()) + '"';
}

}

std::string unmet_condition(pugi::xml_node element)
{
    if (const auto languages = element.attribute("systemLanguage");
        languages && !has_english(languages.value()))
        return text_of(languages);
    if (const auto extensions = element.attribute("requiredExtensions"); *extensions.value() != '\0')
        return text_of(extensions);
    return {};
}

namespace {

/// What others refer to, or what is never visible.
constexpr std::array<std::string_view, 25> unseen{
    "clipPath",     "color-profile", "cursor",  "defs",           "desc",       "filter", "font",
    "font-face",    "glyph",         "hatch",   "linearGradient", "marker",     "mask",   "mesh",
    "meshgradient", "metadata",      "pattern", "radialGradient", "solidColor", "stop",   "style",
    "symbol",       "title",         "view",    "solidcolor"};

struct Unread {
    std::string_view name;
    std::string_view instead;
};
constexpr std::array<Unread, 12> unread{{{"image", "nothing: only shapes are drawn"},
                                         {"foreignObject", "nothing: only shapes are drawn"},
                                         {"video", "nothing: only shapes are drawn"},
                                         {"audio", "silence"},
                                         {"canvas", "nothing: only shapes are drawn"},
                                         {"iframe", "nothing: only shapes are drawn"},
                                         {"script", "it does not run"},
                                         {"animate", "its values at rest"},
                                         {"animateColor", "its values at rest"},
                                         {"animateMotion", "it stays in its place"},
                                         {"animateTransform", "its values at rest"},
                                         {"set", "its values at rest"}}};

struct Words : pugi::xml_tree_walker {
    bool for_each(pugi::xml_node& node) override
    {
        if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata)
            text += std::string{text.empty() ? "" : " "} + std::string{trimmed(node.value())};
        return true;
    }
    std::string text;
};

std::string schema_of(pugi::xml_node element)
{
    Words words;
    element.traverse(words);
    return shortened(words.text);
}

}

void report_unread(pugi::xml_node element, const std::string& layer, art::Losses& losses)
{
    const std::string name{element_name(element)};
    if (name.empty() || std::ranges::find(unseen, name) != unseen.end())
        return;
    if (name == "text") {
        losses.add({"text \"" + schema_of(element) + '"', layer, {}, "nothing: turn it into a path"});
        return;
    }
    const auto known = std::ranges::find(unread, name, &Unread::name);
    losses.add({'<' + shortened(name) + '>',
                layer,
                {},
                std::string{known == unread.end() ? "nothing" : known->instead}});
}

void report_content(pugi::xml_node element, const std::string& layer, art::Losses& losses)
{
    for (const pugi::xml_node child : element.children())
        report_unread(child, layer, losses);
}

void report_attributes(pugi::xml_node element, const std::string& layer, art::Losses& losses)
{
    for (const auto attribute : element.attributes()) {
        const std::string_view name = attribute.name();
        if (name.starts_with("on"))
            losses.add({"script of \"" + shortened(name) + '"', layer, {}, "it does not run"});
        else if (!is_known_attribute(name))
            losses.add({"attribute \"" + shortened(name) + '"', layer, {}, "it is ignored"});
    }
}

}
