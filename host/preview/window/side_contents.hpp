#pragma once

#include "host/preview/panes/side_panel.hpp"
#include "host/preview/viewer/viewer.hpp"

namespace kfast {

/// The contents of the side of the window: the file and display of a scene, what is selected, the inputs and,
/// if it is wanted, the fit report. `scale` is how many pixels of the window a pixel of the panel takes.
SidePanel side_contents(Viewer& viewer, double scale);

}
