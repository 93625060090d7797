#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <optional>

namespace kfast::scene {

/// Reads the scene language (docs/scene-language.md) from `document`, the parsed text of `source`.
///
/// Errors and warnings go to `diagnostics`, up to about 100 of each. There is a scene exactly when
/// `diagnostics` holds no error afterwards, those of the parser included.
std::optional<Scene> read_scene(const kdl::Document& document, const SourceText& source,
                                Diagnostics& diagnostics);

/// The schema of the node that begins a scene.
schema::NodeSchema version_schema();
/// The names of the nodes on the outermost level.
std::span<const std::string_view> names_outermost();

}
