#include "tests/fuzz/imported.hpp"

/// Unpacks, reads manifests, and imports what is inside.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::string content(data, data + size);
    const auto kind = kfast::importing::kind_of(content);
    if (kind == kfast::importing::ContentKind::zip || kind == kfast::importing::ContentKind::gzip)
        kfast::test::check_import(std::move(content));
    return 0;
}
