#include "host/file/input_file.hpp"

#include "host/file/program_file.hpp"
#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;

std::string failure(const fs::path& path, const InputKind& kind = scene_input)
{
    try {
        read_input(path, kind);
    } catch (const Failure& caught) {
        return caught.what();
    }
    return {};
}

void create(const fs::path& path, std::uintmax_t size)
{
    const std::ofstream empty{path};
    fs::resize_file(path, size);
}

}

TEST_CASE("a file is read whole up to the limit of 16 MB")
{
    const TemporaryFolder folder;
    create(folder / "largest", input_limit);
    CHECK(read_input(folder / "largest", scene_input).size() == input_limit);
    create(folder / "larger", input_limit + 1);
    CHECK(failure(folder / "larger").find("larger than 16 MB") != std::string::npos);
}

TEST_CASE("what cannot be read is named with the remedy")
{
    const TemporaryFolder folder;
    create(folder / "empty", 0);
    CHECK(failure(folder / "empty").find("the file is empty") != std::string::npos);
    CHECK(failure(folder / "none").find("there is no such file") != std::string::npos);
    CHECK(failure(folder / "empty/x").find("there is no such file") != std::string::npos);
    CHECK(failure(folder / ".").find("this is a folder") != std::string::npos);
    CHECK(failure("") == "the name of the file is empty: name " + std::string{scene_files});
}

TEST_CASE("the remedy fits what the file is to be")
{
    const TemporaryFolder folder;
    create(folder / "empty", 0);
    create(folder / "larger", input_limit + 1);
    CHECK(failure(folder / ".").ends_with("this is a folder: name " + std::string{scene_files} + " in it"));
    CHECK(failure(folder / ".", font_input).ends_with("this is a folder: name a .ttf or .otf file in it"));
    CHECK(failure(folder / "empty", font_input).ends_with("the file is empty: copy it again"));
    CHECK(failure(folder / "larger", font_input).find("more than any font needs") != std::string::npos);
}

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
