#pragma once

#include "host/scene/language_schema.hpp"

#include <string>

namespace kfast {

/// A schema of scenes in the KDL Schema Language, version 2.0.0 (SCHEMA-SPEC.md of github.com/kdl-org/kdl).
/// What nodes of one name and place may be written with is one definition there, if they have several ways.
std::string schema_kdl(const scene::LanguageSchema& words);

}
