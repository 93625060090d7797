#include "host/import/loss_list.hpp"

#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

namespace kfast::importing {
namespace {

/// The places where the same is lost in the same way.
struct Kind {
    const art::Loss* first;
    std::vector<std::string> places; ///< without the whole file
};

struct Most {
    std::size_t kinds = std::numeric_limits<std::size_t>::max();
    std::size_t places = std::numeric_limits<std::size_t>::max();
};
constexpr Most on_a_screen{.kinds = 16, .places = 4};

/// "body / arm, from frame 12"; "" for all of the file.
std::string place_of(const art::Loss& loss)
{
    std::ostringstream text;
    text << visible(loss.layer);
    if (loss.time)
        text << (loss.layer.empty() ? "" : ", ") << "from frame " << *loss.time;
    return text.str();
}

std::vector<Kind> kinds_of(const art::Losses& losses)
{
    std::vector<Kind> kinds;
    for (const art::Loss& loss : losses.list()) {
        auto kind = std::ranges::find_if(kinds, [&loss](const Kind& known) {
            return known.first->feature == loss.feature && known.first->instead == loss.instead;
        });
        if (kind == kinds.end())
            kind = kinds.insert(kind, {&loss, {}});
        if (std::string place = place_of(loss); !place.empty())
            kind->places.push_back(std::move(place));
    }
    return kinds;
}

std::string text_of(const Kind& kind, std::size_t max_places)
{
    std::string text = "  " + visible(kind.first->feature);
    if (kind.places.size() == 1)
        text.append(" (").append(kind.places.front()).append(")");
    text.append(": ").append(visible(kind.first->instead));
    if (kind.places.size() == 1)
        return text;
    const std::size_t count = std::min(kind.places.size(), max_places);
    for (std::size_t index = 0; index < count; ++index)
        text.append("\n      ").append(kind.places[index]);
    if (count < kind.places.size())
        text.append("\n      and ").append(std::to_string(kind.places.size() - count)).append(" more");
    return text;
}

}

std::string loss_count(const art::Losses& losses)
{
    const std::size_t count = losses.list().size() + losses.beyond();
    return counted(count, "thing") + (count == 1 ? " is" : " are") + " not carried over";
}

std::string loss_list(const art::Losses& losses, ListLength length)
{
    const Most max = length == ListLength::cut ? on_a_screen : Most{};
    const std::vector<Kind> kinds = kinds_of(losses);
    const std::size_t count = std::min(kinds.size(), max.kinds);
    const bool is_cut = count < kinds.size() || std::ranges::any_of(kinds, [&max](const Kind& kind) {
                            return kind.places.size() > max.places;
                        });
    std::string text;
    for (std::size_t index = 0; index < count; ++index)
        text.append(index == 0 ? "" : "\n").append(text_of(kinds[index], max.places));
    if (count < kinds.size())
        text.append("\n  and ").append(counted(kinds.size() - count, "more kind")).append(" of things");
    if (is_cut)
        text.append("\n  (all of them: 'kfast check', or 'kfast import --all-losses')");
    if (losses.beyond() > 0)
        text.append("\n  and ").append(std::to_string(losses.beyond())).append(" more, too many to keep");
    return text;
}

}
