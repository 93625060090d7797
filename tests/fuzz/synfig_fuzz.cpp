#include "tests/fuzz/imported.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    kfast::test::check_xml(data, size, "canvas");
    return 0;
}
