#pragma once

#include "core/math/affine.hpp"
#include "host/fit/beam_fit.hpp"
#include "host/fit/fit_report.hpp"
#include "host/fit/target.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
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

/// Whether it fits what; speed and memory; why it does not fit, and further notes.
std::vector<FitLine> fit_lines(const fit::FitReport& report, const fit::Target& board);
std::vector<FitLine> fit_lines(const fit::BeamFit& report, const fit::Target& board);

/// A fit report that is made on a thread of its own, from copies of all that it needs: nothing has to
/// outlive the check. A scene of some seconds takes a tenth of a second or two, a long one many seconds.
class FitCheck {
public:
    /// `scene` is a checked scene.
    FitCheck(std::span<const std::byte> scene, std::vector<std::string> item_names, fit::Target board,
             Fit fit);
    /// Ends the thread, which takes no longer than a picture.
    ~FitCheck();
    FitCheck(const FitCheck&) = delete;

    /// None until it is done; then they stay.
    std::optional<std::span<const FitLine>> lines() const;

private:
    class Work;
    std::unique_ptr<Work> work_;
};

}
