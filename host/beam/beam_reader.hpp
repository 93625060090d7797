#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/kdl/document.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/report.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <optional>

namespace kfast {

/// How a node that describes a beam looks (docs/beam.md).
inline constexpr schema::NodeForm beam_form{"beam", "beam galvo, or beam galvo rate=(kHz)30 corner-dwell=6",
                                            1, 1};

/// `beam galvo rate=(kHz)30 corner-dwell=6 …`, of the form above: what is not given is as in the profile that
/// is named. Reports what is wrong and then returns nothing.
std::optional<BeamProfile> read_beam(const kdl::Node& node, schema::Report& report);

/// Reads a text that holds one such node. Any text is allowed; what is wrong goes to `diagnostics`, and there
/// is a beam exactly when nothing was.
std::optional<ChosenBeam> read_beam_text(const SourceText& source, Diagnostics& diagnostics);

}
