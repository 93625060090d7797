#pragma once

#include "host/art/affine.hpp"
#include "host/art/budget.hpp"
#include "host/art/document.hpp"
#include "host/art/losses.hpp"
#include "host/synfig/clock.hpp"
#include "host/synfig/evaluator.hpp"
#include "host/synfig/tracing.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace kfast::synfig {

/// What reading goes along with, through the whole file.
struct Reading {
    const XmlFile& file;
    ValueReader& values;
    Evaluator& evaluator;
    art::Losses& losses;
    art::Budget& budget;
    art::Affine to_canvas;      ///< from units of the file, y up, to pixels
    double pixels_per_unit = 1; ///< above 0
    double width = 0;           ///< of the canvas, in pixels
    double height = 0;
    double begin = 0; ///< seconds
    double frame_rate = 24;
    double frames = 1;
    std::array<double, 3> gamma{1, 1, 1}; ///< of red, green and blue
    std::vector<art::Rig> rigs;
};

/// Where layers stand.
struct Scope {
    Clock clock;
    std::string path; ///< names from the outermost: "body / arm"
    int depth = 0;
    std::function<double(double)> line_growth; ///< by frames; a factor of the width of all lines
};

}
