#include "host/lottie/shapes/shape_members.hpp"

#include "host/text/glyph.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

namespace kfast::lottie {
namespace {

struct TypeMembers {
    std::string_view type;
    std::string_view names; ///< with a blank around each
};

/// Names, identities for expressions, and what tools keep for themselves.
constexpr std::string_view of_all = " ty nm mn hd bm ix ind cix cl ln np ";

constexpr std::array members_of_types{
    TypeMembers{"gr", " it "},
    TypeMembers{"tr", " p a s r o sk sa "},
    TypeMembers{"sh", " ks d closed "},
    TypeMembers{"rc", " p s r d closed "},
    TypeMembers{"el", " p s d closed "},
    TypeMembers{"sr", " sy p pt r or os ir is d closed "},
    TypeMembers{"fl", " c o r fillEnabled "},
    TypeMembers{"st", " c o w lc lj ml ml2 d fillEnabled "},
    TypeMembers{"gf", " g s e t h a o r "},
    TypeMembers{"gs", " g s e t h a o w lc lj ml ml2 d "},
    TypeMembers{"tm", " s e o m "},
    TypeMembers{"rd", " r "},
    TypeMembers{"rp", " c o m tr "},
    TypeMembers{"mm", " mm "},
};

bool holds(std::string_view names, std::string_view name)
{
    return names.find(' ' + std::string{name} + ' ') != names.npos;
}

}

void report_unknown_members(const Json& item, std::string_view type, const Reading& reading)
{
    const auto known = std::ranges::find(members_of_types, type, &TypeMembers::type);
    if (known == members_of_types.end())
        return;
    for (const auto& [name, member] : item.items())
        if (!holds(of_all, name) && !holds(known->names, name))
            reading.losses.add({"member " + in_quotes(name) + " of a shape \"" + std::string{type} + '"',
                                reading.layer, std::nullopt, "it is not looked at"});
}

}
