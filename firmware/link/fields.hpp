#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/math/point.hpp"
#include "core/pose/input_drawing.hpp"
#include "core/time/time.hpp"
#include "firmware/chip/span_writer.hpp"
#include "firmware/chip/stored_text.hpp"
#include "firmware/link/checksum.hpp"
#include "firmware/link/message_kind.hpp"
#include "firmware/report.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

namespace kfast::link {

/// Writes the fields of a message one after another.
class FieldWriter {
public:
    constexpr explicit FieldWriter(std::span<std::byte> bytes) : to_{bytes} {}

    template <class... Fields>
    constexpr void operator()(const Fields&... fields)
    {
        (write(fields), ...);
    }

private:
    constexpr void write(bool value) { to_.u8(value ? 1 : 0); }
    constexpr void write(std::byte value) { to_.u8(std::to_integer<std::uint32_t>(value)); }
    constexpr void write(char value) { to_.u8(static_cast<std::uint8_t>(value)); }
    constexpr void write(std::uint8_t value) { to_.u8(value); }
    constexpr void write(std::uint16_t value) { to_.u16(value); }
    constexpr void write(std::uint32_t value) { to_.u32(value); }
    constexpr void write(std::int32_t value) { to_.u32(static_cast<std::uint32_t>(value)); }
    constexpr void write(Time time) { write(time.ticks); }
    constexpr void write(InputPoint point)
    {
        to_.u16(static_cast<std::uint16_t>(point.x));
        to_.u16(static_cast<std::uint16_t>(point.y));
    }
    constexpr void write(Size size)
    {
        to_.u16(static_cast<std::uint32_t>(size.width));
        to_.u16(static_cast<std::uint32_t>(size.height));
    }
    template <std::size_t max>
    constexpr void write(const StoredText<max>& text)
    {
        write(text.bytes);
    }
    template <class T, std::size_t count>
    constexpr void write(const std::array<T, count>& all)
    {
        for (const T& each : all)
            write(each);
    }
    template <class T>
    constexpr void write(const T& value)
    {
        if constexpr (std::is_enum_v<T>)
            to_.u8(static_cast<std::uint32_t>(value));
        else
            T::fields(*this, value);
    }

    SpanWriter to_;
};

/// Reads the fields of a message one after another and remembers whether each of them was valid.
class FieldReader {
public:
    explicit FieldReader(std::span<const std::byte> bytes) : from_{bytes} {}

    bool is_valid() const { return is_valid_; }

    template <class... Fields>
    void operator()(Fields&... fields)
    {
        (read(fields), ...);
    }

private:
    void read(bool& value)
    {
        const std::uint32_t code = from_.u8();
        is_valid_ = is_valid_ && code <= 1;
        value = code != 0;
    }
    void read(std::byte& value) { value = static_cast<std::byte>(from_.u8()); }
    void read(std::uint8_t& value) { value = static_cast<std::uint8_t>(from_.u8()); }
    void read(std::uint16_t& value) { value = static_cast<std::uint16_t>(from_.u16()); }
    void read(std::uint32_t& value) { value = from_.u32(); }
    void read(std::int32_t& value) { value = static_cast<std::int32_t>(from_.u32()); }
    void read(Time& time) { read(time.ticks); }
    void read(InputPoint& point)
    {
        point.x = static_cast<std::int16_t>(from_.u16());
        point.y = static_cast<std::int16_t>(from_.u16());
    }
    void read(Size& size)
    {
        size.width = static_cast<int>(from_.u16());
        size.height = static_cast<int>(from_.u16());
    }
    /// What follows a 0 is no part of the text.
    template <std::size_t max>
    void read(StoredText<max>& text)
    {
        bool is_over = false;
        for (char& letter : text.bytes) {
            const auto byte = static_cast<char>(from_.u8());
            is_over = is_over || byte == '\0';
            letter = is_over ? '\0' : byte;
        }
    }
    template <class T, std::size_t count>
    void read(std::array<T, count>& all)
    {
        for (T& each : all)
            read(each);
    }
    template <class T>
    void read(T& value)
    {
        if constexpr (std::is_enum_v<T>) {
            value = static_cast<T>(from_.u8());
            is_valid_ = is_valid_ && is_known(value);
        } else {
            T::fields(*this, value);
        }
    }

    ByteReader from_;
    bool is_valid_ = true;
};

/// What a device sends.
template <class M>
concept Answer = requires
{
    requires M::answers;
};

/// Byte 0 of a report with this message.
template <class M>
constexpr std::uint8_t code_of()
{
    return static_cast<std::uint8_t>(static_cast<std::uint8_t>(M::kind) | (Answer<M> ? from_device : 0));
}

/// Does not compile unless the fields find room in a report.
template <class M>
consteval bool fits()
{
    std::array<std::byte, payload_bytes - (has_checksum(M::kind) ? checksum_bytes : 0)> room{};
    const M message;
    M::fields(FieldWriter{room}, message);
    return true;
}

/// The message as a report; what it does not fill is 0.
template <class M>
Report report_of(const M& message, std::uint8_t tag)
{
    static_assert(fits<M>());
    Report report;
    report.bytes[0] = static_cast<std::byte>(code_of<M>());
    report.bytes[1] = static_cast<std::byte>(tag);
    M::fields(FieldWriter{report.payload()}, message);
    return report;
}

/// The message of a report; nothing if it is of another kind, or if a field is not valid.
template <class M>
std::optional<M> message_of(const Report& report)
{
    if (report.kind() != code_of<M>())
        return std::nullopt;
    M message;
    FieldReader reader{report.payload()};
    M::fields(reader, message);
    return reader.is_valid() ? std::optional{message} : std::nullopt;
}

}
