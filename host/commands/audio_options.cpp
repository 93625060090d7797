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

std::unique_ptr<FrameSource> heard(std::unique_ptr<FrameSource> picture, const AudioOptions& audio,
                                   const PictureOptions& options, const SceneFile& scene)
{
    if (!audio.is_heard)
        return picture;
    const auto& beam = options.screen.beam;
    const BeamProfile profile =
        sound_beam(beam ? std::optional{beam->profile} : std::nullopt, audio.sound.rate);
    return std::make_unique<BeamSound>(std::move(picture),
                                       open_beam(profile, BeamSource::any_number, options, scene),
                                       audio.sound.deflection, audio.device);
}

}
