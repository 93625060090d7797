#include "host/svg/poses/match_hint.hpp"

#include "host/svg/poses/part_match.hpp"
#include "host/text/counted.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace kfast::svg {
namespace {

/// What is said of a pair of parts.
struct Guess {
    const Part* before = nullptr;
    const Part* after = nullptr;
};

bool have_common_name(const Part& left, const Part& right)
{
    return (!left.id.empty() && left.id == right.id) || (!left.label.empty() && left.label == right.label);
}

bool is_guess(const Part& left, const Part& right)
{
    return !left.is_group && !have_common_name(left, right) && !(left.drawing == right.drawing);
}

std::vector<const Part*> there(const PartLane& lane)
{
    std::vector<const Part*> parts;
    std::ranges::copy_if(lane, std::back_inserter(parts), [](const Part* part) { return part != nullptr; });
    return parts;
}

/// The first of them.
Guess guess_in(std::span<const Part* const> groups)
{
    for (const PartLane& lane : matched(groups).lanes) {
        const std::vector<const Part*> parts = there(lane);
        if (parts.front()->is_group)
            if (const Guess inner = guess_in(parts); inner.before != nullptr)
                return inner;
        for (std::size_t i = 1; i < parts.size(); ++i)
            if (is_guess(*parts[i - 1], *parts[i]))
                return {parts[i - 1], parts[i]};
    }
    return {};
}

std::string outlines_of(const Part& part) { return counted(part.drawing.outlines.size(), "outline"); }

}

std::string match_hint(std::span<const Pose> poses)
{
    std::vector<const Part*> roots;
    for (const Pose& pose : poses)
        roots.push_back(&pose.root);
    const auto [before, after] = guess_in(roots);
    if (before == nullptr)
        return {};
    const std::string form = before->drawing.outlines.size() == after->drawing.outlines.size()
                                 ? ""
                                 : " (of " + outlines_of(*before) + ", and of " + outlines_of(*after) +
                                       ": one path each would keep them apart)";
    return "parts are taken for the same by their order alone, the first \"" + before->name + '"' + form +
           ": name parts alike (id=\"...\") so that they become each other (docs/import-svg.md)";
}

}
