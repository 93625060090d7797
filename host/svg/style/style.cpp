#include "host/svg/style/style.hpp"

#include "host/svg/markup/length.hpp"
#include "host/svg/markup/shortened.hpp"
#include "host/svg/style/properties.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace kfast::svg {
namespace {

/// What an element itself says, the winner last.
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

/// "marker" stands for three properties.
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

/// "var(--name, fallback)" as a whole value; what a variable holds may be one itself.
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
