#pragma once

#include "host/scene/language_schema.hpp"

#include <string>
#include <string_view>

namespace kfast {

/// "whole number", "colour": what a value is called in the schemas.
std::string_view type_name(schema::ValueType type);

/// For tools: an object whose form docs/editors.md describes.
std::string schema_json(const scene::LanguageSchema& words);

/// Two tables for docs/scene-language.md: all nodes, and all properties.
std::string schema_markdown(const scene::LanguageSchema& words);

/// A schema of scenes in the KDL Schema Language, version 2.0.0 (SCHEMA-SPEC.md of github.com/kdl-org/kdl).
/// What nodes of one name and place may be written with is one definition there, if they have several ways.
std::string schema_kdl(const scene::LanguageSchema& words);

}
