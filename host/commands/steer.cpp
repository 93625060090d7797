#include "core/playhead.hpp"
#include "host/commands/command.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/commands/devices/playing_text.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/link/remote_device.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"

#include <iostream>

/// Simple commands for what plays.
namespace kfast {
namespace {

struct SteerOptions {
    std::string text; ///< what the command takes, if anything
    DeviceOptions device;
};

/// Sends the message to all devices at once, and prints what they play then.
template <class Message>
void order(const Message& message, const DeviceOptions& options)
{
    OpenDevices devices{options};
    on_each(devices.all(), [&](RemoteDevice& device, std::size_t) { device.session().order(message); });
    print_playing(devices.all(), options);
}

void pause(const SteerOptions& options) { order(link::Pause{}, options.device); }
void resume(const SteerOptions& options) { order(link::Resume{}, options.device); }
void arm(const SteerOptions& options) { order(link::Arm{}, options.device); }
void disarm(const SteerOptions& options) { order(link::Disarm{}, options.device); }

/// The frame rate is that of what the device plays.
Time moment_of(const std::string& text, RemoteDevice& device)
{
    const auto playing = device.session().ask<link::Playing>(link::AskPlaying{});
    if (!playing.is_playing)
        throw Failure{"nothing plays: play a scene with 'kfast play'", ExitStatus::refused};
    const auto moment = read_time(text, playing.frame_rate);
    if (!moment)
        throw Failure{"'" + visible(text) +
                          "' is no moment: write a frame like 12.5, or a time like 1.5s or "
                          "500ms",
                      ExitStatus::wrong_usage};
    return *moment;
}

void seek(const SteerOptions& options)
{
    OpenDevices devices{options.device};
    std::vector<Time> moments(devices.all().size());
    on_each(devices.all(), [&](RemoteDevice& device, std::size_t index) {
        moments[index] = moment_of(options.text, device);
    });
    on_each(devices.all(), [&](RemoteDevice& device, std::size_t index) {
        device.session().order(link::Seek{moments[index]});
    });
    print_playing(devices.all(), options.device);
}

void set_speed(const SteerOptions& options)
{
    order(link::Speed{read_speed("FACTOR", options.text)}, options.device);
}

void set_brightness(const SteerOptions& options)
{
    order(link::Brightness{read_brightness("BRIGHTNESS", options.text)}, options.device);
}

/// Then it does not play any more, so it cannot report what it plays.
void boot(const SteerOptions& options)
{
    OpenDevices devices{options.device};
    on_each(devices.all(),
            [](RemoteDevice& device, std::size_t) { device.session().order(link::EnterBootLoader{}); });
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const RemoteDevice& device : devices.all()) {
        json.push_back({{"device", device.name()}});
        if (!options.device.json && !options.device.quiet)
            std::cout << device.name() << ": enters its boot loader\n";
    }
    if (options.device.json)
        std::cout << json_text(json);
}

std::shared_ptr<SteerOptions> with_devices(CLI::App& app)
{
    auto options = std::make_shared<SteerOptions>();
    declare_device_options(app, options->device);
    return options;
}

template <void (*act)(const SteerOptions&)>
void declare_plain(CLI::App& app)
{
    const auto options = with_devices(app);
    app.callback([options] { act(*options); });
}

/// One that takes a text.
template <void (*act)(const SteerOptions&)>
void declare_taking(CLI::App& app, const char* name, const char* help)
{
    const auto options = with_devices(app);
    app.add_option(name, options->text, help)->required();
    app.callback([options] { act(*options); });
}

void declare_seek(CLI::App& app)
{
    declare_taking<seek>(app, "MOMENT", "A frame like 12.5, or a time like 1.5s or 500ms");
}

void declare_speed(CLI::App& app)
{
    declare_taking<set_speed>(app, "FACTOR", "So many times as fast: 0.5, 2, or -1 for backwards");
}

void declare_brightness(CLI::App& app)
{
    declare_taking<set_brightness>(app, "BRIGHTNESS", "0 to 255, or a share like 40%");
}

}

const Command pause_command{.name = "pause",
                            .summary = "Hold the picture of a device",
                            .example = "kfast pause --device all",
                            .declare = declare_plain<pause>,
                            .group = devices_group};

const Command resume_command{.name = "resume",
                             .summary = "Let a device go on playing",
                             .example = "kfast resume --device all",
                             .declare = declare_plain<resume>,
                             .group = devices_group};

const Command arm_command{.name = "arm",
                          .summary = "Let the laser of a device shine",
                          .example = "kfast arm",
                          .declare = declare_plain<arm>,
                          .group = devices_group};

const Command disarm_command{.name = "disarm",
                             .summary = "Make the laser of a device dark, at once",
                             .example = "kfast disarm --device all",
                             .declare = declare_plain<disarm>,
                             .group = devices_group};

const Command seek_command{.name = "seek",
                           .summary = "Go to a moment of what a device plays",
                           .example = "kfast seek 1.5s",
                           .declare = declare_seek,
                           .group = devices_group};

const Command speed_command{.name = "speed",
                            .summary = "Play faster, slower or backwards on a device",
                            .example = "kfast speed 0.5",
                            .declare = declare_speed,
                            .group = devices_group};

const Command brightness_command{.name = "brightness",
                                 .summary = "Set how bright the display of a device is",
                                 .example = "kfast brightness 40%",
                                 .declare = declare_brightness,
                                 .group = devices_group};

const Command boot_command{.name = "boot",
                           .summary = "Let a device enter its boot loader, for another firmware",
                           .example = "kfast boot --device all",
                           .declare = declare_plain<boot>,
                           .group = devices_group};

}
