#include "host/svg/poses/part_match.hpp"

#include "host/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::svg {

namespace {

constexpr std::array<std::string_view, 30> made_up_stems{
    "",       "circle",  "clip", "clippath", "ellipse", "fill",    "frame",    "g",    "group",     "id",
    "image",  "layer",   "line", "mask",     "path",    "polygon", "polyline", "rect", "rectangle", "shape",
    "stroke", "surface", "svg",  "svgid",    "switch",  "symbol",  "union",    "use",  "vector",    "xmlid"};

const std::string& author_name(const Part& part)
{
    static const std::string none;
    if (!part.label.empty())
        return part.label;
    return is_made_up(part.id) ? none : part.id;
}

/// Whether they match by order alone: not if an author has given them different names.
bool may_be_same(const Part& left, const Part& right)
{
    const std::string& one = author_name(left);
    const std::string& other = author_name(right);
    return left.kind == right.kind && left.is_group == right.is_group &&
           (one.empty() || other.empty() || one == other);
}

/// Adds one drawing after the other.
class Matcher {
public:
    explicit Matcher(std::size_t drawings) : drawings_{drawings} {}

    void add(std::size_t drawing, const Part& group)
    {
        drawing_ = drawing;
        std::vector<std::size_t> lanes(group.parts.size(), none); ///< of each part
        by_name(group, lanes, &Part::id);
        by_name(group, lanes, &Part::label);
        by_order(group, lanes);
        put_in_new(group, lanes);
        if (result_.reordered == 0 && !std::ranges::is_sorted(lanes))
            result_.reordered = drawing;
    }

    PartMatch take() { return std::move(result_); }

private:
    static constexpr auto none = static_cast<std::size_t>(-1);

    /// The part in the last drawing that has it.
    static const Part& latest(const PartLane& lane)
    {
        return **std::ranges::find_if(lane.rbegin(), lane.rend(),
                                      [](const Part* part) { return part != nullptr; });
    }

    bool is_free(std::size_t lane) const { return result_.lanes[lane][drawing_] == nullptr; }

    void put(const Part& part, std::size_t lane, std::size_t& place)
    {
        result_.lanes[lane][drawing_] = &part;
        place = lane;
    }

    void by_name(const Part& group, std::vector<std::size_t>& lanes, std::string Part::*name)
    {
        std::map<std::string_view, std::size_t> named;
        for (std::size_t lane = 0; lane < result_.lanes.size(); ++lane)
            if (const Part& part = latest(result_.lanes[lane]); is_free(lane) && !(part.*name).empty())
                named.emplace(part.*name, lane);
        for (std::size_t i = 0; i < group.parts.size(); ++i) {
            const Part& part = group.parts[i];
            const auto found = named.find(part.*name);
            if (lanes[i] == none && found != named.end() && is_free(found->second) &&
                latest(result_.lanes[found->second]).is_group == part.is_group)
                put(part, found->second, lanes[i]);
        }
    }

    void by_order(const Part& group, std::vector<std::size_t>& lanes)
    {
        constexpr std::size_t max_tries = 256; // for many dissimilar ones in a row
        std::vector<std::size_t> free;
        for (std::size_t lane = 0; lane < result_.lanes.size(); ++lane)
            if (is_free(lane))
                free.push_back(lane);
        for (std::size_t i = 0; i < group.parts.size() && !free.empty(); ++i) {
            if (lanes[i] != none)
                continue;
            const auto end = free.begin() + static_cast<std::ptrdiff_t>(std::min(free.size(), max_tries));
            const auto found = std::find_if(free.begin(), end, [&](std::size_t lane) {
                return may_be_same(latest(result_.lanes[lane]), group.parts[i]);
            });
            if (found == end)
                continue;
            put(group.parts[i], *found, lanes[i]);
            free.erase(found);
        }
    }

    /// Puts new parts above what each of them is on in its own drawing.
    void put_in_new(const Part& group, std::vector<std::size_t>& lanes)
    {
        std::size_t place = 0;
        for (std::size_t i = 0; i < group.parts.size(); ++i) {
            if (lanes[i] == none) {
                for (std::size_t& lane : lanes)
                    lane += lane != none && lane >= place ? 1 : 0;
                result_.lanes.insert(result_.lanes.begin() + static_cast<std::ptrdiff_t>(place),
                                     PartLane(drawings_));
                put(group.parts[i], place, lanes[i]);
            }
            place = lanes[i] + 1;
        }
    }

    std::size_t drawings_;
    std::size_t drawing_ = 0;
    PartMatch result_;
};

}

bool is_made_up(std::string_view id)
{
    const std::size_t end = id.find_last_not_of("0123456789-_. ");
    std::string stem{id.substr(0, end == id.npos ? 0 : end + 1)};
    std::ranges::transform(stem, stem.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    std::erase_if(stem, [](char letter) { return letter >= '0' && letter <= '9'; });
    return std::ranges::find(made_up_stems, stem) != made_up_stems.end();
}

PartMatch matched(std::span<const Part* const> groups)
{
    Matcher matcher{groups.size()};
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (groups[i] != nullptr)
            matcher.add(i, *groups[i]);
    return matcher.take();
}

namespace {

/// What is reported about a pair of parts.
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

/// The first of the guesses.
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
