#pragma once

#include <pugixml.hpp>

namespace kfast::svg {

/// Gives elements of SVG their names without a prefix, and all others a name with one. SVG is also what an
/// outermost element without a prefix is of.
void resolve_namespaces(pugi::xml_document& document);

}
