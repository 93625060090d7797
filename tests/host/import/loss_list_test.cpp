#include "host/import/loss_list.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using importing::ListLength;
using importing::loss_count;
using importing::loss_list;

TEST_CASE("what is lost in the same way stands together")
{
    art::Losses losses;
    losses.add({"gradient", "body / arm", 10, "its mean colour"});
    losses.add({"blur", "sky", std::nullopt, "sharp edges"});
    losses.add({"gradient", "body / leg", std::nullopt, "its mean colour"});
    losses.add({"themes", "", std::nullopt, "none"});
    losses.add({"loop count", "", 4.5, "for ever"});
    CHECK(loss_count(losses) == "5 things are not carried over");
    CHECK(loss_list(losses, ListLength::cut) == "  gradient: its mean colour\n"
                                                "      body / arm, from frame 10\n"
                                                "      body / leg\n"
                                                "  blur (sky): sharp edges\n"
                                                "  themes: none\n"
                                                "  loop count (from frame 4.5): for ever");
}

TEST_CASE("a long list is cut, and says so")
{
    art::Losses losses;
    for (int number = 0; number < 20; ++number)
        losses.add({"gradient", std::to_string(number), std::nullopt, "its mean colour"});
    const std::string cut = loss_list(losses, ListLength::cut);
    const std::string all = "\n  (all of them: 'kfast check', or 'kfast import --all-losses')";
    CHECK(cut.ends_with("      3\n      and 16 more" + all));
    CHECK(loss_list(losses, ListLength::whole).ends_with("\n      19"));

    art::Losses kinds;
    for (int number = 0; number < 20; ++number)
        kinds.add({std::to_string(number), "a", std::nullopt, "b"});
    CHECK(loss_list(kinds, ListLength::cut).ends_with("  15 (a): b\n  and 4 more kinds of things" + all));
    CHECK(loss_list(kinds, ListLength::whole).ends_with("  19 (a): b"));
}

TEST_CASE("names of layers do nothing to a terminal")
{
    art::Losses losses;
    losses.add({"gra\x1b[2Jdient", "a\nb\xff", std::nullopt, "x\ty"});
    CHECK(loss_list(losses, ListLength::whole) == "  gra<U+001B>[2Jdient (a<U+000A>b<0xFF>): x    y");
    CHECK(loss_count(losses) == "1 thing is not carried over");
}

TEST_CASE("what is beyond the list counts")
{
    art::Losses losses;
    for (std::size_t number = 0; number < art::Losses::max + 5; ++number)
        losses.add({"f", std::to_string(number), std::nullopt, "i"});
    CHECK(loss_count(losses) == "1005 things are not carried over");
    CHECK(loss_list(losses, ListLength::cut).ends_with("\n  and 5 more, too many to keep"));
}
