#include "host/commands/command.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/commands/devices/playing_text.hpp"
#include "host/commands/devices/sending.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/play_options.hpp"
#include "host/compile/scene_file.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/scene_upload.hpp"
#include "host/text/characters.hpp"

#include <optional>

namespace kfast {
namespace {

struct PlayCommandOptions {
    std::string file;
    std::optional<std::uint8_t> slot;
    bool built_in = false;
    bool start = false;
    PlayOptions play;
    DeviceOptions device;
};

link::Name clip_name(const PlayCommandOptions& options)
{
    const std::string name = options.play.clip.value_or("");
    if (stored_name(name) != name)
        throw CLI::ValidationError("--clip", "'" + visible(name) +
                                                 "' is too long: a device can be asked for clips whose names "
                                                 "have at most 24 bytes");
    return {name};
}

/// The home of a scene that is there already.
link::Home home_of(const PlayCommandOptions& options)
{
    if (options.slot)
        return link::Home::slot;
    if (options.built_in)
        return link::Home::built_in;
    return options.start ? link::Home::start : link::Home::here;
}

SentScene sent(const PlayCommandOptions& options, std::span<RemoteDevice> devices, const SceneFile& scene)
{
    static_cast<void>(chosen_timeline(options.play, scene.view)); // an unknown clip is refused here
    return {scene, devices, options.device};
}

void play(const PlayCommandOptions& options)
{
    const link::Play what{
        .home = home_of(options), .slot = options.slot.value_or(link::no_slot), .clip = clip_name(options)};
    std::optional<SceneFile> scene;
    if (!options.file.empty())
        scene.emplace(load_scene(options.file));
    OpenDevices devices{options.device};
    std::optional<SentScene> in_ram;
    if (scene)
        in_ram = sent(options, devices.all(), *scene);
    on_each(devices.all(), [&](RemoteDevice& device, std::size_t index) {
        if (in_ram)
            in_ram->play(index, what.clip);
        else
            device.session().order(what, patience_to_begin);
        if (options.play.speed != Playhead::as_authored)
            device.session().order(link::Speed{options.play.speed});
    });
    print_playing(devices.all(), options.device);
}

void declare_play(CLI::App& app)
{
    const OptionHeading heading{app, option_group::play};
    const auto options = std::make_shared<PlayCommandOptions>();
    CLI::Option* const file = reads_scene(app.add_option(
        "SCENE", options->file, std::string{loaded_scene} + "; it goes into RAM (default: what plays)"));
    CLI::Option* const slot =
        app.add_option("--slot", options->slot, "The scene in this slot")->type_name("N")->excludes(file);
    CLI::Option* const built_in =
        app.add_flag("--built-in", options->built_in, "The built-in scene")->excludes(file)->excludes(slot);
    app.add_flag("--start", options->start, "What the device plays when it starts")
        ->excludes(file)
        ->excludes(slot)
        ->excludes(built_in);
    declare_play_options(app, options->play);
    declare_device_options(app, options->device);
    app.callback([options] { play(*options); });
}

}

const Command play_command{.name = "play",
                           .summary =
                               "Play a scene on a device from its beginning, without wear of its flash",
                           .example = "kfast play eyes.kfast --clip blink",
                           .declare = declare_play,
                           .group = devices_group};

}
