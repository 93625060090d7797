#pragma once

#include "host/geometry/outline.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::scene {

/// The shape of a character in the units of its font: x to the right from where the letter begins, y down
/// from the baseline.
struct Letter {
    std::vector<Outline> outlines;
    double advance = 0; ///< from where it begins to where the next one does
};

/// Letters, whatever kind of file they come from.
class Font {
public:
    virtual ~Font() = default;

    /// How many units the size of a text is.
    virtual double units_per_em() const = 0;
    /// Null when the font has no such character. Lives as long as the font.
    virtual const Letter* letter(char32_t character) = 0;
    /// What is added between these two letters, in units; most often less than 0.
    virtual double kerning(char32_t left, char32_t right) const = 0;
    /// Whether letters are lines, which a stroke makes visible, instead of outlines to fill.
    virtual bool has_lines() const = 0;
};

/// The fonts that a scene names, each loaded when it is first asked for.
class FontShelf {
public:
    /// Font files are looked for in `folder`. Nothing: there are only the fonts of bundled_names().
    explicit FontShelf(std::optional<std::string> folder) : folder_{std::move(folder)} {}

    /// The fonts that are part of this program, the default of texts first.
    static std::span<const std::string_view> bundled_names();
    /// Those of them that have `character`.
    std::vector<std::string_view> bundled_with(char32_t character);

    bool has_folder() const { return folder_.has_value(); }
    /// A bundled font, or a file whose path begins in the folder, which there must be. Lives as long as the
    /// shelf. Throws Failure, which names the path, when there is no such file or it is no font.
    Font& font(const std::string& name);

private:
    std::unique_ptr<Font> load(const std::string& name) const;

    std::optional<std::string> folder_;
    std::map<std::string, std::unique_ptr<Font>> fonts_;
};

}
