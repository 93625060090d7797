#pragma once

#include "host/fit/beam_fit.hpp"
#include "host/fit/fit_report.hpp"
#include "host/fit/target.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace kfast {

/// One line of a fit report at the side of a preview, or a sentence that takes several there.
struct FitLine {
    enum class Verdict : std::uint8_t { neutral, good, bad };

    std::string text;
    Verdict verdict = Verdict::neutral;

    friend bool operator==(const FitLine&, const FitLine&) = default;
};

/// Whether it fits what; speed and memory; why it does not fit, and what is worth knowing.
std::vector<FitLine> fit_lines(const fit::FitReport& report, const fit::Target& board);
std::vector<FitLine> fit_lines(const fit::BeamFit& report, const fit::Target& board);

}
