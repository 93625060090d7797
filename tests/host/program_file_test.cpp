#include "host/program_file.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a program is the file that the system runs")
{
    CHECK(program_file("/usr/bin/kfast", "kfast") == "/usr/bin/kfast");
    CHECK(program_file("/home/somebody/ld/kfast", "/usr/bin/other") == "/home/somebody/ld/kfast");
    CHECK(program_file(std::nullopt, "/usr/bin/kfast") == "/usr/bin/kfast");
    CHECK_FALSE(program_file(std::nullopt, "kfast").has_value());
    CHECK(program_file()->filename() == "file_test");
    CHECK_FALSE(has_own_libraries());
}

TEST_CASE("behind a loader it is the file by which the loader was started")
{
    CHECK(program_file("/opt/kfast/lib/kfast/ld.so", "/opt/kfast/bin/kfast") == "/opt/kfast/bin/kfast");
    CHECK(program_file("/lib64/ld-linux-x86-64.so.2", "/opt/kfast/bin/kfast") == "/opt/kfast/bin/kfast");
    CHECK_FALSE(program_file("/opt/kfast/lib/kfast/ld.so", "kfast").has_value());
}

}
