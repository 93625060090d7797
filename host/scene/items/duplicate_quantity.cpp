#include "host/scene/items/duplicate_quantity.hpp"

#include "host/words/property_name.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace kfast::scene {
namespace {

class DuplicateQuantities {
public:
    DuplicateQuantities(std::span<const TimedQuantity> timed, const ItemValues& values,
                        std::span<const ItemKey> keys, SceneContext& context)
        : timed_{timed}, values_{values}, keys_{keys}, context_{context}
    {
    }

    void refuse()
    {
        for (std::size_t i = 0; i < timed_.size() && !context_.report.full(); ++i) {
            refuse_duplicate(timed_[i], timed_.first(i));
            if (gives(timed_[i], Property::along))
                refuse_position(timed_[i]);
        }
    }

private:
    void refuse_duplicate(const TimedQuantity& quantity, std::span<const TimedQuantity> earlier)
    {
        for (const Track& track : quantity.tracks) {
            const auto giver = other_giver(track.property, earlier);
            if (!giver)
                continue;
            const std::string name{property_name(track.property)};
            context_.report.error(quantity.place, name + " is given twice: by this track, and by " + *giver,
                                  "leave it to one of them");
            return;
        }
    }

    void refuse_position(const TimedQuantity& path)
    {
        for (const Property property : {Property::x, Property::y})
            if (const auto giver = other_giver(property, timed_)) {
                const std::string name{property_name(property)};
                context_.report.error(
                    path.place, "the path says where the item is, but " + name + " is given by " + *giver,
                    "leave it out, or put the item into a group that moves");
                return;
            }
    }

    std::optional<std::string> other_giver(Property property, std::span<const TimedQuantity> tracks) const
    {
        const auto sets_it = [property](const ItemKey& key) { return key.values.get(property).has_value(); };
        const auto moves_it = [property](const TimedQuantity& other) { return gives(other, property); };
        if (values_.get(property))
            return "its item";
        if (const auto key = std::ranges::find_if(keys_, sets_it); key != keys_.end())
            return "the key on " + context_.report.line(key->place);
        if (const auto track = std::ranges::find_if(tracks, moves_it); track != tracks.end())
            return "the track on " + context_.report.line(track->place);
        return std::nullopt;
    }

    std::span<const TimedQuantity> timed_;
    const ItemValues& values_;
    std::span<const ItemKey> keys_;
    SceneContext& context_;
};

}

void refuse_duplicate_quantities(std::span<const TimedQuantity> timed, const ItemValues& values,
                                 std::span<const ItemKey> keys, SceneContext& context)
{
    DuplicateQuantities{timed, values, keys, context}.refuse();
}

}
