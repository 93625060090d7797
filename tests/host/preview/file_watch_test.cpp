#include "host/preview/files/file_watch.hpp"

#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sys/stat.h>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;

using Seconds = FileWatch::Seconds;

void write(const fs::path& file, const char* text) { std::ofstream{file} << text; }

/// How often it tells of a change within so many seconds.
int changes(FileWatch& watch, double from, double to)
{
    int count = 0;
    for (double now = from; now < to; now += 0.05)
        count += watch.has_changed(Seconds{now}) ? 1 : 0;
    return count;
}

}

TEST_CASE("a file that is written or replaced has changed, once")
{
    const TemporaryFolder folder;
    const fs::path file = folder / "a";
    write(file, "one");
    FileWatch watch{{file}};
    CHECK(changes(watch, 0, 2) == 0);
    write(file, "other");
    CHECK(changes(watch, 2, 4) == 1);
    write(folder / "b", "third");
    fs::last_write_time(folder / "b", fs::last_write_time(file));
    fs::rename(folder / "b", file);
    CHECK(changes(watch, 4, 6) == 1);
    CHECK(changes(watch, 6, 8) == 0);
}

TEST_CASE("a change is told only once nobody writes any more")
{
    const TemporaryFolder folder;
    const fs::path file = folder / "a";
    write(file, "");
    FileWatch watch{{file}};
    std::string text;
    for (int i = 0; i < 10; ++i) {
        text += "more ";
        write(file, text.c_str());
        CHECK(changes(watch, i * 0.2, i * 0.2 + 0.2) == 0);
    }
    CHECK(changes(watch, 2, 4) == 1);
}

TEST_CASE("a file that comes back soon was never gone")
{
    const TemporaryFolder folder;
    const fs::path file = folder / "a";
    write(file, "one");
    FileWatch watch{{file}};
    fs::rename(file, folder / "b");
    CHECK(changes(watch, 0, 1) == 0);
    fs::rename(folder / "b", file);
    CHECK(changes(watch, 1, 3) <= 1);
    fs::remove(file);
    CHECK(changes(watch, 3, 4) == 0);
    CHECK(changes(watch, 4, 8) == 1);
    write(file, "again");
    CHECK(changes(watch, 8, 10) == 1);
}

TEST_CASE("any of several files may change, pipes never do")
{
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    write(folder / "a", "a");
    write(folder / "b", "b");
    FileWatch watch{{folder / "a", folder / "b", pipe}};
    write(folder / "b", "bb");
    CHECK(changes(watch, 0, 2) == 1);
    fs::remove(pipe);
    CHECK(changes(watch, 2, 6) == 0);
}

}
