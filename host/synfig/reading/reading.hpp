#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/art/losses.hpp"
#include "host/synfig/evaluation/evaluator.hpp"
#include "host/synfig/reading/clock.hpp"
#include "host/synfig/reading/tracing.hpp"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace kfast::synfig {

/// A tree of bones as a skeleton.
struct LinkedRig {
    std::size_t rig = 0;                      ///< index into Reading::rigs
    std::map<std::string, std::size_t> bones; ///< guids, and indices into the bones of the rig
};

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
    /// Of the bones that things are linked to, by the guid of the bone that all of a tree hangs on.
    std::map<std::string, LinkedRig> linked_rigs;
};

/// Where layers stand.
struct Scope {
    Driver clock;
    std::string path; ///< names from the outermost: "body / arm"
    int depth = 0;
    std::function<double(double)> line_scale_factor; ///< by frames; a factor of the width of all lines
    bool is_deformed = false;                        ///< by a skeleton deformation above
};

}
