#include "tests/host/flash/uf2_rom.hpp"

#include "core/bytes/byte_reader.hpp"

namespace kfast::test {

void Uf2Rom::take(std::span<const std::byte> block)
{
    ByteReader reader{block};
    ByteReader end{block.last(4)};
    if (reader.u32() != 0x0A32'4655 || reader.u32() != 0x9E5D'5157 || end.u32() != 0x0AB1'6F30)
        return;
    const std::uint32_t flags = reader.u32();
    const std::uint32_t address = reader.u32();
    const std::uint32_t payload = reader.u32();
    const std::uint32_t number = reader.u32();
    const std::uint32_t count = reader.u32();
    if ((flags & 0x2001) != 0x2000 || reader.u32() != 0xE48B'FF56 || payload != 256)
        return;
    const bool is_flash = address >= 0x1000'0000 && address + 255 <= 0x2000'0000;
    if (count == 0 || !is_flash || address % 256 != 0 || number >= count) {
        count_ = 0;
        return;
    }
    if (count != count_) {
        count_ = count;
        numbers_.clear();
        erased_for_.clear();
    }
    if (!numbers_.insert(number).second)
        return;
    if (erased_for_.insert(number * 256 / 4096).second)
        flash_.erase_sector(address / 4096 * 4096);
    flash_.program_page(address, reader.rest());
    has_restarted = has_restarted || numbers_.size() == count;
}

}
