#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/kdl/document.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/report.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Lengths and positions in the field as a person writes them: in percent of the field's width.
namespace kfast {

inline constexpr double units_per_percent = field_side / 100.0;

/// Rounded to nearest, within the range of steps; only a step of 0 % is none.
inline std::uint16_t field_step(double percent)
{
    const long min = percent > 0 ? 1 : 0;
    return static_cast<std::uint16_t>(std::clamp(std::lround(percent * units_per_percent), min, 0xFFFFL));
}

/// Rounded to nearest, within the range; 0 % is the middle.
inline std::int16_t field_place(double percent)
{
    return static_cast<std::int16_t>(
        std::clamp(std::lround(percent * units_per_percent), long{field_min}, long{field_max}));
}

/// The form of a node that describes a beam (docs/beam.md).
inline constexpr schema::NodeForm beam_form{"beam", "beam galvo, or beam galvo rate=(kHz)30 corner-dwell=6",
                                            1, 1};

/// `beam galvo rate=(kHz)30 corner-dwell=6 …`, of the form above: what is not given is as in the named
/// profile. Reports mistakes and then returns nothing.
std::optional<BeamProfile> read_beam(const kdl::Node& node, schema::Report& report);

/// Reads a text that holds one such node. Any text is allowed; mistakes are reported to `diagnostics`, and
/// there is a beam exactly when there are none.
std::optional<ChosenBeam> read_beam_text(const SourceText& source, Diagnostics& diagnostics);

/// A profile as a node that read_beam() reads as the same one, without a line end after it: the base is the
/// ready profile that it is most like, and every property is there. All lines except the first begin with
/// `indent`.
std::string beam_text(const BeamProfile& profile, std::string_view indent = {});

}
