#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct zip;

namespace kfast::archive {

/// Whether the bytes begin as a gzip file (RFC 1952) does.
bool is_gzip(std::string_view bytes);

/// Returns what a gzip file holds. Throws Failure, which names the file, when it is damaged, breaks off, or
/// holds more than `max_bytes`; never uses much more memory than that.
std::string gunzipped(const std::string& name, std::string_view bytes, std::size_t max_bytes);

/// Whether the bytes begin as a zip file does.
bool is_zip(std::string_view bytes);

/// Reads a zip file in memory. All members throw Failure, which names the file.
class ZipFile {
public:
    static constexpr std::size_t max_members = 4096;

    /// `bytes` must outlive it. Throws when they are no zip file, damaged, or hold more than `max_members`.
    ZipFile(std::string name, std::string_view bytes);

    /// Their paths, in the order of the file.
    const std::vector<std::string>& members() const { return members_; }
    bool has(std::string_view path) const;

    /// Throws if no member has that path, or if it is encrypted, compressed in an unknown way, damaged, or
    /// larger than `max_bytes`, whatever the file says of its size.
    std::string content(std::string_view path, std::size_t max_bytes) const;

private:
    struct Close {
        void operator()(zip* archive) const;
    };

    std::string name_;
    std::unique_ptr<zip, Close> archive_;
    std::vector<std::string> members_;
};

}
