#include "host/compiler/pack/key_time_writer.hpp"

#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/pack/value_writer.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace kfast {

namespace {

void write_parameters(const VelocityLaw& law, ByteWriter& bytes)
{
    kfb::law_pair::each_parameter(
        law, [&bytes](auto parameter) { bytes.u16(static_cast<std::uint16_t>(parameter)); });
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
        const auto kind_for_y = static_cast<std::uint32_t>(pair.y.kind);
        bytes.u8(kfb::law_pair::x.put(pair.x.kind) |
                 kfb::law_pair::y.put(is_alike ? kfb::law_pair::as_for_x : kind_for_y));
        write_parameters(pair.x, bytes);
        if (!is_alike)
            write_parameters(pair.y, bytes);
    }
    return bytes.bytes();
}

namespace {

/// The time of each since the one before.
std::vector<std::uint32_t> steps_of(const KeyTimes& key_times)
{
    std::vector<std::uint32_t> steps;
    Time before;
    for (const WrittenKeyTime& key_time : key_times) {
        steps.push_back(static_cast<std::uint32_t>((key_time.time - before).ticks));
        before = key_time.time;
    }
    return steps;
}

std::uint32_t bits_for(std::uint32_t largest) { return static_cast<std::uint32_t>(std::bit_width(largest)); }

/// A single key time is the same by any driver.
Driver written_driver(const DrivenKeyTimes& key_times)
{
    return key_times.key_times.size() == 1 ? Driver{} : key_times.driver;
}

}

void write_key_times(const DrivenKeyTimes& driven, const DrivenKeyTimes& default_key_times, ByteWriter& bytes)
{
    const auto& key_times = driven.key_times;
    const Driver driver = written_driver(driven);
    if (key_times == default_key_times.key_times && driver == written_driver(default_key_times))
        return bytes.varint(kfb::key_times::use_default);
    const std::vector<std::uint32_t> steps = steps_of(key_times);
    const std::uint32_t all_bits = std::reduce(steps.begin(), steps.end(), 0U, std::bit_or{});
    constexpr auto max_shift = static_cast<int>(kfb::key_times::time_shift.max());
    const int shift = all_bits == 0 ? 0 : std::min(std::countr_zero(all_bits), max_shift);
    const std::uint32_t time_bits = bits_for(std::ranges::max(steps) >> shift);
    const std::uint32_t law_bits = bits_for(std::ranges::max(key_times, {}, &WrittenKeyTime::laws).laws);
    bytes.varint(static_cast<std::uint32_t>(key_times.size()));
    bytes.u16(kfb::key_times::time_width.put(time_bits) | kfb::key_times::time_shift.put(shift) |
              kfb::key_times::law_width.put(law_bits) | kfb::key_times::has_driver.put(!driver.is_time()));
    if (!driver.is_time())
        bytes.u8(driver.number);
    BitWriter bits{bytes};
    for (std::size_t i = 0; i < key_times.size(); ++i) {
        bits.number(steps[i] >> shift, time_bits);
        bits.number(key_times[i].laws, law_bits);
    }
}

}
