#include "host/scene_text/scene_text.hpp"

#include "host/failure.hpp"

namespace kfast::scene_text {

std::string scene_text(const art::Document&, std::string_view, double, art::Losses&)
{
    throw Failure("not written yet");
}

}
