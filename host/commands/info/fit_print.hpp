#pragma once

#include "host/fit/beam_fit.hpp"
#include "host/fit/fit_report.hpp"

#include <string>

namespace kfast {

struct FitFacts {
    const std::string& file;
    const SceneView& scene;
    const fit::Target& target;
    const fit::FitReport& report;
};

/// A table for people.
std::string fit_text(const FitFacts& facts);
/// A JSON object for programs; docs/fit.md says what is in it.
std::string json_text(const FitFacts& facts);

struct BeamFitFacts {
    const std::string& file;
    const fit::Target& target;
    const fit::BeamFit& report;
};

/// A table for people.
std::string fit_text(const BeamFitFacts& facts);
/// A JSON object for programs; docs/fit.md says what is in it.
std::string json_text(const BeamFitFacts& facts);

}
