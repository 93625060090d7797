#pragma once

#include "core/time/clock.hpp"
#include "core/time/time.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/context/palette.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/font/font_shelf.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/report.hpp"
#include "host/schema/variables.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The points that the drawings of a scene may still have. Copies of symbols would soon be more than any
/// memory holds.
class PointBudget {
public:
    /// Returns false if they are too many; then nothing is taken.
    bool take(std::size_t points)
    {
        if (points > left_)
            return false;
        left_ -= points;
        return true;
    }

private:
    std::size_t left_ = max_points_of_scene;
};

// What the rules of the language are written with.
using schema::any_colour;
using schema::any_font;
using schema::any_law;
using schema::any_moment;
using schema::any_name;
using schema::any_path;
using schema::any_spot;
using schema::any_text;
using schema::any_time;
using schema::has_property;
using schema::NameTable;
using schema::NodeForm;
using schema::NodeSchema;
using schema::property_span;
using schema::PropertySchema;
using schema::Range;
using schema::Report;
using schema::span;
using schema::truth;
using schema::ValueKind;
using schema::Word;
using schema::word_names;

/// A text whose letters are lines, which a fill does not show.
struct LineLetters {
    std::string font;
    SourceSpan place;
};

/// What is known about a scene while its nodes are read.
struct SceneContext {
    Report report;
    Palette palette;
    FontShelf fonts;
    std::uint32_t frame_rate = 30'000; ///< frames in 1000 seconds
    std::optional<Time> length = {};   ///< if the canvas gives one
    Time last_key = {};                ///< of all that have been read
    /// The times of their own of uses, each once; their drivers are what is around the use.
    std::vector<Clock> clocks = {};
    InputTable inputs = {};
    SkeletonTable skeletons = {};
    SymbolTable symbols = {};
    NameTable object_names = {};
    schema::Variables variables = {};
    PointBudget points = {};
    std::size_t posed_bones = 0;                  ///< that the poses so far set
    std::optional<LineLetters> line_letters = {}; ///< the first in the drawings of the object or symbol
};

inline Report& report_of(SceneContext& context) { return context.report; }

/// Whether the scene has room for as many points, a key counted as one; reports it if not.
bool take_points(std::size_t points, SourceSpan place, SceneContext& context);

/// A rule in the tables of the language.
template <class Target>
using PropertyRule = schema::PropertyRule<Target, SceneContext>;

}
