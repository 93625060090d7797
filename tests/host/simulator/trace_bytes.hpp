#pragma once

#include "host/simulator/trace.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace kfast::test {

/// A trace, made record by record.
class TraceBytes {
public:
    TraceBytes() { add_text("KFTRACE1"); }

    TraceBytes& add(TraceKind kind, std::uint64_t microseconds, std::vector<std::byte> content = {})
    {
        return add(static_cast<unsigned>(kind), 1000 * microseconds, content.size(), content);
    }
    TraceBytes& note(std::uint64_t microseconds, std::string_view text)
    {
        const auto letters = std::as_bytes(std::span{text});
        return add(TraceKind::note, microseconds, {letters.begin(), letters.end()});
    }
    /// Any record, right or wrong.
    TraceBytes& add(unsigned kind, std::uint64_t nanoseconds, std::uint64_t count,
                    const std::vector<std::byte>& content)
    {
        add_number(kind, 1);
        add_number(nanoseconds, 8);
        add_number(count, 4);
        bytes.insert(bytes.end(), content.begin(), content.end());
        return *this;
    }

    std::vector<std::byte> bytes;

private:
    void add_text(std::string_view text)
    {
        const auto letters = std::as_bytes(std::span{text});
        bytes.insert(bytes.end(), letters.begin(), letters.end());
    }
    void add_number(std::uint64_t number, int count)
    {
        for (; count > 0; --count, number >>= 8)
            bytes.push_back(static_cast<std::byte>(number & 255));
    }
};

}
