#include "host/import/dot_lottie.hpp"

#include "host/program/failure.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::importing {
namespace {

using Json = nlohmann::json;

/// Where animations are, in version 2 and in version 1.
constexpr std::array<std::string_view, 2> folders{"a/", "animations/"};
constexpr std::string_view ending = ".json";

const Json& member(const Json& owner, const char* key)
{
    static const Json none;
    const auto found = owner.is_object() ? owner.find(key) : owner.end();
    return found == owner.end() ? none : *found;
}

std::string text_of(const Json& value)
{
    return value.is_string() ? value.get<std::string>() : std::string{};
}

/// The manifest, or nothing where there is none: the names of the files are enough then.
Json read_manifest(const std::string& name, const archive::ZipFile& file, std::size_t max_bytes)
{
    if (!file.has("manifest.json"))
        return {};
    Json manifest = Json::parse(file.content("manifest.json", max_bytes), nullptr, false);
    if (!manifest.is_object())
        throw Failure(name + ": manifest.json is no JSON object: pack the file again");
    return manifest;
}

/// The name of the animation that a path leads to, "" if it leads to none.
std::string_view animation_of(std::string_view path)
{
    for (const std::string_view folder : folders)
        if (path.starts_with(folder) && path.ends_with(ending))
            return path.substr(folder.size(), path.size() - folder.size() - ending.size());
    return "";
}

/// The animations that exist, in the order of the manifest, and after them those that it does not name.
std::vector<std::string> animations_of(const Json& manifest, const archive::ZipFile& file)
{
    std::vector<std::string> packed;
    for (const std::string& path : file.members())
        if (const std::string_view id = animation_of(path); !id.empty())
            packed.emplace_back(id);
    std::vector<std::string> ids;
    const auto add = [&](const std::string& id) {
        if (std::ranges::find(ids, id) == ids.end() && std::ranges::find(packed, id) != packed.end())
            ids.push_back(id);
    };
    for (const Json& animation : member(manifest, "animations"))
        add(text_of(member(animation, "id")));
    std::ranges::for_each(packed, add);
    return ids;
}

std::string list_of(const std::vector<std::string>& ids)
{
    constexpr std::size_t max = 20;
    std::string list;
    for (std::size_t index = 0; index < std::min(ids.size(), max); ++index)
        list.append(index == 0 ? "" : ", ").append(ids[index]);
    return ids.size() > max ? list + ", …" : list;
}

/// The animation that the manifest begins with, if it exists.
std::string begun_with(const Json& manifest, const std::vector<std::string>& ids)
{
    for (const std::string& id : {text_of(member(member(manifest, "initial"), "animation")),
                                  text_of(member(manifest, "activeAnimationId"))})
        if (std::ranges::find(ids, id) != ids.end())
            return id;
    return ids.front();
}

std::string chosen(const std::string& name, const std::string& wanted, const Json& manifest,
                   const std::vector<std::string>& ids, art::Losses& losses)
{
    if (ids.empty())
        throw Failure(name +
                      ": a zip file without an animation: a dotLottie file has them in a/ or animations/");
    if (!wanted.empty()) {
        if (std::ranges::find(ids, wanted) == ids.end())
            throw Failure(name + ": there is no animation '" + wanted + "': it has " + list_of(ids));
        return wanted;
    }
    std::string id = begun_with(manifest, ids);
    if (ids.size() > 1)
        losses.add({"more than one animation", "", std::nullopt,
                    '\'' + id + "' of " + list_of(ids) + " (--animation ID takes another)"});
    return id;
}

const Json& facts_of(const std::string& id, const Json& manifest)
{
    static const Json none;
    for (const Json& animation : member(manifest, "animations"))
        if (text_of(member(animation, "id")) == id)
            return animation;
    return none;
}

std::optional<Loop> read_loop(const Json& facts, art::Losses& losses)
{
    const Json& loop = member(facts, "loop");
    if (text_of(member(facts, "playMode")) == "bounce")
        return Loop::ping_pong;
    if (loop.is_number() && loop.get<double>() > 1)
        losses.add({"a number of plays", "", std::nullopt, "it repeats for ever"});
    if (!loop.is_boolean())
        return std::nullopt;
    return loop.get<bool>() ? Loop::repeat : Loop::once;
}

/// "#rrggbb", perhaps followed by an opacity, which a canvas does not have.
std::optional<art::Rgb> read_background(const Json& facts)
{
    const std::string text = text_of(member(facts, "background"));
    std::uint32_t number = 0;
    if ((text.size() != 7 && text.size() != 9) || text.front() != '#')
        return std::nullopt;
    const auto [rest, error] = std::from_chars(text.data() + 1, text.data() + 7, number, 16);
    if (error != std::errc{} || rest != text.data() + 7)
        return std::nullopt;
    const auto channel = [number](int shift) { return (number >> shift & 0xFF) / 255.0; };
    return art::Rgb{channel(16), channel(8), channel(0)};
}

double read_speed(const Json& facts, art::Losses& losses)
{
    constexpr double slowest = 0.001;
    constexpr double fastest = 1000;
    const Json& speed = member(facts, "speed");
    if (!speed.is_number())
        return 1;
    const double value = speed.get<double>();
    if (value >= slowest && value <= fastest)
        return value;
    losses.add({"speed of " + speed.dump(), "", std::nullopt, "it plays at its own speed"});
    return 1;
}

bool has_any(const Json& list) { return list.is_array() && !list.empty(); }

void report_rest(const Json& manifest, const Json& facts, art::Losses& losses)
{
    const Json& direction = member(facts, "direction");
    const Json& pause = member(facts, "intermission");
    const Json& hover = member(facts, "hover");
    if (direction.is_number() && direction.get<double>() < 0)
        losses.add({"playing backwards", "", std::nullopt, "it plays forwards"});
    if (pause.is_number() && pause.get<double>() > 0)
        losses.add({"a pause between plays", "", std::nullopt, "the next play begins at once"});
    if (hover.is_boolean() && hover.get<bool>())
        losses.add({"playing while a pointer is over it", "", std::nullopt, "it plays by itself"});
    if (has_any(member(manifest, "themes")))
        losses.add({"themes", "", std::nullopt, "the animation as it is without one"});
    if (has_any(member(manifest, "stateMachines")) || has_any(member(manifest, "states")))
        losses.add({"state machines", "", std::nullopt, "the animation plays by itself"});
}

std::string path_of(const std::string& id, const archive::ZipFile& file)
{
    const std::string path = std::string{folders[0]} + id + std::string{ending};
    return file.has(path) ? path : std::string{folders[1]} + id + std::string{ending};
}

}

PackedAnimation read_dot_lottie(const std::string& name, const archive::ZipFile& file,
                                const std::string& wanted, std::size_t max_bytes, art::Losses& losses)
{
    const Json manifest = read_manifest(name, file, max_bytes);
    const std::string id = chosen(name, wanted, manifest, animations_of(manifest, file), losses);
    const Json& facts = facts_of(id, manifest);
    report_rest(manifest, facts, losses);
    return {file.content(path_of(id, file), max_bytes),
            {.loop = read_loop(facts, losses),
             .background = read_background(facts),
             .speed = read_speed(facts, losses)}};
}

}
