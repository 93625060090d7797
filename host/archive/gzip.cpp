#include "host/archive/gzip.hpp"

#include "host/program/failure.hpp"

#include <array>
#include <zlib.h>

namespace kfast::archive {
namespace {

using namespace std::string_view_literals;

/// Of zlib: its usual window, and the wrapping of gzip.
constexpr int gzip_window = MAX_WBITS + 16;

class Inflation {
public:
    Inflation(const std::string& name, std::string_view bytes) : name_{name}
    {
        // zlib only reads there, whatever its type says.
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream_.avail_in = static_cast<uInt>(bytes.size());
        if (inflateInit2(&stream_, gzip_window) != Z_OK)
            throw Failure(name_ + ": there is no memory to unpack it");
    }
    ~Inflation() { inflateEnd(&stream_); }
    Inflation(const Inflation&) = delete;
    Inflation& operator=(const Inflation&) = delete;

    /// Of all members, one behind the other.
    std::string content(std::size_t max_bytes)
    {
        std::string all;
        do
            add_member(all, max_bytes);
        while (goes_on());
        return all;
    }

private:
    void add_member(std::string& all, std::size_t max_bytes)
    {
        for (int status = Z_OK; status != Z_STREAM_END;) {
            stream_.next_out = reinterpret_cast<Bytef*>(block_.data());
            stream_.avail_out = static_cast<uInt>(block_.size());
            status = inflate(&stream_, Z_NO_FLUSH);
            if (status == Z_BUF_ERROR)
                throw Failure(name_ + ": breaks off before its end: copy it again");
            if (status != Z_OK && status != Z_STREAM_END)
                throw Failure(name_ + ": the packed file is damaged: copy it again");
            all.append(block_.data(), block_.size() - stream_.avail_out);
            if (all.size() > max_bytes)
                throw Failure(name_ + ": holds more than " + std::to_string(max_bytes >> 20) +
                              " MB: is it the right file?");
        }
    }

    /// What is no gzip behind a member is padding.
    bool goes_on()
    {
        const std::string_view rest{reinterpret_cast<const char*>(stream_.next_in), stream_.avail_in};
        return is_gzip(rest) && inflateReset(&stream_) == Z_OK;
    }

    const std::string& name_;
    z_stream stream_{};
    std::array<char, 65536> block_{}; ///< of all members: there may be a million empty ones
};

}

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"sv); }

std::string gunzipped(const std::string& name, std::string_view bytes, std::size_t max_bytes)
{
    return Inflation{name, bytes}.content(max_bytes);
}

}
