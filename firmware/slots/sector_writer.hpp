#pragma once

#include "core/bytes/expects.hpp"
#include "firmware/slots/flash.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Writes a stream of bytes into flash, sector by sector. A sector that begins with the wanted bytes
/// is left as it is.
template <Flash F>
class SectorWriter {
public:
    /// What the stream is for.
    enum class Use : std::uint8_t {
        write,
        compare, ///< nothing is changed, and is_same() returns whether flash holds the stream
    };

    explicit SectorWriter(F& flash) : flash_{flash} {}

    /// From now on bytes go to `offset`, the beginning of a sector.
    void begin(std::uint32_t offset, Use use)
    {
        expects(offset % sector_bytes == 0);
        offset_ = offset;
        use_ = use;
        filled_ = 0;
        is_same_ = true;
    }

    /// The bytes must be within the flash.
    void add(std::span<const std::byte> bytes)
    {
        while (!bytes.empty()) {
            const std::size_t part = std::min<std::size_t>(bytes.size(), sector_bytes - filled_);
            std::ranges::copy(bytes.first(part), sector_.begin() + filled_);
            filled_ += static_cast<std::uint32_t>(part);
            bytes = bytes.subspan(part);
            if (filled_ == sector_bytes)
                flush();
        }
    }

    /// Writes the rest of the stream into flash.
    void flush()
    {
        const auto wanted = std::span{sector_}.first(filled_);
        if (!std::ranges::equal(wanted, flash_.contents().subspan(offset_, filled_))) {
            is_same_ = false;
            if (!compares())
                write_sector();
        }
        offset_ += filled_;
        filled_ = 0;
    }

    bool compares() const { return use_ == Use::compare; }
    /// Whether all that was flushed was in flash before.
    bool is_same() const { return is_same_; }

private:
    /// After the stream flash stays erased.
    void write_sector()
    {
        std::fill(sector_.begin() + filled_, sector_.end(), std::byte{0xFF});
        flash_.erase(offset_);
        for (std::uint32_t at = 0; at < filled_; at += page_bytes)
            flash_.program(offset_ + at, std::span{sector_}.subspan(at).template first<page_bytes>());
    }

    F& flash_;
    std::array<std::byte, sector_bytes> sector_{};
    std::uint32_t filled_ = 0;
    std::uint32_t offset_ = 0;
    Use use_ = Use::write;
    bool is_same_ = true;
};

}
