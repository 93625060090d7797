#include "core/time/law_pair.hpp"

namespace kfast {
namespace {

constexpr std::uint32_t as_for_x = 15;

VelocityLaw read_law(VelocityLaw::Kind kind, ByteReader& bytes)
{
    VelocityLaw law{.kind = kind};
    const auto control = [&bytes] { return static_cast<std::int16_t>(bytes.u16()); };
    if (kind == VelocityLaw::Kind::steps)
        law.steps = static_cast<std::uint16_t>(bytes.u16());
    if (kind == VelocityLaw::Kind::bezier)
        for (std::int16_t VelocityLaw::*number :
             {&VelocityLaw::x1, &VelocityLaw::y1, &VelocityLaw::x2, &VelocityLaw::y2})
            law.*number = control();
    return law;
}

}

LawPair read_law_pair(ByteReader& bytes)
{
    const std::uint32_t kinds = bytes.u8();
    const VelocityLaw x = read_law(static_cast<VelocityLaw::Kind>(kinds & 15), bytes);
    if (kinds >> 4 == as_for_x)
        return {x, x};
    const VelocityLaw y = read_law(static_cast<VelocityLaw::Kind>(kinds >> 4), bytes);
    return {x, y};
}

}
