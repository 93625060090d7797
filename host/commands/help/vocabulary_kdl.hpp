#pragma once

#include "host/scene/vocabulary.hpp"

#include <string>

namespace kfast {

/// A schema of scenes in the KDL Schema Language, version 2.0.0 (SCHEMA-SPEC.md of github.com/kdl-org/kdl).
/// What nodes of one name and place may be written with is one definition there, if they have several ways.
std::string vocabulary_kdl(const scene::Vocabulary& words);

}
