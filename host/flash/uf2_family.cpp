#include "host/flash/uf2_family.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace kfast {
namespace {

bool is_same_letter(char one, char other)
{
    return std::tolower(static_cast<unsigned char>(one)) == std::tolower(static_cast<unsigned char>(other));
}

}

std::string_view uf2_family_name(std::uint32_t id)
{
    const auto* const known = std::ranges::find(uf2_families, id, &Uf2Family::id);
    return known == uf2_families.end() ? std::string_view{} : known->name;
}

std::optional<std::uint32_t> uf2_family_called(std::string_view text)
{
    for (const auto& [id, name] : uf2_families)
        if (std::ranges::equal(text, name, is_same_letter))
            return id;
    if (!text.starts_with("0x"))
        return std::nullopt;
    const std::string_view digits = text.substr(2);
    std::uint32_t id = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), id, 16);
    return error == std::errc{} && end == digits.data() + digits.size() ? std::optional{id} : std::nullopt;
}

}
