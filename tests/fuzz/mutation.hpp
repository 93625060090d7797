#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast::test {

using Bytes = std::vector<std::byte>;

/// One of the seeds, of which there is at least one, with 1 to 6 changes behind its first `from` bytes;
/// always the same of the same seeds and number. Each of them is longer than `from`. Most changes touch a
/// byte or two, as what is well-formed all around leads further in.
Bytes changed(std::span<const Bytes> seeds, std::uint32_t number, std::size_t from = 0);

/// Compiled scenes are changed behind their checksum, and sealed.
Bytes changed_and_sealed(std::span<const Bytes> seeds, std::uint32_t number);

}
