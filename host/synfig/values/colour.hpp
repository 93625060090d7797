#pragma once

namespace kfast::synfig {

/// As in the file: linear or not, as the canvas says by its gamma; not limited to 0 to 1.
struct Colour {
    double red = 0;
    double green = 0;
    double blue = 0;
    double alpha = 1;
};

}
