#include "host/preview/files/file_watch.hpp"

#include <algorithm>
#include <sys/stat.h>
#include <utility>

namespace kfast {
namespace {

namespace fs = std::filesystem;

constexpr FileWatch::Seconds between_looks{0.25};
constexpr FileWatch::Seconds until_settled{0.2};
constexpr FileWatch::Seconds until_missed{1.5};

std::chrono::nanoseconds since_epoch(const timespec& time)
{
    return std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

}

FileWatch::FileWatch(const std::vector<fs::path>& files)
{
    for (const fs::path& file : files)
        add(file);
}

void FileWatch::add(const fs::path& file)
{
    std::error_code unknown;
    if (fs::exists(file, unknown) && !fs::is_regular_file(file, unknown))
        return;
    files_.push_back(file);
    known_.push_back(look(file));
    latest_.push_back(known_.back());
}

bool FileWatch::has_changed(Seconds now)
{
    if (now - looked_ < between_looks)
        return false;
    looked_ = now;
    std::vector<State> current = look();
    if (current != latest_) {
        latest_ = std::move(current);
        latest_since_ = now;
        return false;
    }
    const bool all_there =
        std::ranges::all_of(latest_, [](const State& state) { return state.exists && state.size > 0; });
    if (latest_ == known_ || now - latest_since_ < (all_there ? until_settled : until_missed))
        return false;
    known_ = latest_;
    return true;
}

FileWatch::State FileWatch::look(const fs::path& file)
{
    struct stat found = {};
    if (::stat(file.c_str(), &found) != 0)
        return {};
    return {true,
            found.st_dev,
            found.st_ino,
            found.st_size,
            since_epoch(found.st_mtim),
            since_epoch(found.st_ctim)};
}

std::vector<FileWatch::State> FileWatch::look() const
{
    std::vector<State> states;
    for (const fs::path& file : files_)
        states.push_back(look(file));
    return states;
}

}
