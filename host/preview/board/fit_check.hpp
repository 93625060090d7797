#pragma once

#include "core/math/affine.hpp"
#include "host/preview/board/fit_lines.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast {

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
