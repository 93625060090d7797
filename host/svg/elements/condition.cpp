#include "host/svg/elements/condition.hpp"

#include "host/svg/markup/length.hpp"
#include "host/svg/markup/shortened.hpp"

#include <algorithm>
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

}
