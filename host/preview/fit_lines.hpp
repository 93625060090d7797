#pragma once

#include "host/fit/beam_fit.hpp"
#include "host/fit/fit_report.hpp"
#include "host/fit/target.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast {

/// One line of a fit report at the side of a preview.
struct FitLine {
    enum class Verdict : std::uint8_t { neutral, good, bad };

    std::string text; ///< no longer than most_letters, but for words that are
    Verdict verdict = Verdict::neutral;

    static constexpr std::size_t most_letters = 36;

    friend bool operator==(const FitLine&, const FitLine&) = default;
};

/// Whether it fits, and why not; memory, speed, and what holds it back.
std::vector<FitLine> fit_lines(const fit::FitReport& report, const fit::Target& board);
std::vector<FitLine> fit_lines(const fit::BeamFit& report, const fit::Target& board);

}
