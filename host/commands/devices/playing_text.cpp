#include "host/commands/devices/playing_text.hpp"

#include "core/playhead.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/link/remote_device.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/characters.hpp"
#include "host/words/scene_words.hpp"

#include <iostream>
#include <vector>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

double factor(std::int32_t speed) { return static_cast<double>(speed) / Playhead::as_authored; }

std::string arming_text(const link::Playing& playing)
{
    switch (playing.arming) {
    case link::Arming::disarmed:
        return ", disarmed";
    case link::Arming::armed:
        return ", armed";
    default:
        return "";
    }
}

}

std::string home_text(link::Home home)
{
    switch (home) {
    case link::Home::built_in:
        return "built-in";
    case link::Home::slot:
        return "slot";
    default:
        return "RAM";
    }
}

std::string place_text(link::Home home, std::uint8_t slot)
{
    if (home == link::Home::slot)
        return "slot " + std::to_string(slot);
    return home == link::Home::built_in ? "the built-in scene" : "the scene in RAM";
}

Json armed_json(const link::Playing& playing)
{
    return playing.arming == link::Arming::none ? Json() : Json(playing.arming == link::Arming::armed);
}

std::string playing_text(const link::Playing& playing)
{
    if (!playing.is_playing)
        return "nothing" + arming_text(playing);
    std::string text = place_text(playing.home, playing.slot);
    if (!playing.clip.view().empty())
        text += ", clip " + visible(playing.clip.view());
    text += ", frame " + scene::text_of(playing.moment) + " of " + scene::text_of(playing.length);
    if (playing.speed != Playhead::as_authored)
        text += ", speed " + scene::text_of(factor(playing.speed));
    return text + (playing.is_paused ? ", paused" : "") + arming_text(playing);
}

Json playing_json(const link::Playing& playing)
{
    if (!playing.is_playing)
        return nullptr;
    return {
        {"home", home_text(playing.home)},
        {"slot", playing.home == link::Home::slot ? Json(playing.slot) : Json()},
        {"clip", playing.clip.view().empty() ? Json() : Json(playing.clip.view())},
        {"paused", playing.is_paused},
        {"frame", in_frames(playing.moment)},
        {"frames", in_frames(playing.length)},
        {"fps", playing.frame_rate / 1000.0},
        {"speed", factor(playing.speed)},
        {"brightness", playing.brightness},
        {"canvas", {{"width", playing.canvas.width}, {"height", playing.canvas.height}}},
        {"inputs", playing.inputs},
    };
}

void print_playing(std::span<RemoteDevice> devices, const DeviceOptions& options)
{
    if (options.quiet)
        return;
    std::vector<link::Playing> playing(devices.size());
    on_each(devices, [&](RemoteDevice& device, std::size_t index) {
        playing[index] = device.session().ask<link::Playing>(link::AskPlaying{});
    });
    Json list = Json::array();
    for (std::size_t index = 0; index < devices.size(); ++index) {
        const std::string& name = devices[index].name();
        if (options.json)
            list.push_back({{"device", name},
                            {"playing", playing_json(playing[index])},
                            {"armed", armed_json(playing[index])}});
        else
            std::cout << name << ": plays " << playing_text(playing[index]) << '\n';
    }
    if (options.json)
        std::cout << json_text(list);
}

}
