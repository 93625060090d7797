#include "host/file/atomic_file.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace kfast {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_at_once = 4;

// What a signal has to remove; empty where there is nothing. A handler may touch nothing but plain memory,
// hence no std::string.
std::array<std::array<char, PATH_MAX>, max_at_once> paths_to_remove{};

constexpr std::array ending_signals{SIGHUP, SIGINT, SIGTERM};

extern "C" void remove_and_end(int number)
{
    remove_unfinished_files();
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

auto* slot_of(std::string_view name)
{
    return std::ranges::find(paths_to_remove, name,
                             [](const auto& path) { return std::string_view{path.data()}; });
}

void remove_on_signal(const fs::path& path)
{
    auto* const slot = slot_of("");
    if (slot == paths_to_remove.end())
        throw std::logic_error("more than " + std::to_string(max_at_once) + " files at once");
    if (path.native().size() >= slot->size())
        throw Failure("cannot write " + path.string() + ": the name is too long: choose a shorter one");
    std::ranges::copy(path.native().substr(1), slot->begin() + 1);
    std::atomic_signal_fence(std::memory_order_seq_cst); // a signal sees all of it or nothing
    slot->front() = path.native().front();
    set_handler(remove_and_end);
    std::signal(SIGXFSZ, SIG_IGN); // beyond a limit on file sizes, write() then fails like on a full disk
}

void keep_on_signal(const fs::path& path)
{
    auto* const slot = slot_of(path.native());
    slot->front() = '\0';
    std::atomic_signal_fence(std::memory_order_seq_cst);
    slot->fill('\0');
    if (std::ranges::all_of(paths_to_remove, [](const auto& other) { return other.front() == '\0'; }))
        set_handler(SIG_DFL);
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

/// Whether `descriptor` could be brought to the disk, or needs not, like a pipe; if not, errno says why.
bool is_synchronized(int descriptor)
{
    while (::fsync(descriptor) != 0)
        if (errno != EINTR)
            return errno == EINVAL || errno == ENOTSUP;
    return true;
}

/// A folder whose names can be brought to the disk. One that may be written to and not read stays closed.
class OpenFolder {
public:
    explicit OpenFolder(const fs::path& folder)
        : descriptor_{::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)},
          is_usable_{descriptor_ >= 0 || errno == EACCES}
    {
    }
    ~OpenFolder()
    {
        if (descriptor_ >= 0)
            ::close(descriptor_);
    }
    OpenFolder(const OpenFolder&) = delete;
    OpenFolder& operator=(const OpenFolder&) = delete;

    /// Otherwise errno says why not.
    bool is_usable() const { return is_usable_; }
    bool synchronize_names() const { return descriptor_ < 0 || is_synchronized(descriptor_); }
    /// All files of the disk that it lies on, or of all disks, where that cannot be told.
    bool synchronize_files() const
    {
        if (descriptor_ >= 0)
            return ::syncfs(descriptor_) == 0;
        ::sync();
        return true;
    }

private:
    int descriptor_;
    bool is_usable_;
};

fs::path temporary_name(const fs::path& target, int attempt)
{
    return target.parent_path() /
           (".kfast-" + std::to_string(::getpid()) + '-' + std::to_string(attempt) + ".tmp");
}

const char* hint(int error_number)
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

[[noreturn]] void refuse(const fs::path& target, int error_number)
{
    throw Failure("cannot write " + target.string() + ": " + std::strerror(error_number) + ": " +
                  hint(error_number));
}

}

AtomicFile::AtomicFile(const fs::path& target, Sync sync) : target_{behind_links(target)}, sync_{sync}
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
    keep_on_signal(*temporary_);
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
        fs::path name = temporary_name(target_, attempt);
        remove_on_signal(name);
        descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        const int error_number = errno;
        if (descriptor_ >= 0)
            temporary_ = std::move(name); // a copy could fail, and nobody would remove the file
        else
            keep_on_signal(name);
        if (!temporary_ && error_number != EEXIST)
            fail(error_number);
    }
    keep_permissions();
}

/// What takes the place of a file that others may not read is not for them either.
void AtomicFile::keep_permissions() const
{
    struct stat before = {};
    if (::stat(target_.c_str(), &before) != 0 || ::fchmod(descriptor_, before.st_mode & 0777) == 0)
        return;
    if (errno != EPERM && errno != ENOTSUP) // file systems without permissions refuse to change any
        fail(errno);
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
    finish();
    if (!temporary_)
        return;
    const OpenFolder folder{target_.parent_path()}; // which may fail, and then nothing has changed
    if (!folder.is_usable() || std::rename(temporary_->c_str(), target_.c_str()) != 0)
        fail(errno);
    keep_on_signal(*temporary_);
    temporary_.reset();
    if (sync_ == Sync::now && !folder.synchronize_names())
        fail(errno);
}

void AtomicFile::finish()
{
    if (descriptor_ >= 0 && temporary_ && sync_ == Sync::now && !is_synchronized(descriptor_))
        fail(errno);
    const int descriptor = std::exchange(descriptor_, -1);
    if (descriptor >= 0 && ::close(descriptor) != 0)
        fail(errno);
}

void AtomicFile::fail(int error_number) const { refuse(target_, error_number); }

void remove_unfinished_files() noexcept
{
    for (const auto& path : paths_to_remove)
        if (path.front() != '\0')
            ::unlink(path.data());
}

void write_file(const fs::path& target, std::span<const std::byte> bytes, Sync sync)
{
    AtomicFile file{target, sync};
    file.write(bytes);
    file.commit();
}

void synchronize(const fs::path& folder)
{
    const OpenFolder open{folder};
    if (!open.is_usable() || !open.synchronize_files())
        refuse(folder, errno);
}

}
