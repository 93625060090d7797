#include "host/art/prepare.hpp"

namespace kfast::art {

void simplify(Document&, double) {}

}
