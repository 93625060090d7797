#include "host/commands/render/sound_beam.hpp"

#include "host/sound/sound_profile.hpp"

namespace kfast {

BeamProfile sound_beam(const std::optional<BeamProfile>& chosen, std::uint32_t rate)
{
    BeamProfile profile = chosen.value_or(sound_profile);
    profile.rate = rate;
    return profile;
}

BeamSource open_beam(const BeamProfile& profile, std::uint32_t budget, const PictureOptions& inputs,
                     const SceneFile& scene)
{
    BeamSource source{scene.view, profile, budget};
    apply_inputs(inputs, scene, source);
    return source;
}

}
