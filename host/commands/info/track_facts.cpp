#include "host/commands/info/track_facts.hpp"

#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

Json value_of(const SceneView& scene, Property property, std::int32_t value)
{
    switch (property) {
    case Property::order:
        return value;
    case Property::visible:
        return value != 0;
    case Property::fill:
    case Property::stroke:
        return colour_text(scene.colour(static_cast<std::size_t>(value)));
    default:
        return written_amount(property, value);
    }
}

bool goes_by_laws(const TrackView& track)
{
    return !track.is_smooth && track.property != Property::order && track.property != Property::visible;
}

Json keys_of(const SceneView& scene, const TrackView& track)
{
    Json keys = Json::array();
    for (TrackKeyCursor cursor = track.keys; !cursor.at_end();) {
        const TrackKey key = cursor.next();
        Json entry{{"at", written_moment(scene, cursor.key_times().driver(), key.time)},
                   {"value", value_of(scene, track.property, key.value)}};
        if (goes_by_laws(track) && !cursor.at_end()) {
            const LawPair laws = scene.laws(key.laws);
            entry["law"] = law_text(goes_by_y(track.property) ? laws.y : laws.x);
        }
        keys.push_back(std::move(entry));
    }
    return keys;
}

std::string value_text(const Json& value)
{
    if (value.is_boolean())
        return value.get<bool>() ? "#true" : "#false";
    return value.is_string() ? value.get<std::string>() : rounded_text(value.get<double>());
}

std::string written_key(const Json& key, bool has_law)
{
    const std::string text = rounded_text(key["at"].get<double>()) + ' ' + value_text(key["value"]);
    return has_law && key.contains("law") ? text + ' ' + key["law"].get<std::string>() : text;
}

/// The law between all keys, if it is the same.
std::string common_law(const Json& keys)
{
    const std::string first = keys.front().value("law", "");
    const bool is_common = std::all_of(keys.begin(), keys.end() - 1,
                                       [&first](const Json& key) { return key.value("law", "") == first; });
    return is_common ? first : "";
}

}

Json track_facts(const SceneView& scene, const TrackView& track)
{
    Json facts{{"property", property_name(track.property)}};
    if (track.is_fixed) {
        facts["value"] = value_of(scene, track.property, track.value);
    } else {
        facts["smooth"] = track.is_smooth;
        add_driver(scene, track.keys.key_times().driver(), facts);
        facts["keys"] = keys_of(scene, track);
    }
    return facts;
}

std::string track_text(const Json& facts)
{
    if (facts.contains("value"))
        return value_text(facts["value"]);
    const std::string law = facts["smooth"].get<bool>() ? "smooth" : common_law(facts["keys"]);
    std::string text =
        facts.contains("input") ? "by " + visible(facts["input"].get<std::string>()) + ", " : "";
    if (facts.contains("clock"))
        text = "by clock " + std::to_string(facts["clock"].get<std::size_t>()) + ", ";
    text += law.empty() ? "" : law + ": ";
    const Json& keys = facts["keys"];
    for (std::size_t place = 0; place < std::min(keys.size(), most_listed); ++place)
        text += (place == 0 ? "" : ", ") + written_key(keys[place], law.empty());
    return text + rest_of_list(keys.size());
}

void add_driver(const SceneView& scene, Driver driver, Json& facts)
{
    if (driver.is_input())
        facts["input"] = input_of(scene, driver).name;
    if (driver.is_clock())
        facts["clock"] = driver.index();
}

void add_name(const std::vector<std::string>& names, std::size_t place, Json& facts)
{
    if (place < names.size() && !names[place].empty())
        facts["name"] = names[place];
}

std::string name_behind(const Json& facts)
{
    return facts.contains("name") ? ' ' + in_quotes(facts["name"].get<std::string>()) : "";
}

}
