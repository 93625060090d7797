#include "host/commands/audio_options.hpp"

#include "host/commands/sound_beam.hpp"
#include "host/sound/beam_sound.hpp"
#include "host/sound/sound_card.hpp"

#include <iostream>
#include <utility>

namespace kfast {
namespace {

void list_devices()
{
    const std::vector<std::string> names = SoundCard::names();
    if (names.empty())
        std::cout << "there is no sound card\n";
    for (const std::string& name : names)
        std::cout << name << '\n';
    throw CLI::Success{};
}

}

CLI::Option* declare_audio_options(CLI::App& app, AudioOptions& options)
{
    CLI::Option* audio = app.add_flag("--audio", options.is_heard,
                                      "Lead an oscilloscope on the sound card too: x left, y right");
    app.add_option("--audio-device", options.device, "Which sound card (default: the usual one)")
        ->type_name("NAME")
        ->needs(audio);
    app.add_flag_callback("--audio-devices", list_devices, "List the sound cards, and do nothing else")
        ->trigger_on_parse();
    for (CLI::Option* option : declare_sound_options(app, options.sound))
        option->needs(audio);
    return audio;
}

std::unique_ptr<FrameSource> heard(std::unique_ptr<FrameSource> picture, const AudioOptions& options,
                                   const std::optional<BeamProfile>& beam, const PictureOptions& inputs,
                                   const SceneFile& scene)
{
    if (!options.is_heard)
        return picture;
    BeamSource source =
        open_beam(sound_beam(beam, options.sound.rate), BeamSource::any_number, inputs, scene);
    return std::make_unique<BeamSound>(std::move(picture), std::move(source), options.sound.deflection,
                                       options.device);
}

}
