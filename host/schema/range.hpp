#pragma once

#include <limits>

namespace kfast::schema {

/// Both ends are inside.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

}
