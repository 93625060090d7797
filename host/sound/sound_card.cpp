#include "host/sound/sound_card.hpp"

#include "host/program/failure.hpp"
#include "host/text/characters.hpp"

#include <SDL.h>
#include <bit>
#include <utility>

namespace kfast {
namespace {

/// A power of two, of 11 to 21 ms: keys are answered at once, and SDL's thread comes in time at high rates,
/// too.
Uint16 samples_at_once(std::uint32_t rate)
{
    constexpr std::uint32_t buffers_a_second = 94;
    return static_cast<Uint16>(std::bit_ceil(rate / buffers_a_second));
}

/// SDL's sound, while there is one of these.
class Audio {
public:
    Audio()
    {
        if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0)
            throw Failure(std::string("there is no sound: ") + SDL_GetError());
    }
    ~Audio() { SDL_QuitSubSystem(SDL_INIT_AUDIO); }
    Audio(const Audio&) = delete;
    Audio& operator=(const Audio&) = delete;
};

class SdlSoundCard final : public SoundCard {
public:
    SdlSoundCard(const std::string& name, std::uint32_t rate, Next next) : next_{std::move(next)}
    {
        SDL_AudioSpec wanted{};
        wanted.freq = static_cast<int>(rate);
        wanted.format = AUDIO_S32SYS;
        wanted.channels = 2;
        wanted.samples = samples_at_once(rate);
        wanted.callback = fill;
        wanted.userdata = this;
        device_ = SDL_OpenAudioDevice(name.empty() ? nullptr : name.c_str(), 0, &wanted, nullptr, 0);
        if (device_ == 0)
            throw Failure("cannot play on " + (name.empty() ? "the sound card" : in_quotes(name)) + ": " +
                          SDL_GetError() + ": --audio-devices lists the ones there are");
        SDL_PauseAudioDevice(device_, 0);
    }
    ~SdlSoundCard() override { SDL_CloseAudioDevice(device_); }
    SdlSoundCard(const SdlSoundCard&) = delete;
    SdlSoundCard& operator=(const SdlSoundCard&) = delete;

private:
    static void fill(void* self, Uint8* bytes, int size)
    {
        static_cast<SdlSoundCard*>(self)->next_(
            {reinterpret_cast<StereoSample*>(bytes), static_cast<std::size_t>(size) / sizeof(StereoSample)});
    }

    Audio audio_;
    Next next_;
    SDL_AudioDeviceID device_ = 0;
};

}

std::unique_ptr<SoundCard> SoundCard::open(const std::string& name, std::uint32_t rate, Next next)
{
    return std::make_unique<SdlSoundCard>(name, rate, std::move(next));
}

std::vector<std::string> SoundCard::names()
{
    const Audio audio;
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(SDL_GetNumAudioDevices(0)));
    for (int number = 0; number < SDL_GetNumAudioDevices(0); ++number)
        names.emplace_back(SDL_GetAudioDeviceName(number, 0));
    return names;
}

}
