#include "firmware/link/input_message.hpp"
#include "host/commands/command.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/commands/devices/playing_text.hpp"
#include "host/commands/devices/sending.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/live/live_stream.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/compile/scene_file.hpp"
#include "host/link/remote_device.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <functional>
#include <optional>
#include <unistd.h>

namespace kfast {
namespace {

struct AfterwardsWord {
    std::string_view word;
    Afterwards meaning;
};

constexpr std::array afterwards_words{
    AfterwardsWord{"go-on", Afterwards::go_on},
    AfterwardsWord{"hold", Afterwards::hold},
    AfterwardsWord{"return", Afterwards::back},
};

Afterwards read_afterwards(const std::string& text)
{
    const auto found = std::ranges::find(afterwards_words, text, &AfterwardsWord::word);
    if (found != afterwards_words.end())
        return found->meaning;
    std::array<std::string_view, afterwards_words.size()> words;
    std::ranges::transform(afterwards_words, words.begin(), &AfterwardsWord::word);
    throw CLI::ValidationError("--on-silence",
                               "'" + visible(text) + "' is unknown: " + suggestion(text, words));
}

struct LiveOptions {
    std::string file;
    StreamOptions stream_options;
    double silence = 1; ///< in seconds
    DeviceOptions device;
};

LiveInput live_input(const InputView& input)
{
    LiveInput live{std::string{input.name}, input.type, input.min, input.max};
    if (input.type == InputType::text) {
        live.max = static_cast<std::int32_t>(input.text.max);
        live.glyphs = input.text.glyphs;
    }
    return live;
}

std::vector<LiveInput> live_inputs(const SceneView& scene)
{
    std::vector<LiveInput> inputs;
    for (InputCursor cursor = scene.inputs(); !cursor.at_end();) {
        const InputView input = cursor.next();
        inputs.push_back(live_input(input));
    }
    return inputs;
}

/// The inputs of what it plays. The device answers, so values that make no sense are possible.
std::vector<LiveInput> live_inputs(RemoteDevice& device)
{
    Session& session = device.session();
    const std::uint8_t count = session.ask<link::Playing>(link::AskPlaying{}).inputs;
    std::vector<LiveInput> inputs;
    for (std::uint8_t number = 0; number < count; ++number) {
        const auto input = session.ask<link::InputState>(link::AskInput{number});
        const bool is_number = input.takes == link::InputKind::number;
        if (is_number && input.min >= input.max)
            throw Failure{device.name() + ": tells an input without values: try again", ExitStatus::refused};
        inputs.push_back(
            {std::string{input.name.view()}, static_cast<InputType>(input.takes), input.min, input.max});
    }
    return inputs;
}

std::vector<LiveInput> common_inputs(std::span<RemoteDevice> devices)
{
    std::vector<std::vector<LiveInput>> inputs(devices.size());
    on_each(devices, [&](RemoteDevice& device, std::size_t index) { inputs[index] = live_inputs(device); });
    for (const auto& others : inputs)
        if (!std::ranges::equal(others, inputs.front(), std::mem_fn(&LiveInput::is_like)))
            throw Failure{
                "the devices play scenes with different inputs: name the scene that all are to play",
                ExitStatus::wrong_usage};
    return inputs.front();
}

/// The inputs of what plays then on all devices.
std::vector<LiveInput> begin(const LiveOptions& options, std::span<RemoteDevice> devices,
                             const std::optional<SceneFile>& scene)
{
    if (!scene)
        return common_inputs(devices);
    const SentScene in_ram{*scene, devices, options.device};
    on_each(devices, [&](RemoteDevice&, std::size_t index) { in_ram.play(index, {}); });
    return live_inputs(scene->view);
}

void require_inputs(std::span<const LiveInput> inputs)
{
    if (inputs.empty())
        throw Failure{"what plays has no inputs: give it one like 'input gaze min=-1 max=1', or name a scene "
                      "that has some"};
}

/// One that was closed at the start cannot be read since (host/main.cpp).
void require_standard_input()
{
    const int flags = ::fcntl(STDIN_FILENO, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_WRONLY)
        throw Failure{"standard input is closed: live values are read from there"};
}

void live(const LiveOptions& options)
{
    require_standard_input();
    std::optional<SceneFile> scene;
    if (!options.file.empty()) {
        scene.emplace(load_scene(options.file));
        require_inputs(live_inputs(scene->view));
    }
    OpenDevices devices{options.device};
    const auto inputs = begin(options, devices.all(), scene);
    require_inputs(inputs);
    StreamOptions stream_options = options.stream_options;
    stream_options.silence = Milliseconds{static_cast<Milliseconds::rep>(options.silence * 1000)};
    stream_live(devices.all(), inputs, stream_options);
    print_playing(devices.all(), options.device);
}

void declare_stream_options(CLI::App& app, LiveOptions& options)
{
    constexpr double fastest = 1000;
    constexpr double shortest_silence = 0.1;
    constexpr double longest_silence = 60;
    const OptionHeading heading{app, option_group::play};
    app.add_option("--rate", options.stream_options.rate, "So many lines a second (default: as they come)")
        ->type_name("NUMBER")
        ->check(number_within(0.01, fastest));
    app.add_option_function<std::string>(
           "--on-silence",
           [&options](const std::string& text) { options.stream_options.afterwards = read_afterwards(text); },
           "When no more values come: go-on playing (default), hold the picture, or return to the "
           "scene of the start")
        ->type_name("WHAT");
    app.add_option("--silence", options.silence,
                   "Seconds after which a device takes this computer for gone (default: 1)")
        ->type_name("SECONDS")
        ->check(number_within(shortest_silence, longest_silence));
}

void declare_live(CLI::App& app)
{
    const auto options = std::make_shared<LiveOptions>();
    reads_scene(app.add_option("SCENE", options->file,
                               std::string{loaded_scene} + " to play from RAM (default: what plays)"));
    declare_stream_options(app, *options);
    declare_device_options(app, options->device);
    app.callback([options] { live(*options); });
}

}

const Command live_command{.name = "live",
                           .summary = "Set inputs of what plays on a device from standard input",
                           .example = "kfast live eyes.kfast --rate 30 <poses.txt",
                           .declare = declare_live,
                           .group = devices_group};

}
