#include "host/commands/render/audio_options.hpp"

#include "host/commands/options/option_groups.hpp"
#include "host/commands/render/sound_beam.hpp"
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
    const OptionHeading heading{app, option_group::sound};
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

BeamProfile heard_profile(const AudioOptions& audio, const std::optional<ChosenBeam>& beam)
{
    return sound_beam(beam ? std::optional{beam->profile} : std::nullopt, audio.sound.rate);
}

std::shared_ptr<LedBeam> opened_sound(const AudioOptions& audio, const BeamProfile& profile)
{
    return std::make_shared<LedBeam>(profile, audio.sound.deflection, audio.device);
}

}
