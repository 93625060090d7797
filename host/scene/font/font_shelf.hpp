#pragma once

#include "host/scene/font/font.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::scene {

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
