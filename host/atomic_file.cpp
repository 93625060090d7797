#include "host/atomic_file.hpp"

#include "host/failure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <utility>

namespace kfast {
namespace {

namespace fs = std::filesystem;

// What a signal has to remove. A handler may touch nothing but plain memory, hence no std::string.
std::array<char, PATH_MAX> path_to_remove{};

constexpr std::array ending_signals{SIGHUP, SIGINT, SIGTERM};

extern "C" void remove_and_end(int number)
{
    ::unlink(path_to_remove.data());
    std::signal(number, SIG_DFL);
    std::raise(number);
}

bool is_ignored(int number)
{
    struct sigaction current = {};
    ::sigaction(number, nullptr, &current);
    return current.sa_handler == SIG_IGN;
}

void set_handler(void (*handler)(int))
{
    for (const int number : ending_signals)
        if (!is_ignored(number))
            std::signal(number, handler);
}

void remove_on_signal(const fs::path& path)
{
    const std::string& name = path.native();
    path_to_remove.fill('\0');
    std::copy_n(name.begin(), std::min(name.size(), path_to_remove.size() - 1), path_to_remove.begin());
    set_handler(remove_and_end);
    std::signal(SIGXFSZ, SIG_IGN); // beyond a limit on file sizes, write() then fails like on a full disk
}

bool is_special(const fs::path& path)
{
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// A link stays a link: what it points to is replaced.
fs::path behind_links(const fs::path& path)
{
    std::error_code error;
    const fs::path real = fs::is_symlink(path, error) ? fs::canonical(path, error) : path;
    return error ? path : real;
}

fs::path temporary_name(const fs::path& target, int attempt)
{
    return target.parent_path() /
           (".kfast-" + std::to_string(::getpid()) + '-' + std::to_string(attempt) + ".tmp");
}

const char* remedy(int error_number)
{
    switch (error_number) {
    case ENOENT:
    case ENOTDIR:
        return "create the folder first, or choose another place";
    case EACCES:
    case EPERM:
    case EROFS:
        return "choose a place you may write to";
    case EISDIR:
        return "name a file, not a folder";
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return "make room, or choose another place";
    default:
        return "choose another place";
    }
}

}

AtomicFile::AtomicFile(const fs::path& target) : target_{behind_links(target)}
{
    std::error_code unknown;
    if (fs::is_directory(target_, unknown))
        fail(EISDIR);
    if (is_special(target_))
        open_special();
    else
        open_temporary();
}

AtomicFile::~AtomicFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
    if (!temporary_)
        return;
    ::unlink(temporary_->c_str());
    set_handler(SIG_DFL);
}

void AtomicFile::open_special()
{
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0)
        fail(errno);
}

void AtomicFile::open_temporary()
{
    for (int attempt = 0; !temporary_; ++attempt) {
        const fs::path name = temporary_name(target_, attempt);
        remove_on_signal(name);
        descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0)
            temporary_ = name;
        else if (const int error_number = errno; error_number != EEXIST) {
            set_handler(SIG_DFL);
            fail(error_number);
        }
    }
}

void AtomicFile::write(std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            fail(errno);
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
}

void AtomicFile::commit()
{
    close();
    if (!temporary_)
        return;
    if (std::rename(temporary_->c_str(), target_.c_str()) != 0)
        fail(errno);
    temporary_.reset();
    set_handler(SIG_DFL);
}

void AtomicFile::close()
{
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0)
        fail(errno);
}

void AtomicFile::fail(int error_number) const
{
    throw Failure("cannot write " + target_.string() + ": " + std::strerror(error_number) + ": " +
                  remedy(error_number));
}

void write_file(const fs::path& target, std::span<const std::byte> bytes)
{
    AtomicFile file{target};
    file.write(bytes);
    file.commit();
}

}
