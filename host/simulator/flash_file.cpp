#include "host/simulator/flash_file.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace kfast {
namespace {

constexpr std::byte erased{0xFF};

/// A file that is closed unless it is let go.
class OpenFile {
public:
    explicit OpenFile(const std::filesystem::path& path)
        : path_{path}, number_{::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)}
    {
        if (number_ < 0)
            fail(std::string{"cannot be opened: "} + std::strerror(errno));
    }
    ~OpenFile()
    {
        if (number_ >= 0)
            ::close(number_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[noreturn]] void fail(const std::string& why) const { throw Failure(path_.string() + ": " + why); }

    void lock() const
    {
        if (::flock(number_, LOCK_EX | LOCK_NB) != 0)
            fail("another simulated board uses it: name another file with --flash-file");
    }

    std::size_t size() const
    {
        struct stat facts {};
        if (::fstat(number_, &facts) != 0)
            fail(std::strerror(errno));
        if (!S_ISREG(facts.st_mode))
            fail("is no file for the flash of a board");
        return static_cast<std::size_t>(facts.st_size);
    }

    /// Written, not just made longer: a full disk is reported now.
    void fill(std::size_t size) const
    {
        const std::vector<std::byte> bytes(size, erased);
        if (::write(number_, bytes.data(), size) != static_cast<ssize_t>(size)) {
            static_cast<void>(::ftruncate(number_, 0));
            fail(std::string{"cannot be written: "} + std::strerror(errno));
        }
    }

    std::span<std::byte> mapped(std::size_t size) const
    {
        void* const bytes = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, number_, 0);
        if (bytes == MAP_FAILED)
            fail(std::string{"cannot be read: "} + std::strerror(errno));
        return {static_cast<std::byte*>(bytes), size};
    }

    int let_go() { return std::exchange(number_, -1); }

private:
    const std::filesystem::path& path_;
    int number_;
};

}

FlashFile::FlashFile(const std::filesystem::path& path, std::size_t size)
{
    OpenFile file{path};
    file.lock();
    if (file.size() == 0)
        file.fill(size);
    if (file.size() != size)
        file.fail("has " + std::to_string(file.size()) + " bytes, and the flash of this board " +
                  std::to_string(size) + ": is it another file?");
    bytes_ = file.mapped(size);
    file_ = file.let_go();
}

FlashFile::~FlashFile()
{
    ::munmap(bytes_.data(), bytes_.size());
    ::close(file_);
}

std::span<std::byte> FlashFile::place(std::uint32_t offset, std::uint32_t size) const
{
    if (offset % size != 0 || offset >= bytes_.size())
        throw std::logic_error("flash is used against its rules");
    return bytes_.subspan(offset, size);
}

void FlashFile::erase(std::uint32_t offset) { std::ranges::fill(place(offset, sector_bytes), erased); }

void FlashFile::program(std::uint32_t offset, std::span<const std::byte, page_bytes> page)
{
    const auto clear = [](std::byte before, std::byte wanted) { return before & wanted; };
    const std::span<std::byte> there = place(offset, page_bytes);
    std::ranges::transform(there, page, there.begin(), clear);
}

}
