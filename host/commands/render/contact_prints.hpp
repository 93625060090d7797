#pragma once

#include "core/scene/scene_view.hpp"
#include "host/picture/contact_sheet.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/progress_callback.hpp"

#include <string>
#include <vector>

namespace kfast {

/// A picture of a contact sheet that is yet to be drawn.
struct ContactMoment {
    Time time;
    std::string label; ///< its frame and its seconds in the scene
};

/// The times between the ends of what is played at which anything has a key; or only the first time, if
/// nothing has one there.
std::vector<ContactMoment> contact_moments(const SceneView& scene, const Timeline& timeline);

/// How large pictures are drawn, and how they are arranged.
struct ContactPlan {
    Size picture;
    int divisor = 1; ///< by which they are smaller than asked for
    ContactLayout layout;
};

/// Pictures of this size, or smaller, so that a sheet has room for all of them. Throws Failure if it has no
/// room for small ones either.
ContactPlan contact_plan(const std::vector<ContactMoment>& moments, Size picture, int scale);

/// `source` draws pictures as large as planned.
std::vector<ContactPrint> contact_prints(const std::vector<ContactMoment>& moments, FrameSource& source,
                                         const ProgressCallback& on_progress);

}
