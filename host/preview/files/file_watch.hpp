#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace kfast {

/// Detects when files have changed on disk, replaced ones too. The caller supplies the time, a steady one.
class FileWatch {
public:
    using Seconds = std::chrono::duration<double>;

    FileWatch() = default;
    explicit FileWatch(const std::vector<std::filesystem::path>& files);

    /// Takes the present state of the file as known: must be called before it is read. What is no regular
    /// file, a pipe for instance, never changes.
    void add(const std::filesystem::path& file);

    /// Whether a file differs from its known state; then the present state is known from now on. Looks four
    /// times a second at most, and waits until nobody writes any more: longer where a file is gone or empty,
    /// as it is while an editor replaces it.
    bool has_changed(Seconds now);

private:
    struct State {
        bool exists = false;
        std::uint64_t device = 0;
        std::uint64_t inode = 0;
        std::int64_t size = 0;
        std::chrono::nanoseconds written{0};
        std::chrono::nanoseconds touched{0}; ///< its permissions too

        bool operator==(const State&) const = default;
    };

    static State look(const std::filesystem::path& file);
    std::vector<State> look() const;

    std::vector<std::filesystem::path> files_;
    std::vector<State> known_;
    std::vector<State> latest_;
    Seconds looked_{-1e9};
    Seconds latest_since_{0};
};

}
