#include "host/flash/uf2_family.hpp"

#include <doctest/doctest.h>

#include <set>

namespace kfast::test {

TEST_CASE("families of chips have names and numbers")
{
    CHECK(uf2_family_name(0xe48bff56) == "RP2040");
    CHECK(uf2_family_name(0x12345678).empty());
    CHECK(uf2_family_called("rp2040") == 0xe48bff56);
    CHECK(uf2_family_called("RP2350-arm-s") == 0xe48bff59);
    CHECK(uf2_family_called("0xE48bff57") == 0xe48bff57);
    for (const char* const wrong : {"", "rp", "rp20400", "0x", "0xe48bff560", "0xg", "0x-1", "3828088662"})
        CHECK_FALSE(uf2_family_called(wrong));
}

TEST_CASE("no family is in the table twice")
{
    std::set<std::uint32_t> ids;
    std::set<std::string_view> names;
    for (const auto& [id, name] : uf2_families) {
        CHECK(ids.insert(id).second);
        CHECK(names.insert(name).second);
    }
}

}
