#include "host/art/prepare/prepare.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace kfast::art {
namespace {

/// A node that moves by as many eases, each only a little unlike the one before it.
Document with_eases(std::size_t count)
{
    std::vector<Key<double>> keys;
    for (std::size_t i = 0; i <= count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count);
        keys.push_back({static_cast<double>(i), part, {EaseKind::cubic, 0.2 + part / 4, 0.1, 0.7, 0.9}});
    }
    Document document;
    document.nodes.resize(1);
    document.nodes[0].transform.x = Channel{std::move(keys)};
    return document;
}

std::size_t different(const Channel& channel)
{
    std::set<double> found;
    for (const auto& key : channel.keys)
        found.insert(key.ease.x1);
    return found.size();
}

TEST_CASE("a document that has few enough eases keeps them")
{
    Document document = with_eases(max_eases - 1);
    const Document before = document;
    Losses losses;
    share_eases(document, losses);
    CHECK(document.nodes == before.nodes);
    CHECK(losses.empty());
}

TEST_CASE("too many eases are shared by those that are near, which is told")
{
    Document document = with_eases(1000);
    const Channel before = document.nodes[0].transform.x;
    Losses losses;
    share_eases(document, losses);
    const Channel& after = document.nodes[0].transform.x;
    CHECK(different(before) == 1001);
    CHECK(different(after) <= max_eases);
    CHECK(different(after) > 8);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].feature == "1001 different eases");
    for (std::size_t i = 0; i < before.keys.size(); ++i)
        CHECK(std::abs(after.keys[i].ease.x1 - before.keys[i].ease.x1) <= 1.0 / 128);
}

}
}
