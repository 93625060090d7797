#include "host/commands/command.hpp"
#include "host/commands/device_options.hpp"
#include "host/commands/line_source.hpp"
#include "host/commands/live_line.hpp"
#include "host/commands/pace.hpp"
#include "host/commands/playing_text.hpp"
#include "host/commands/sent_scene.hpp"
#include "host/failure.hpp"
#include "host/link/live_sending.hpp"
#include "host/link/on_each.hpp"
#include "host/scene_file.hpp"

#include <atomic>
#include <deque>
#include <exception>
#include <optional>
#include <thread>
#include <unistd.h>

namespace kfast {
namespace {

/// What a device does when no more values come.
enum class Afterwards { go_on, hold, back };

const std::map<std::string, Afterwards> afterwards_words{
    {"go-on", Afterwards::go_on}, {"hold", Afterwards::hold}, {"return", Afterwards::back}};

struct Options {
    std::string file;
    std::optional<double> rate;
    Afterwards afterwards = Afterwards::go_on;
    double silence = 1; ///< seconds after which the device takes this computer for gone
    DeviceOptions device;
};

Milliseconds silence_of(const Options& options)
{
    return Milliseconds{static_cast<Milliseconds::rep>(options.silence * 1000)};
}

std::vector<LiveInput> inputs_of(const SceneView& scene)
{
    std::vector<LiveInput> inputs;
    for (InputCursor cursor = scene.inputs(); !cursor.at_end();) {
        const InputView input = cursor.next();
        inputs.push_back({std::string{input.name}, input.least, input.most});
    }
    return inputs;
}

/// Of what it plays. It is asked, so values that make no sense are possible.
std::vector<LiveInput> inputs_of(RemoteDevice& device)
{
    Session& session = device.session();
    const std::uint8_t count = session.ask<link::Playing>(link::AskPlaying{}).inputs;
    std::vector<LiveInput> inputs;
    for (std::uint8_t number = 0; number < count; ++number) {
        const auto input = session.ask<link::InputState>(link::AskInput{number});
        if (input.least >= input.most)
            throw Failure{device.name() + ": tells an input without values: try again", ExitStatus::refused};
        inputs.push_back({std::string{input.name.view()}, input.least, input.most});
    }
    return inputs;
}

std::vector<LiveInput> common_inputs(std::span<RemoteDevice> devices)
{
    std::vector<std::vector<LiveInput>> inputs(devices.size());
    on_each(devices, [&](RemoteDevice& device, std::size_t index) { inputs[index] = inputs_of(device); });
    for (const auto& others : inputs)
        if (others != inputs.front())
            throw Failure{
                "the devices play scenes with different inputs: name the scene that all are to play",
                ExitStatus::wrong_usage};
    return inputs.front();
}

/// Values from standard input on their way to devices: a thread reads, and one for each device sends.
class LiveStream {
public:
    LiveStream(const Options& options, std::span<RemoteDevice> devices, std::vector<LiveInput> inputs)
        : options_{options}, devices_{devices}, inputs_{std::move(inputs)}, feeds_(devices.size())
    {
    }

    void run()
    {
        std::jthread reader{[this] { read(); }};
        on_each(devices_, [this](RemoteDevice& device, std::size_t index) { send(device, feeds_[index]); });
        reader.join();
        if (mistake_)
            std::rethrow_exception(mistake_);
    }

private:
    static constexpr Milliseconds unheeded_at_most{100};

    void read()
    {
        try {
            read_lines();
        } catch (...) {
            mistake_ = std::current_exception();
        }
        for (LiveFeed& feed : feeds_)
            feed.close();
    }

    bool has_to_end() const { return has_failed_ || was_interrupted(); }

    void read_lines()
    {
        LineSource lines{STDIN_FILENO};
        Pace pace{options_.rate};
        while (!has_to_end() && !lines.is_over()) {
            const auto line = lines.next(unheeded_at_most);
            if (!line)
                continue;
            const auto places = read_live_line(*line, lines.number(), inputs_);
            if (places.empty())
                continue;
            while (!has_to_end() && !pace.is_due(unheeded_at_most))
                continue;
            for (LiveFeed& feed : feeds_)
                feed.put(places);
        }
    }

    void send(RemoteDevice& device, LiveFeed& feed)
    {
        Session& session = device.session();
        try {
            arm(session);
            send_live(session, feed, silence_of(options_) / 3);
            disarm(session);
        } catch (const Failure&) {
            has_failed_ = true;
            leave(session);
            throw;
        }
    }

    bool wants_watch() const { return options_.afterwards != Afterwards::go_on; }

    /// So that it is done also if this computer just stops.
    void arm(Session& session) const
    {
        const auto action =
            options_.afterwards == Afterwards::hold ? link::SilenceAction::hold : link::SilenceAction::start;
        if (wants_watch())
            session.order(link::Silence{static_cast<std::uint16_t>(silence_of(options_).count()), action});
    }

    void disarm(Session& session) const
    {
        if (options_.afterwards == Afterwards::hold)
            session.order(link::Pause{});
        if (options_.afterwards == Afterwards::back)
            session.order(link::Play{.home = link::Home::start}, patience_to_begin);
        if (wants_watch())
            session.order(link::Silence{});
    }

    /// The same where nobody wants to wait any more.
    void leave(Session& session) const
    {
        if (options_.afterwards == Afterwards::hold)
            session.take_leave(link::report_of(link::Pause{}, session.new_tag()));
        if (options_.afterwards == Afterwards::back)
            session.take_leave(link::report_of(link::Play{.home = link::Home::start}, session.new_tag()));
        if (wants_watch())
            session.take_leave(link::report_of(link::Silence{}, session.new_tag()));
    }

    const Options& options_;
    std::span<RemoteDevice> devices_;
    std::vector<LiveInput> inputs_;
    std::deque<LiveFeed> feeds_; ///< one a device
    std::atomic<bool> has_failed_ = false;
    std::exception_ptr mistake_; ///< of the reader
};

/// The inputs of what plays then on all devices.
std::vector<LiveInput> begin(const Options& options, std::span<RemoteDevice> devices,
                             const std::optional<SceneFile>& scene)
{
    if (!scene)
        return common_inputs(devices);
    send_into_ram(*scene, devices, options.device);
    on_each(devices, [](RemoteDevice& device, std::size_t) {
        device.session().order(link::Play{.home = link::Home::ram}, patience_to_begin);
    });
    return inputs_of(scene->view);
}

void require_inputs(std::span<const LiveInput> inputs)
{
    if (inputs.empty())
        throw Failure{"what plays has no inputs: give it one like 'input gaze min=-1 max=1', or name a scene "
                      "that has some"};
}

void live(const Options& options)
{
    std::optional<SceneFile> scene;
    if (!options.file.empty()) {
        scene.emplace(load_scene(options.file));
        require_inputs(inputs_of(scene->view));
    }
    OpenDevices devices{options.device};
    const auto inputs = begin(options, devices.all(), scene);
    require_inputs(inputs);
    LiveStream{options, devices.all(), inputs}.run();
    print_playing(devices.all(), options.device);
}

void declare(CLI::App& app)
{
    constexpr double fastest = 1000;
    constexpr double shortest_silence = 0.1;
    constexpr double longest_silence = 60;
    const auto options = std::make_shared<Options>();
    app.add_option("SCENE", options->file,
                   "A scene text (.kfast) or compiled scene (.kfb) to play from RAM (default: what plays)");
    app.add_option("--rate", options->rate, "So many lines a second (default: as they come)")
        ->type_name("NUMBER")
        ->check(CLI::Range(0.01, fastest));
    app.add_option("--on-silence", options->afterwards,
                   "When no more values come: go-on playing (default), hold the picture, or return to the "
                   "scene of the start")
        ->type_name("WHAT")
        ->transform(CLI::CheckedTransformer(afterwards_words));
    app.add_option("--silence", options->silence,
                   "Seconds after which a device takes this computer for gone (default: 1)")
        ->type_name("SECONDS")
        ->check(CLI::Range(shortest_silence, longest_silence));
    declare_device_options(app, options->device);
    app.callback([options] { live(*options); });
}

}

const Command live_command{.name = "live",
                           .summary = "Set inputs of what plays on a device from standard input",
                           .example = "echo gaze 0.5 | kfast live eyes.kfast",
                           .declare = declare,
                           .group = devices_group};

}
