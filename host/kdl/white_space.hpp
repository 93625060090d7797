#pragma once

#include "host/kdl/scanner.hpp"

namespace kfast::kdl {

/// Goes over white space within a node: spaces, /* comments */ and line continuations.
void skip_node_space(Scanner& scanner);

/// Goes over white space between nodes: the above, new lines and // comments.
void skip_line_space(Scanner& scanner);

/// Goes over spaces alone.
void skip_spaces(Scanner& scanner);

}
