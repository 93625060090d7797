#include "tests/fuzz/imported.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::string content(data, data + size);
    if (kfast::importing::kind_of(content) == kfast::importing::ContentKind::json)
        kfast::test::check_import(std::move(content));
    return 0;
}
