#include "host/compiler/pack/law_table.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::uint32_t as_for_x = 15;

void write_parameters(const VelocityLaw& law, ByteWriter& bytes)
{
    if (law.kind == VelocityLaw::Kind::steps)
        bytes.u16(law.steps);
    if (law.kind == VelocityLaw::Kind::bezier)
        for (const std::int16_t number : {law.x1, law.y1, law.x2, law.y2})
            bytes.u16(static_cast<std::uint16_t>(number));
}

}

std::uint32_t LawTable::number_of(const LawPair& laws, SourceSpan place)
{
    if (laws == LawPair{})
        return 0;
    const auto known = std::ranges::find(pairs_, laws);
    const auto number = static_cast<std::uint32_t>(known - pairs_.begin()) + 1;
    if (known != pairs_.end())
        return number;
    if (number > kfb::max_law_pairs) {
        first_beyond_ = first_beyond_.value_or(place);
        return 0;
    }
    pairs_.push_back(laws);
    return number;
}

std::vector<std::byte> LawTable::bytes() const
{
    ByteWriter bytes;
    for (const LawPair& pair : pairs_) {
        const bool is_alike = pair.x == pair.y;
        bytes.u8(static_cast<std::uint32_t>(pair.x.kind) |
                 (is_alike ? as_for_x : static_cast<std::uint32_t>(pair.y.kind)) << 4);
        write_parameters(pair.x, bytes);
        if (!is_alike)
            write_parameters(pair.y, bytes);
    }
    return bytes.bytes();
}

}
