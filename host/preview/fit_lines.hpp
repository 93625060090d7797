#pragma once

#include "core/scene_view.hpp"
#include "host/fit/target.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// One line of a fit report at the side of a preview.
struct FitLine {
    enum class Verdict : std::uint8_t { neutral, good, bad };
    std::string text; ///< no longer than 38 characters
    Verdict verdict = Verdict::neutral;
};

/// The board that a preview judges by: a Pico with the panel of that name, or with its usual one if the name
/// is empty or no controller's; with a beam if `is_beam`.
fit::Target previewed_board(std::string_view panel_name, bool is_beam);

/// Whether a scene fits a board: memory, speed, and what holds it back. May take seconds for a long scene.
std::vector<FitLine> fit_lines(const SceneView& scene, std::span<const std::string> item_names,
                               const fit::Target& board);

/// A fit report that is being made on a thread of its own, on copies of all that it looks at.
class FitCheck {
public:
    FitCheck(const SceneView& scene, std::vector<std::string> item_names, fit::Target board);
    /// Stops the thread, which takes no longer than a picture.
    ~FitCheck();
    FitCheck(const FitCheck&) = delete;

    /// Nothing until it is done.
    std::optional<std::span<const FitLine>> lines() const;

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

}
