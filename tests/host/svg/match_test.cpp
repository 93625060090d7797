#include "host/svg/poses/part_match.hpp"

#include <doctest/doctest.h>
#include <string>
#include <utility>
#include <vector>

using namespace kfast::svg;

namespace {

struct Named {
    std::string id;
    std::string label = {};
    std::string kind = "path";
};

Part group(const std::vector<Named>& parts)
{
    Part result;
    result.is_group = true;
    for (const Named& named : parts) {
        Part part;
        part.id = named.id;
        part.label = named.label;
        part.kind = named.kind;
        part.is_group = named.kind == "g";
        result.parts.push_back(std::move(part));
    }
    return result;
}

/// For each lane, the indices of its parts in their drawings, '-' where there is none: "00 1-".
std::string lanes(const std::vector<Part>& groups)
{
    std::vector<const Part*> pointers;
    pointers.reserve(groups.size());
    for (const Part& each : groups)
        pointers.push_back(&each);
    std::string result;
    for (const PartLane& lane : matched(pointers).lanes) {
        result += result.empty() ? "" : " ";
        for (std::size_t i = 0; i < lane.size(); ++i)
            result += lane[i] == nullptr ? '-' : static_cast<char>('0' + (lane[i] - groups[i].parts.data()));
    }
    return result;
}

}

TEST_CASE("parts are the same by their ids, wherever they lie")
{
    CHECK(lanes({group({{"a"}, {"b"}}), group({{"b"}, {"a"}})}) == "01 10");
    CHECK(lanes({group({{"a"}, {"b"}}), group({{"b"}})}) == "0- 10");
    CHECK(lanes({group({{"a", "", "g"}}), group({{"a", "", "path"}})}) == "-0 0-");
    CHECK(lanes({group({{"a", "", "rect"}}), group({{"a", "", "path"}})}) == "00");
}

TEST_CASE("else by their labels")
{
    CHECK(lanes({group({{"path1", "eye"}, {"path2", "nose"}}),
                 group({{"path8", "nose"}, {"path9", "eye"}})}) == "01 10");
}

TEST_CASE("else by their order among their kind")
{
    CHECK(lanes({group({{"path1"}, {"rect1", "", "rect"}, {"path2"}}),
                 group({{"rect9", "", "rect"}, {"path8"}, {"path9"}})}) == "01 10 22");
    CHECK(lanes({group({{""}, {""}}), group({{""}})}) == "00 1-");
}

TEST_CASE("what an author has named differently is not the same")
{
    CHECK(lanes({group({{"tail"}}), group({{"hat"}})}) == "-0 0-");
    CHECK(lanes({group({{"path1", "tail"}}), group({{"path2", "hat"}})}) == "-0 0-");
    CHECK(lanes({group({{"tail"}}), group({{"path2"}})}) == "00");
}

TEST_CASE("what comes in later lies above what it lies on there")
{
    CHECK(lanes({group({{"a"}, {"b"}}), group({{"a"}, {"x"}, {"b"}})}) == "00 -1 12");
    CHECK(lanes({group({{"a"}, {"b"}}), group({{"a"}}), group({{"a"}, {"b"}})}) == "000 1-1");
}

TEST_CASE("ids that programs make up")
{
    for (const char* id :
         {"", "path12", "g4-5", "Layer_1", "rect1-2-3", "XMLID_1_", "Group 3", "Vector", "12"})
        CHECK_MESSAGE(is_made_up(id), id);
    for (const char* id : {"eye", "left-arm", "path-of-glory", "eye2"})
        CHECK_MESSAGE(!is_made_up(id), id);
}
