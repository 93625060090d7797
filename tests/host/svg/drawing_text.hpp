#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/svg/poses/key_options.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace kfast::test {

/// The text of a drawing of 100 x 100 pixels around `content`.
std::string drawing(std::string_view content, std::string_view attributes = R"(width="100" height="100")");

/// What the reader makes of a drawing() that it takes as it is; fails the test when something is lost.
art::Document read_drawing(std::string_view content,
                           std::string_view attributes = R"(width="100" height="100")",
                           const svg::KeyOptions& options = {});

/// Likewise, whatever is lost.
art::Document read_lossy(std::string_view content);

/// The same with key drawings, each the content of a drawing().
art::Document read_drawings(const std::vector<std::string>& contents, const std::vector<double>& times,
                            const svg::KeyOptions& options = {});

/// The same, with what is lost: "feature | layer | instead".
std::vector<std::string> losses_of(std::string_view content);
std::vector<std::string> losses_of_keys(const std::vector<std::string>& contents,
                                        const std::vector<double>& times);

/// The node of that name, wherever it lies; fails the test if there is none.
const art::Node& find(const art::Document& document, std::string_view name);
const art::Shape& shape(const art::Document& document, std::string_view name);

/// The box around the points of a drawing: least x, least y, most x, most y.
std::vector<double> box(const art::Drawing& drawing);

/// "#rrggbb".
std::string hex(const art::Rgb& colour);

/// What reading a whole text fails with; empty if it does not.
std::string failure_of(const std::string& text, const svg::KeyOptions& options = {});

}
