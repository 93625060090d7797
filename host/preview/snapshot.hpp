#pragma once

#include "host/preview/controls/script.hpp"
#include "host/preview/viewer/viewer.hpp"

#include <ostream>
#include <span>

namespace kfast {

/// A window of a preview as it looks after a script (play_script, which writes to `out`), drawn without a
/// display. What is being found out, as the fit report, is waited for.
Picture snapshot(Viewer& viewer, std::span<const ScriptStep> script, Size window, std::ostream& out);

}
