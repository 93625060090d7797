#include "firmware/slots/slot_directory.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/crc32.hpp"
#include "firmware/chip/span_writer.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::array<std::byte, 4> magic{std::byte{'K'}, std::byte{'F'}, std::byte{'S'}, std::byte{'D'}};
constexpr std::uint32_t directory_version = 2;
/// Its copies know of no bad sectors.
constexpr std::uint32_t first_version = 1;

void write_entry(const SlotEntry& entry, SpanWriter& writer)
{
    writer.bytes(std::as_bytes(std::span{entry.name.bytes}));
    for (const std::uint32_t number : {entry.offset, entry.size, entry.crc})
        writer.u32(number);
}

SlotEntry read_entry(ByteReader& reader)
{
    SlotEntry entry;
    for (char& letter : entry.name.bytes)
        letter = static_cast<char>(reader.u8());
    for (std::uint32_t* number : {&entry.offset, &entry.size, &entry.crc})
        *number = reader.u32();
    return entry.is_empty() ? SlotEntry{} : entry; // that of nothing may be anywhere
}

SlotDirectory read_fields(ByteReader reader, std::uint32_t version)
{
    SlotDirectory directory;
    directory.generation = reader.u32();
    directory.next = reader.u32();
    directory.chosen = static_cast<std::uint8_t>(reader.u8());
    directory.bad_copies = static_cast<std::uint8_t>(reader.u8());
    reader.skip(2);
    for (SlotEntry& entry : directory.slots)
        entry = read_entry(reader);
    if (version != first_version)
        std::ranges::copy(reader.rest().first(directory.bad_sectors.bits.size()),
                          directory.bad_sectors.bits.begin());
    return directory;
}

constexpr std::size_t bytes_of_version(std::uint32_t version)
{
    return version == first_version ? slot_directory_bytes - sizeof(SectorSet::bits) : slot_directory_bytes;
}

bool has_right_checksum(std::span<const std::byte> record)
{
    ByteReader end{record.last(4)};
    Crc32 crc;
    crc.add(record.first(record.size() - 4));
    return end.u32() == crc.value();
}

bool lies_within(const SlotEntry& entry, std::uint32_t pool_bytes)
{
    return entry.is_empty() || (entry.offset % sector_bytes == 0 && entry.offset < pool_bytes &&
                                entry.size <= pool_bytes - entry.offset);
}

bool lies_within(const SlotDirectory& directory, std::uint32_t pool_bytes)
{
    return directory.next <= pool_bytes && directory.next % sector_bytes == 0 &&
           (directory.chosen < SlotDirectory::slot_count || directory.chosen == SlotDirectory::none) &&
           std::ranges::all_of(directory.slots,
                               [=](const SlotEntry& entry) { return lies_within(entry, pool_bytes); });
}

}

SlotDirectoryPages slot_directory_pages_of(const SlotDirectory& directory)
{
    SlotDirectoryPages pages;
    pages.fill(std::byte{0xFF});
    SpanWriter writer{pages};
    writer.bytes(magic);
    writer.u16(directory_version);
    writer.u16(SlotDirectory::slot_count);
    writer.u32(directory.generation);
    writer.u32(directory.next);
    writer.u8(directory.chosen);
    writer.u8(directory.bad_copies);
    writer.u16(0);
    for (const SlotEntry& entry : directory.slots)
        write_entry(entry, writer);
    writer.bytes(directory.bad_sectors.bits);
    Crc32 crc;
    crc.add(std::span{pages}.first(slot_directory_bytes - 4));
    writer.u32(crc.value());
    return pages;
}

std::optional<SlotDirectory> read_slot_directory(std::span<const std::byte> bytes, std::uint32_t pool_bytes)
{
    if (bytes.size() < slot_directory_bytes || !std::ranges::equal(bytes.first(magic.size()), magic))
        return std::nullopt;
    ByteReader reader{bytes.subspan(magic.size())};
    const std::uint32_t version = reader.u16();
    if ((version != directory_version && version != first_version) ||
        reader.u16() != SlotDirectory::slot_count ||
        !has_right_checksum(bytes.first(bytes_of_version(version))))
        return std::nullopt;
    const SlotDirectory directory = read_fields(reader, version);
    return lies_within(directory, pool_bytes) ? std::optional{directory} : std::nullopt;
}

}
