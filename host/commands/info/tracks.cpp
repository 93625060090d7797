#include "host/commands/info/tracks.hpp"

#include "host/commands/info/track_facts.hpp"
#include "host/text/number_text.hpp"
#include "host/words/scene_words.hpp"

#include <array>
#include <cstddef>
#include <iomanip>
#include <string>

namespace kfast {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t widest_property = 11; ///< of a property, and a space

const char* name_of(ItemKind kind)
{
    switch (kind) {
    case ItemKind::object:
        return "object ";
    case ItemKind::group:
        return "group ";
    case ItemKind::use:
        return "use ";
    case ItemKind::live:
        return "object ";
    }
    return "";
}

double length_of(const PathView& path)
{
    std::uint32_t length = 0;
    for (ByteReader lengths = path.lengths; lengths.left() != 0;)
        length += lengths.varint();
    return length / 16.0;
}

Json tracks_of(const SceneView& scene, const ItemView& item)
{
    Json tracks = Json::array();
    for (TrackCursor cursor = item.tracks; !cursor.at_end();) {
        const TrackView track = cursor.next();
        Json facts = track_facts(scene, track);
        if (track.property == Property::along) {
            facts["length"] = length_of(item.path);
            facts["turn"] = item.path.turns;
        }
        tracks.push_back(std::move(facts));
    }
    return tracks;
}

/// In the words of the scene language: "hatch"; what is hatched also how.
Json beam_facts(const BeamStyle& style)
{
    constexpr std::array words{"none", "outline", "hatch", "both"};
    Json facts{{"draws", words[static_cast<std::size_t>(style.parts)]}};
    if (style.has_hatching()) {
        facts["hatch"] = style.spacing / 16.0;
        facts["hatch-angle"] = style.direction.raw * 360.0 / BinaryAngle::turn;
    }
    return facts;
}

/// Goes through the items in the order in which the scene stores them, as their names are.
class ItemSummary {
public:
    explicit ItemSummary(const SceneFile& scene) : scene_{scene} {}

    /// `path` is that of what the items are in: "", "2.1."
    Json of(ItemCursor cursor, const std::string& path)
    {
        Json items = Json::array();
        while (!cursor.at_end()) {
            const ItemView item = cursor.next();
            items.push_back(of(item, path + std::to_string(items.size() + 1)));
        }
        return items;
    }

private:
    Json of(const ItemView& item, const std::string& number)
    {
        Json facts{{"item", name_of(item.kind) + number}};
        add_name(scene_.item_names, next_++, facts);
        if (item.kind == ItemKind::use)
            facts["symbol"] = item.symbol + 1;
        facts["tracks"] = tracks_of(scene_.view, item);
        if (item.beam != BeamStyle{})
            facts["beam"] = beam_facts(item.beam);
        if (item.kind == ItemKind::group)
            facts["items"] = of(ItemCursor{item.items}, number + '.');
        return facts;
    }

    const SceneFile& scene_;
    std::size_t next_ = 0; ///< place in SceneFile::item_names
};

void print_track(const Json& track, const std::string& indent, std::ostream& out)
{
    out << indent << std::left << std::setw(widest_property) << track["property"].get<std::string>()
        << track_text(track);
    if (track.contains("length"))
        out << "; the path is " << rounded_text(track["length"].get<double>()) << " px long"
            << (track["turn"].get<bool>() ? ", and the item turns with it" : "");
    out << '\n';
}

void print_beam(const Json& beam, const std::string& indent, std::ostream& out)
{
    out << indent << std::left << std::setw(widest_property) << "beam" << beam["draws"].get<std::string>();
    if (beam.contains("hatch"))
        out << ": lines " << rounded_text(beam["hatch"].get<double>()) << " px apart, at "
            << rounded_text(beam["hatch-angle"].get<double>()) << "°";
    out << '\n';
}

void print_items(const Json& items, const std::string& indent, std::ostream& out)
{
    for (const Json& item : items) {
        out << indent << item["item"].get<std::string>() << name_behind(item);
        if (item.contains("symbol"))
            out << " of symbol " << item["symbol"].get<int>();
        out << '\n';
        for (const Json& track : item["tracks"])
            print_track(track, indent + "  ", out);
        if (item.contains("beam"))
            print_beam(item["beam"], indent + "  ", out);
        if (item.contains("items"))
            print_items(item["items"], indent + "  ", out);
    }
}

}

Json item_tracks(const SceneFile& scene)
{
    ItemSummary items{scene}; // of the symbols first, as a scene stores them
    Json symbols = Json::array();
    for (std::uint32_t number = 0; number < scene.view.symbol_count(); ++number) {
        Json facts{{"symbol", number + 1}};
        add_name(scene.other_names.symbols, number, facts);
        facts["items"] = items.of(scene.view.symbol(number), "");
        symbols.push_back(std::move(facts));
    }
    return {{"items", items.of(scene.view.items(), "")}, {"symbols", std::move(symbols)}};
}

void print_item_tracks(const Json& facts, std::ostream& out)
{
    print_items(facts["items"], "  ", out);
    for (const Json& symbol : facts["symbols"]) {
        out << "  symbol " << symbol["symbol"].get<int>() << name_behind(symbol) << '\n';
        print_items(symbol["items"], "    ", out);
    }
}

namespace {

constexpr std::size_t widest_quantity = 8; ///< of a quantity, and a space

constexpr std::array<const char*, bone_quantity_count> quantity_names{"angle", "x", "y", "length"};

double value_of(BoneQuantity quantity, std::int32_t value)
{
    return quantity == BoneQuantity::angle ? value * 360.0 / 65536 : value / 16.0;
}

class QuantityFacts {
public:
    QuantityFacts(const SceneView& scene, const BoneView& bone, BoneQuantity quantity)
        : scene_{scene},
          quantity_{quantity},
          counts_modulo_one_turn_{quantity == BoneQuantity::angle && !bone.turns_as_written}
    {
    }

    Json of(TrackKeyCursor cursor) const
    {
        Json facts = Json::array();
        while (!cursor.at_end()) {
            const TrackKey key = cursor.next();
            facts.push_back(fact(cursor.key_times().driver(), key, cursor.at_end()));
        }
        return facts;
    }

private:
    Json fact(Driver driver, const TrackKey& at, bool is_last) const
    {
        constexpr std::int32_t turn = 65536;
        Json key{{"at", written_moment(scene_, driver, at.time)},
                 {"value", value_of(quantity_, counts_modulo_one_turn_ ? at.value & (turn - 1) : at.value)}};
        const LawPair laws = scene_.laws(at.laws);
        if (!is_last)
            key["law"] = law_text(quantity_ == BoneQuantity::y ? laws.y : laws.x);
        return key;
    }

    const SceneView& scene_;
    BoneQuantity quantity_;
    bool counts_modulo_one_turn_;
};

Json quantity_facts(const SceneView& scene, const BoneView& bone, std::size_t number)
{
    const auto quantity = static_cast<BoneQuantity>(number);
    const BoneKeys& keys = bone.keys_of(quantity);
    Json facts{{"property", quantity_names.at(number)}};
    if (keys.kind() == BoneKeys::Kind::none) {
        facts["value"] = value_of(quantity, bone.at_rest(quantity));
        return facts;
    }
    facts["smooth"] = false;
    add_driver(scene, keys.keys().key_times().driver(), facts);
    facts["keys"] = QuantityFacts{scene, bone, quantity}.of(keys.keys());
    return facts;
}

Json bones_of(const SceneView& scene, const SkeletonView& skeleton, const SkeletonNames& names)
{
    Json bones = Json::array();
    for (BoneCursor cursor = skeleton.bones(); !cursor.at_end();) {
        const BoneView bone = cursor.next();
        Json facts{{"bone", bones.size() + 1}};
        add_name(names.bones, bones.size(), facts);
        if (bone.parent != 0)
            facts["parent"] = bone.parent;
        facts["tracks"] = Json::array();
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            facts["tracks"].push_back(quantity_facts(scene, bone, i));
        bones.push_back(std::move(facts));
    }
    return bones;
}

void print_bone(const Json& bone, const Json& bones, std::ostream& out)
{
    out << "    bone " << bone["bone"].get<int>() << name_behind(bone);
    if (bone.contains("parent"))
        out << " of bone " << bone["parent"].get<int>()
            << name_behind(bones[bone["parent"].get<std::size_t>() - 1]);
    out << '\n';
    for (const Json& track : bone["tracks"])
        out << "      " << std::left << std::setw(widest_quantity) << track["property"].get<std::string>()
            << track_text(track) << '\n';
}

}

Json bone_tracks(const SceneFile& scene)
{
    const std::vector<SkeletonNames>& names = scene.other_names.skeletons;
    Json skeletons = Json::array();
    for (SkeletonCursor cursor = scene.view.skeletons(); !cursor.at_end();) {
        const std::size_t place = skeletons.size();
        const SkeletonNames own = place < names.size() ? names[place] : SkeletonNames{};
        Json facts{{"skeleton", place + 1}};
        if (!own.name.empty())
            facts["name"] = own.name;
        facts["bones"] = bones_of(scene.view, cursor.next(), own);
        skeletons.push_back(std::move(facts));
    }
    return skeletons;
}

void print_bone_tracks(const Json& facts, std::ostream& out)
{
    for (const Json& skeleton : facts) {
        out << "  skeleton " << skeleton["skeleton"].get<int>() << name_behind(skeleton) << '\n';
        for (const Json& bone : skeleton["bones"])
            print_bone(bone, skeleton["bones"], out);
    }
}

}
