#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace kfast::test {

/// Memory that nobody has written to, as a board lends it; sanitizers know where it ends.
class Memory {
public:
    explicit Memory(std::size_t size) : bytes_{std::make_unique_for_overwrite<std::byte[]>(size)}, size_{size}
    {
    }
    std::span<std::byte> bytes() const { return {bytes_.get(), size_}; }

private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_;
};

}
