#pragma once

#include "core/time/time.hpp"
#include "host/scene/font_shelf.hpp"
#include "host/scene/input_table.hpp"
#include "host/scene/name_table.hpp"
#include "host/scene/palette.hpp"
#include "host/scene/point_budget.hpp"
#include "host/scene/skeleton_table.hpp"
#include "host/scene/symbol_table.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kfast::scene {

/// Passes on what is wrong with a scene, until it is so much that more helps nobody.
class Report {
public:
    Report(const SourceText& source, Diagnostics& diagnostics) : source_{source}, diagnostics_{diagnostics} {}

    /// Always false, so that a reader can return it.
    bool error(Place place, std::string message, std::string remedy = {});
    void warning(Place place, std::string message, std::string remedy = {});

    /// Errors are no longer passed on; reading may stop.
    bool full() const { return errors_ > most_errors; }
    /// "line 12". Looks through the text: only for messages.
    std::string line(Place place) const;

private:
    static constexpr std::size_t most_errors = 100;
    static constexpr std::size_t most_warnings = 100;

    const SourceText& source_;
    Diagnostics& diagnostics_;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
};

/// A text whose letters are lines, which a fill does not show.
struct LineLetters {
    std::string font;
    Place place;
};

/// What is known of a scene while its nodes are read.
struct Reading {
    Report report;
    Palette palette;
    FontShelf fonts;
    std::uint32_t frame_rate = 30'000; ///< frames in 1000 seconds
    std::optional<Time> length = {};   ///< if the canvas gives one
    Time last_key = {};                ///< of all that have been read
    InputTable inputs = {};
    SkeletonTable skeletons = {};
    SymbolTable symbols = {};
    NameTable object_names = {};
    PointBudget points = {};
    std::size_t posed_bones = 0;                  ///< that the poses so far set
    std::optional<LineLetters> line_letters = {}; ///< the first in the drawings of the object or symbol
};

/// Whether `name` is new among `names`, those of the kind `noun`; reports it if not. `place` is what to mark.
bool add_name(NameTable& names, std::string_view noun, std::string_view name, Place place, Report& report);
/// Always false.
bool report_double(std::string_view noun, std::string_view name, Place place, Place earlier, Report& report);

/// From the start of `first` to the end of `last`.
constexpr Place span(Place first, Place last)
{
    return {first.offset, last.offset + last.length - first.offset};
}

}
