#include "host/words/law_text.hpp"

#include "host/text/rounded_text.hpp"

namespace kfast {
namespace {

std::string control_text(std::int16_t control)
{
    return rounded_text(static_cast<double>(control) / VelocityLaw::control_one);
}

}

std::string law_text(const VelocityLaw& law)
{
    switch (law.kind) {
    case VelocityLaw::Kind::constant:
        return "constant";
    case VelocityLaw::Kind::accelerate:
        return "accelerate";
    case VelocityLaw::Kind::decelerate:
        return "decelerate";
    case VelocityLaw::Kind::accelerate_decelerate:
        return "accelerate-decelerate";
    case VelocityLaw::Kind::hold:
        return "hold";
    case VelocityLaw::Kind::steps:
        return "steps(" + std::to_string(law.steps) + ')';
    case VelocityLaw::Kind::bezier:
        return "bezier(" + control_text(law.x1) + ',' + control_text(law.y1) + ',' + control_text(law.x2) +
               ',' + control_text(law.y2) + ')';
    }
    return "";
}

}
