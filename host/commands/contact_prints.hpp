#pragma once

#include "core/scene_view.hpp"
#include "host/picture/contact_sheet.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/tell_work.hpp"

#include <vector>

namespace kfast {

/// The moments between the ends of what is played at which anything has a key, each with its frame and its
/// seconds in the scene; or only the first moment, if none has one there.
std::vector<ContactPrint> contact_prints(const SceneView& scene, const Timeline& timeline,
                                         FrameSource& source, const TellWork& tell);

}
