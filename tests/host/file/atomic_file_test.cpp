#include "host/file/atomic_file.hpp"

#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;

std::span<const std::byte> as_bytes(std::string_view text) { return std::as_bytes(std::span{text}); }

/// The message of the Failure that writing `text` to `path` throws; empty when it throws none.
std::string failure(const fs::path& path, std::string_view text)
{
    try {
        write_file(path, as_bytes(text));
    } catch (const Failure& caught) {
        return caught.what();
    }
    return {};
}

/// How a child process ends that runs `act`.
template <class Act>
int status_of_child(Act act)
{
    const pid_t child = ::fork();
    if (child == 0) {
        act();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

}

TEST_CASE("a file appears with its whole content and nothing beside it")
{
    const TemporaryFolder folder;
    write_file(folder / "a", as_bytes("whole"));
    CHECK(content(folder / "a") == "whole");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a file has the permissions of the one that it replaces")
{
    const TemporaryFolder folder;
    write_file(folder / "a", as_bytes("before"));
    for (const fs::perms permissions : {fs::perms{0600}, fs::perms{0640}, fs::perms{0755}}) {
        fs::permissions(folder / "a", permissions);
        write_file(folder / "a", as_bytes("after"));
        CHECK(fs::status(folder / "a").permissions() == permissions);
    }
}

TEST_CASE("until commit there is no file, and an earlier one stays")
{
    const TemporaryFolder folder;
    write_file(folder / "old", as_bytes("before"));
    {
        AtomicFile fresh{folder / "new"};
        fresh.write(as_bytes("half"));
        CHECK_FALSE(fs::exists(folder / "new"));
    }
    {
        AtomicFile again{folder / "old"};
        again.write(as_bytes("half"));
    }
    CHECK(content(folder / "old") == "before");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a file that cannot be written is named with the remedy")
{
    const TemporaryFolder folder;
    CHECK(failure(folder / "no/a", "x").find("create the folder first") != std::string::npos);
    CHECK(failure(folder / ".", "x").find("name a file, not a folder") != std::string::npos);
    CHECK(failure("/dev/full", "x").find("/dev/full: No space left on device: make room") !=
          std::string::npos);
    CHECK(folder.entries() == 0);
}

TEST_CASE("a full disk leaves no partial file")
{
    const TemporaryFolder folder;
    write_file(folder / "a", as_bytes("before"));
    const int status = status_of_child([&folder] {
        const rlimit limit{100, 100};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::_exit(failure(folder / "a", std::string(1000, 'x')).empty() ? 1 : 0);
    });
    CHECK(status == 0);
    CHECK(content(folder / "a") == "before");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a signal removes the temporary and still ends the program")
{
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        const TemporaryFolder folder;
        const int status = status_of_child([&folder, number] {
            AtomicFile file{folder / "a"};
            file.write(as_bytes("half"));
            ::raise(number);
        });
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == number);
        CHECK(folder.entries() == 0);
    }
}

TEST_CASE("a signal removes the temporaries of all files that are not committed")
{
    const TemporaryFolder folder;
    const int status = status_of_child([&folder] {
        AtomicFile first{folder / "a"};
        AtomicFile second{folder / "b"};
        AtomicFile third{folder / "c"};
        second.commit();
        ::raise(SIGTERM);
    });
    CHECK(WIFSIGNALED(status));
    CHECK(fs::exists(folder / "b"));
    CHECK(folder.entries() == 1);
}

TEST_CASE("once the last file is committed a signal ends the program as ever")
{
    const TemporaryFolder folder;
    AtomicFile first{folder / "a"};
    AtomicFile{folder / "b"}.commit();
    struct sigaction current = {};
    ::sigaction(SIGTERM, nullptr, &current);
    CHECK((current.sa_handler != SIG_DFL));
    first.commit();
    ::sigaction(SIGTERM, nullptr, &current);
    CHECK((current.sa_handler == SIG_DFL));
}

TEST_CASE("four files at once are the most, and one that is committed makes room")
{
    const TemporaryFolder folder;
    std::array<AtomicFile, 3> files{AtomicFile{folder / "a"}, AtomicFile{folder / "b"},
                                    AtomicFile{folder / "c"}};
    AtomicFile{folder / "d"}.commit();
    const AtomicFile fourth{folder / "e"};
    CHECK_THROWS_AS(AtomicFile{folder / "f"}, std::logic_error);
    files.front().finish();
    files.front().commit();
    CHECK_NOTHROW(AtomicFile{folder / "f"});
}

TEST_CASE("a link stays a link, what it points to is replaced")
{
    const TemporaryFolder folder;
    write_file(folder / "real", as_bytes("before"));
    fs::create_symlink(folder / "real", folder / "link");
    write_file(folder / "link", as_bytes("after"));
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(content(folder / "real") == "after");
}

TEST_CASE("what is no regular file is written straight to and stays what it is")
{
    CHECK(failure("/dev/null", "x").empty());
    CHECK(fs::is_character_file("/dev/null"));
}

}
