#include "core/beam/beam_profile.hpp"
#include "host/commands/command.hpp"
#include "host/commands/info/ilda_info.hpp"
#include "host/commands/info/tracks.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/commands/text/glyph_text.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/commands/text/summary.hpp"
#include "host/compile/scene_file.hpp"
#include "host/compiler/limits/measured_moments.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/walk/every_item.hpp"
#include "host/walk/input_text.hpp"
#include "host/walk/key_times.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
    std::string file;
    bool json = false;
    bool tracks = false;
    std::uint32_t rate = galvo_profile.rate;
    PictureOptions picture;
};

/// The keys as an author writes them.
Json keys_of(const SceneView& scene, Driver driver = {})
{
    Json keys = Json::array();
    for (const Time key : key_times(scene, driver))
        keys.push_back(written_moment(scene, driver, key));
    return keys;
}

std::size_t item_count(const SceneView& scene)
{
    std::size_t count = 0;
    every_item(scene, [&count](const ItemView&) { ++count; });
    return count;
}

std::size_t wire_frame_count(const SceneView& scene)
{
    std::size_t count = 0;
    every_item(scene, [&count](const ItemView& item) { count += item.object.has_depths ? 1 : 0; });
    return count;
}

Json number_facts(const SceneView& scene, const InputView& input, Driver driver)
{
    return {{"name", input.name},
            {"kind", "number"},
            {"min", input.min / 1000.0},
            {"max", input.max / 1000.0},
            {"default", input.default_value / 1000.0},
            {"keys", keys_of(scene, driver)}};
}

Json text_facts(const InputView& input)
{
    const TextInput& text = input.text;
    return {{"name", input.name},
            {"kind", "text"},
            {"glyphs", glyph_text(text.glyphs)},
            {"max", text.max},
            {"default", default_text(text)}};
}

Json drawing_facts(const InputView& input)
{
    return {{"name", input.name},
            {"kind", "drawing"},
            {"strokes", input.drawing.strokes},
            {"points", input.drawing.points}};
}

Json input_facts(const SceneView& scene, const InputView& input, Driver driver)
{
    switch (input.type) {
    case InputType::number:
        return number_facts(scene, input, driver);
    case InputType::text:
        return text_facts(input);
    case InputType::drawing:
        return drawing_facts(input);
    }
    return {};
}

Json input_facts(const SceneView& scene)
{
    Json inputs = Json::array();
    for (InputCursor cursor = scene.inputs(); !cursor.at_end();) {
        const InputView input = cursor.next();
        const Driver driver{static_cast<std::uint8_t>(inputs.size() + 1)};
        inputs.push_back(input_facts(scene, input, driver));
    }
    return inputs;
}

Json clocks_of(const SceneView& scene)
{
    Json clocks = Json::array();
    for (ClockCursor cursor = scene.clocks(); !cursor.at_end();) {
        const Clock clock = cursor.next();
        Json facts{{"delay", in_frames(clock.delay)},
                   {"speed", static_cast<double>(clock.speed) / Clock::normal_speed},
                   {"loop", loop_name(clock.loop)},
                   {"keys", keys_of(scene, Driver::of_clock(clocks.size()))}};
        if (clock.length != Time{})
            facts["frames"] = in_frames(clock.length);
        if (clock.driver.is_clock())
            facts["clock"] = clock.driver.index();
        clocks.push_back(std::move(facts));
    }
    return clocks;
}

Json clips_of(const SceneView& scene)
{
    Json clips = Json::array();
    for (ClipCursor cursor = scene.clips(); !cursor.at_end();) {
        const ClipView clip = cursor.next();
        clips.push_back({{"name", clip.name},
                         {"from", in_frames(clip.begin)},
                         {"to", in_frames(clip.end)},
                         {"loop", loop_name(clip.loop)}});
    }
    return clips;
}

Json events_of(const SceneView& scene)
{
    Json events = Json::array();
    for (EventCursor cursor = scene.events(); !cursor.at_end();) {
        const EventView event = cursor.next();
        events.push_back({{"name", event.name}, {"at", in_frames(event.time)}});
    }
    return events;
}

Json facts(const InfoOptions& options, const SceneFile& scene)
{
    const Timeline timeline = timeline_of(scene.view);
    const Size canvas = scene.view.canvas();
    const Size panel = panel_size(options.picture, scene.view);
    constexpr std::size_t max_pictures = 1000;
    const std::size_t affordable = affordable_pictures(scene.view, scene.view.outline_bytes());
    const CoarsePictures pictures = coarse_pictures(scene.view, panel, std::min(affordable, max_pictures));
    return {
        {"file", options.file},
        {"bytes", scene.bytes.size()},
        {"canvas", {{"width", canvas.width}, {"height", canvas.height}}},
        {"fps", timeline.frame_rate / 1000.0},
        {"frames", in_frames(timeline.stretch.end)},
        {"pictures", timeline.frame_count()},
        {"seconds", timeline.seconds(timeline.stretch.end.ticks)},
        {"loop", loop_name(timeline.stretch.loop)},
        {"objects", object_count(scene.view)},
        {"wire_frames", wire_frame_count(scene.view)},
        {"items", item_count(scene.view)},
        {"symbols", scene.view.symbol_count()},
        {"keys", keys_of(scene.view)},
        {"features", feature_names(scene.view.needed_features())},
        {"inputs", input_facts(scene.view)},
        {"clocks", clocks_of(scene.view)},
        {"clips", clips_of(scene.view)},
        {"events", events_of(scene.view)},
        {"memory",
         {{"bytes", Player::block_bytes(scene.view, panel)},
          {"width", panel.width},
          {"height", panel.height},
          {"coarse_pictures", pictures.coarse},
          {"of_pictures", pictures.looked_at}}},
    };
}

std::string size_text(const Json& size)
{
    return size_text(Size{size["width"].get<int>(), size["height"].get<int>()});
}

/// `at` is what comes before the first: ", at frames ".
std::string key_text(const Json& keys, const char* at)
{
    std::ostringstream text;
    text << keys.size();
    for (std::size_t place = 0; place < std::min(keys.size(), most_listed); ++place)
        text << (place == 0 ? at : " ") << keys[place].get<double>();
    return text.str() + rest_of_list(keys.size());
}

std::string number_text(const Json& input)
{
    std::ostringstream text;
    text << input["min"].get<double>() << " to " << input["max"].get<double>() << ", usually "
         << input["default"].get<double>() << "; keys " << key_text(input["keys"], ", at ");
    return text.str();
}

std::string words_text(const Json& input)
{
    return "a text of up to " + counted(input["max"].get<std::size_t>(), "character") + " of " +
           in_quotes(input["glyphs"].get<std::string>()) + " and spaces, usually " +
           in_quotes(input["default"].get<std::string>());
}

std::string drawing_text(const Json& input)
{
    return "a drawing, at most " + counted(input["points"].get<std::size_t>(), "point") + " in " +
           counted(input["strokes"].get<std::size_t>(), "stroke");
}

std::string input_text(const Json& input)
{
    if (input["kind"] == "number")
        return number_text(input);
    return input["kind"] == "text" ? words_text(input) : drawing_text(input);
}

void print_input(const Json& input)
{
    std::cout << "  input       " << visible(input["name"].get<std::string>()) << ": " << input_text(input)
              << '\n';
}

void print_clock(std::size_t index, const Json& clock)
{
    std::cout << "  clock       " << index << ": ";
    if (clock.contains("clock"))
        std::cout << "of clock " << clock["clock"] << ", ";
    const double speed = std::round(clock["speed"].get<double>() * 10'000) / 10'000;
    std::cout << "after " << clock["delay"] << " frames, speed " << rounded_text(speed);
    if (clock.contains("frames"))
        std::cout << ", " << clock["frames"] << " frames, " << clock["loop"].get<std::string>();
    std::cout << "; keys " << key_text(clock["keys"], ", at ") << '\n';
}

void print_clip(const Json& clip)
{
    std::cout << "  clip        " << visible(clip["name"].get<std::string>()) << ": frames "
              << clip["from"].get<double>() << " to " << clip["to"].get<double>() << ", "
              << clip["loop"].get<std::string>() << '\n';
}

void print_event(const Json& event)
{
    std::cout << "  event       " << visible(event["name"].get<std::string>()) << ": frame "
              << event["at"].get<double>() << '\n';
}

/// The text after the number of objects.
std::string wire_text(std::size_t wire_frames)
{
    return wire_frames == 0 ? "" : ", " + counted(wire_frames, "wire frame") + " among them";
}

/// The text after the length.
std::string end_text(const SceneView& scene)
{
    const Timeline timeline = timeline_of(scene);
    return timeline.stretch.loop != Loop::once
               ? ""
               : ", and then its end: " + std::to_string(timeline.frame_count()) + " pictures";
}

/// The text after the memory.
std::string detail_text(const Json& memory)
{
    const auto coarse = memory["coarse_pictures"].get<std::size_t>();
    if (coarse == 0)
        return "";
    return ", too little for all detail of " + std::to_string(coarse) + " of " +
           counted(memory["of_pictures"].get<std::size_t>(), "picture") + " that were tried";
}

void print_scene_facts(const Json& facts, const SceneView& scene)
{
    std::cout << facts["file"].get<std::string>() << '\n'
              << "  size        " << facts["bytes"] << " bytes\n"
              << "  canvas      " << size_text(facts["canvas"]) << '\n'
              << "  frame rate  " << facts["fps"].get<double>() << " fps\n"
              << "  length      " << length_text(scene) << ", " << facts["seconds"].get<double>() << " s"
              << end_text(scene) << '\n'
              << "  loop        " << facts["loop"].get<std::string>() << '\n'
              << "  objects     " << facts["objects"] << wire_text(facts["wire_frames"].get<std::size_t>())
              << '\n'
              << "  items       " << facts["items"] << '\n'
              << "  symbols     " << facts["symbols"] << '\n'
              << "  keys        " << key_text(facts["keys"], ", at frames ") << '\n'
              << "  features    " << features_text(scene.needed_features()) << '\n'
              << "  memory      " << facts["memory"]["bytes"] << " bytes for a panel of "
              << size_text(facts["memory"]) << detail_text(facts["memory"]) << '\n';
    std::ranges::for_each(facts["inputs"], print_input);
    for (std::size_t i = 0; i < facts["clocks"].size(); ++i)
        print_clock(i, facts["clocks"][i]);
    std::ranges::for_each(facts["clips"], print_clip);
    std::ranges::for_each(facts["events"], print_event);
    if (facts.contains("tracks"))
        print_item_tracks(facts["tracks"], std::cout);
    if (facts.contains("skeletons"))
        print_bone_tracks(facts["skeletons"], std::cout);
}

void print_info(const InfoOptions& options)
{
    if (is_ilda(options.file))
        return print_ilda_info(options.file, options.rate, options.json);
    const SceneFile scene = load_scene(options.file);
    Json known = facts(options, scene);
    if (options.tracks) {
        known["tracks"] = item_tracks(scene);
        known["skeletons"] = bone_tracks(scene);
    }
    if (options.json)
        std::cout << json_text(known);
    else
        print_scene_facts(known, scene.view);
}

void declare_info(CLI::App& app)
{
    const auto options = std::make_shared<InfoOptions>();
    CLI::Option* const file = app.add_option("FILE", options->file,
                                             "A scene text (.kfast), a compiled scene (.kfb) or an ILDA file")
                                  ->required();
    reads_file(file, {".kfast", ".kfb"});
    declare_json(app, options->json);
    app.add_flag("--tracks", options->tracks, "All that moves and turns items and bones, and when")
        ->group(option_group::report);
    app.add_option("--point-rate", options->rate,
                   "How many points of an ILDA file are played in a second (default: 30000)")
        ->type_name("HZ")
        ->check(number_within(1'000, 1'000'000));
    declare_size_options(app, options->picture);
    app.callback([options] { print_info(*options); });
}

}

const Command info_command{
    "info", "Tell size, length, loop, objects, keys, inputs, clips, events and memory of a scene",
    "kfast info eyes.kfb --panel ssd0323\n"
    "  kfast info eyes.ild --point-rate 40000",
    declare_info};

}
