#include "tests/fuzz/mutation.hpp"

#include "tests/fuzz/sealed.hpp"

#include <algorithm>
#include <array>
#include <random>

namespace kfast::test {
namespace {

/// std::mt19937 gives the same numbers everywhere.
class Mutation {
public:
    Mutation(std::span<const Bytes> seeds, std::uint32_t number, std::size_t from)
        : seeds_{seeds}, from_{from}, random_{number}, bytes_{seeds[below(seeds.size())]}
    {
    }

    void change()
    {
        constexpr std::array changes{&Mutation::set_byte,    &Mutation::flip_bit,
                                     &Mutation::set_extreme, &Mutation::count_one,
                                     &Mutation::splice,      &Mutation::insert_or_erase,
                                     &Mutation::swap_bytes,  &Mutation::repeat_stretch};
        (this->*changes[below(changes.size())])();
    }
    std::size_t below(std::size_t limit) { return random_() % limit; }
    const Bytes& bytes() const { return bytes_; }

private:
    std::size_t place() { return from_ + below(bytes_.size() - from_); }
    std::byte& any_byte() { return bytes_[place()]; }
    std::byte random_byte() { return static_cast<std::byte>(random_() & 255); }

    void set_byte() { any_byte() = random_byte(); }
    void flip_bit() { any_byte() ^= static_cast<std::byte>(1 << below(8)); }
    void set_extreme()
    {
        constexpr std::array extremes{std::byte{0xFF}, std::byte{0x7F}, std::byte{0x80}, std::byte{0}};
        any_byte() = extremes[below(extremes.size())];
    }
    void count_one()
    {
        std::byte& byte = any_byte();
        byte = static_cast<std::byte>(std::to_integer<int>(byte) + (below(2) == 0 ? 1 : -1));
    }
    /// Puts some bytes of another seed over those here.
    void splice()
    {
        const Bytes& other = seeds_[below(seeds_.size())];
        const std::size_t to = place();
        const std::size_t count = std::min({1 + below(24), bytes_.size() - to, other.size() - from_});
        const std::size_t from = from_ + below(other.size() - from_ - count + 1);
        std::copy_n(other.begin() + static_cast<std::ptrdiff_t>(from), count,
                    bytes_.begin() + static_cast<std::ptrdiff_t>(to));
    }
    void insert_or_erase()
    {
        const auto at = bytes_.begin() + static_cast<std::ptrdiff_t>(place());
        if (below(2) == 0)
            bytes_.insert(at, random_byte());
        else if (bytes_.size() > from_ + 1)
            bytes_.erase(at);
    }
    void swap_bytes() { std::swap(any_byte(), any_byte()); }
    /// Puts a stretch of these bytes over another one.
    void repeat_stretch()
    {
        const std::size_t from = place();
        const std::size_t to = place();
        const std::size_t count = std::min(1 + below(12), bytes_.size() - std::max(from, to));
        const Bytes stretch(bytes_.begin() + static_cast<std::ptrdiff_t>(from),
                            bytes_.begin() + static_cast<std::ptrdiff_t>(from + count));
        std::ranges::copy(stretch, bytes_.begin() + static_cast<std::ptrdiff_t>(to));
    }

    std::span<const Bytes> seeds_;
    std::size_t from_;
    std::mt19937 random_;
    Bytes bytes_;
};

}

Bytes changed(std::span<const Bytes> seeds, std::uint32_t number, std::size_t from)
{
    Mutation mutation{seeds, number, from};
    for (std::size_t left = 1 + mutation.below(1 + mutation.below(6)); left > 0; --left)
        mutation.change();
    return mutation.bytes();
}

Bytes changed_and_sealed(std::span<const Bytes> seeds, std::uint32_t number)
{
    return sealed(changed(seeds, number, sealed_from));
}

}
