#include "host/file/input_file.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace kfast {
namespace {

namespace fs = std::filesystem;

std::string in_words(int error_number, const InputKind& kind)
{
    switch (error_number) {
    case ENOENT:
    case ENOTDIR:
        return "there is no such file: check the name and the folder";
    case EISDIR:
        return "this is a folder: name " + std::string{kind.files} + " in it";
    case EACCES:
    case EPERM:
        return "you may not read it: change its permissions (chmod u+r) or copy it";
    default:
        return std::string("cannot be read: ") + std::strerror(error_number);
    }
}

class InputFile {
public:
    InputFile(const fs::path& path, const InputKind& kind)
        : path_{path}, kind_{kind}, descriptor_{::open(path.c_str(), O_RDONLY | O_CLOEXEC)}
    {
        if (descriptor_ < 0)
            refuse(in_words(errno, kind_));
    }
    ~InputFile() { ::close(descriptor_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// At most one block beyond the limit, also of an endless pipe.
    std::string content() const
    {
        std::string all;
        std::array<char, 65536> block{};
        while (all.size() <= kind_.max_bytes) {
            const ssize_t count = ::read(descriptor_, block.data(), block.size());
            if (count < 0)
                refuse(in_words(errno, kind_));
            if (count == 0)
                break;
            all.append(block.data(), static_cast<std::size_t>(count));
        }
        return all;
    }

    [[noreturn]] void refuse(const std::string& reason) const
    {
        throw Failure(path_.string() + ": " + reason);
    }

private:
    fs::path path_;
    InputKind kind_;
    int descriptor_;
};

}

std::string read_input(const fs::path& path, const InputKind& kind)
{
    if (path.empty())
        throw Failure("the name of the file is empty: name " + std::string{kind.files});
    const InputFile file{path, kind};
    std::string content = file.content();
    if (content.empty())
        file.refuse("the file is empty: " + std::string{kind.begins});
    if (content.size() > kind.max_bytes)
        file.refuse("larger than " + std::to_string(kind.max_bytes >> 20) + " MB, more than any " +
                    std::string{kind.noun} + " needs: is it the right file?");
    return content;
}

}
