#include "host/scene_text/arrange.hpp"

namespace kfast::scene_text {

void arrange(art::Document&, double, art::Losses&) {}

}
