#include "host/commands/info/bone_tracks.hpp"

#include "host/commands/info/track_facts.hpp"
#include "host/words/law_text.hpp"
#include "host/words/written_moment.hpp"

#include <array>
#include <iomanip>
#include <string>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t widest_quantity = 8; ///< of a quantity, and a space

constexpr std::array<const char*, bone_quantity_count> quantity_names{"angle", "x", "y", "length"};

double value_of(BoneQuantity quantity, std::int32_t value)
{
    return quantity == BoneQuantity::angle ? value * 360.0 / 65536 : value / 16.0;
}

class QuantityFacts {
public:
    QuantityFacts(const SceneView& scene, const BoneView& bone, BoneQuantity quantity)
        : scene_{scene}, quantity_{quantity}, counts_modulo_one_turn_{quantity == BoneQuantity::angle &&
                                                                      !bone.turns_as_written}
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
    Json fact(Driver clock, const TrackKey& at, bool is_last) const
    {
        constexpr std::int32_t turn = 65536;
        Json key{{"at", written_moment(scene_, clock, at.time)},
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
    add_input(scene, keys.keys().key_times().driver(), facts);
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
