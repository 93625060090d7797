#include "host/preview/playback/time_table.hpp"

#include "tests/host/preview/named_scene.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr const char* theatre = R"(kfast 1
canvas 60 40 frames=40
bones arm {
    bone upper 20 20 30 20 { bone lower 30 20 40 20 }
    pose 0 rest; pose 12 { upper turn=20 }; pose 30 { lower turn=10 }
}
symbol tree { object trunk fill=red { key 3 { rect 0 0 4 4 }; key 9 { rect 0 0 6 6 } } }
object ground fill=green { rect 0 30 60 10 }
group puppet {
    key 0 x=0; key 25 x=5
    object sleeve fill=blue skin=arm bone=upper { rect 20 18 10 4 }
}
use tree
use tree { key 0 y=0; key 7 y=4 }
clip wave from=10 to=20 loop=repeat
event 15 hello
)";

/// "puppet 1: 0 25"
std::vector<std::string> in_words(const TimeTable& table)
{
    std::vector<std::string> words;
    for (const TimeRow& row : table.rows) {
        std::string line = row.name + ' ' + std::to_string(row.depth) + ':';
        for (const Time key : row.keys)
            line += ' ' + std::to_string(key.ticks / Time::ticks_per_frame);
        words.push_back(line);
    }
    return words;
}

}

TEST_CASE("rows of items, the topmost first, with the keys of all that moves them")
{
    const NamedScene scene{theatre};
    const TimeTable table = time_table(scene.view(), scene.names());
    CHECK(in_words(table) == std::vector<std::string>{"tree 0: 0 7", "trunk 1: 3 9", "tree 0:",
                                                      "puppet 0: 0 25", "sleeve 1: 0 12 30", "ground 0: 0"});
    for (const TimeRow& row : table.rows)
        CHECK(scene.names()[row.item] == row.name);
    CHECK(table.end == Time::frame(40));
    REQUIRE(table.clips.size() == 1);
    CHECK(table.clips[0].name == "wave");
    CHECK(table.clips[0].stretch.begin == Time::frame(10));
    CHECK(table.clips[0].stretch.end == Time::frame(20));
    REQUIRE(table.events.size() == 1);
    CHECK(table.events[0].name == "hello");
    CHECK(table.events[0].time == Time::frame(15));
}

TEST_CASE("what is unfolded has a row for each of its quantities below it")
{
    const NamedScene scene{theatre};
    const TimeTable table = time_table(scene.view(), scene.names());
    CHECK(with_quantities(table, {}).rows.size() == table.rows.size());
    const TimeTable whole =
        with_quantities(table, {table.row_named("sleeve")->item, table.row_named("puppet")->item});
    CHECK(in_words(whole) ==
          std::vector<std::string>{"tree 0: 0 7", "trunk 1: 3 9", "tree 0:", "puppet 0: 0 25", "x 1: 0 25",
                                   "sleeve 1: 0 12 30", "shape 2: 0", "bones 2: 0 12 30", "ground 0: 0"});
    CHECK(whole.rows[3].is_unfolded);
    CHECK_FALSE(whole.rows[1].is_unfolded);
    CHECK(whole.rows[4].is_quantity);
    CHECK(whole.rows[4].item == whole.rows[3].item);
    CHECK_FALSE(whole.rows[2].can_unfold());
}

TEST_CASE("items of a compiled scene have numbers for names")
{
    const NamedScene scene{theatre};
    const TimeTable table = time_table(scene.view(), {});
    std::vector<std::string> names;
    for (const TimeRow& row : table.rows)
        names.push_back(row.name);
    CHECK(names == std::vector<std::string>{"use of symbol 1", "object 1", "use of symbol 1", "group",
                                            "object 3", "object 2"});
}

}
