#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kfast::archive {

/// Whether the bytes begin as a gzip file (RFC 1952) does.
bool is_gzip(std::string_view bytes);

/// What a gzip file holds. Throws Failure, which names the file, when it is damaged, breaks off, or holds
/// more than `max_bytes`; never uses much more memory than that.
std::string gunzipped(const std::string& name, std::string_view bytes, std::size_t max_bytes);

}
