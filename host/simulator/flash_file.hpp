#pragma once

#include "firmware/slots/flash.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace kfast {

/// The NOR flash of a simulated board, kept in a file: what it holds outlives the program. Offsets beyond its
/// size, or within sectors and pages, are refused as an error of the firmware (std::logic_error).
class FlashFile {
public:
    /// Makes the file, erased, if there is none. Throws Failure if it cannot be used, has another size, or
    /// another program uses it now.
    FlashFile(const std::filesystem::path& path, std::size_t size);
    ~FlashFile();
    FlashFile(const FlashFile&) = delete;
    FlashFile& operator=(const FlashFile&) = delete;

    void erase(std::uint32_t offset);
    void program(std::uint32_t offset, std::span<const std::byte, page_bytes> page);
    std::span<const std::byte> contents() const { return bytes_; }

private:
    std::span<std::byte> place(std::uint32_t offset, std::uint32_t size) const;

    int file_;
    std::span<std::byte> bytes_; ///< the file in memory
};

}
