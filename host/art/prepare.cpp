#include "host/art/prepare.hpp"

namespace kfast::art {

void scale(Document&, double) {}
void crop(Document&) {}
void simplify(Document&, double) {}

}
