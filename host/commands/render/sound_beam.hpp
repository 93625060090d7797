#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/beam/beam_source.hpp"
#include "host/commands/render/picture_options.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// The profile that was chosen, else that of sound, with as many points in a second as the sound has samples.
BeamProfile sound_beam(const std::optional<BeamProfile>& chosen, std::uint32_t rate);

/// The points of the scene's pictures, with the inputs as chosen. `scene` must outlive it.
BeamSource open_beam(const BeamProfile& profile, std::uint32_t budget, const PictureOptions& inputs,
                     const SceneFile& scene);

}
