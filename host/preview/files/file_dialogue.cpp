#include "host/preview/files/file_dialogue.hpp"

#include "host/program/failure.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <span>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

extern char** environ; // NOLINT: POSIX declares it nowhere

namespace kfast {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kinds = "*.kfast *.kfb *.json *.lottie *.svg *.sif";

/// Empty if there is none in PATH.
fs::path program_in_path(const char* name)
{
    const char* const path = std::getenv("PATH");
    std::string_view folders = path == nullptr ? "" : path;
    while (!folders.empty()) {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        fs::path program = fs::path{folders.substr(0, end)} / name;
        std::error_code unknown;
        if (end != 0 && fs::is_regular_file(program, unknown) && ::access(program.c_str(), X_OK) == 0)
            return program;
        folders.remove_prefix(std::min(end + 1, folders.size()));
    }
    return {};
}

/// Adds a slash at the end, which says that it is a folder.
std::string folder_argument(const fs::path& folder)
{
    std::error_code unknown;
    const fs::path whole = fs::absolute(folder.empty() ? "." : folder, unknown).lexically_normal();
    return (whole / "").string();
}

std::vector<std::string> arguments_of(const fs::path& program, const fs::path& folder)
{
    const std::string begin = folder_argument(folder);
    const std::string all{kinds};
    if (program.filename() == "zenity")
        return {program,
                "--file-selection",
                "--title=Read a scene",
                "--filename=" + begin,
                "--file-filter=Scenes | " + all,
                "--file-filter=All files | *"};
    return {program, "--title", "Read a scene", "--getopenfilename", begin, all + " | Scenes"};
}

constexpr const char* hint = "drop the file here, or give it on the command line";

[[noreturn]] void refuse(const fs::path& program, int error_number)
{
    throw Failure(program.string() + " cannot be started: " + std::strerror(error_number) + ": " + hint);
}

/// The failure of a dialogue in which neither a file was chosen nor none was wanted; empty otherwise.
std::string failure_of(int status)
{
    constexpr int cancelled = 1; // of zenity and of kdialog
    if (WIFSIGNALED(status))
        return "was ended by signal " + std::to_string(WTERMSIG(status));
    const int code = WEXITSTATUS(status);
    return code == 0 || code == cancelled ? "" : "failed with status " + std::to_string(code);
}

}

FileDialogue::~FileDialogue()
{
    if (process_ == 0)
        return;
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
    ::close(answer_);
}

void FileDialogue::ask(const fs::path& folder)
{
    for (const char* const name : {"zenity", "kdialog"})
        if (const fs::path program = program_in_path(name); !program.empty())
            return start(program, folder);
    throw Failure(std::string{"there is no file dialogue: install zenity or kdialog, or "} + hint);
}

void FileDialogue::start(const fs::path& program, const fs::path& folder)
{
    std::vector<std::string> arguments = arguments_of(program, folder);
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);

    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        refuse(program, errno);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    const int error = ::posix_spawn(&process_, program.c_str(), &actions, nullptr, pointers.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    answer_ = ends[0];
    ::fcntl(answer_, F_SETFL, O_NONBLOCK);
    text_.clear();
    program_ = program.filename().string();
    if (error == 0)
        return;
    process_ = 0;
    ::close(answer_);
    refuse(program, error);
}

/// Reads the available output.
bool FileDialogue::has_ended()
{
    constexpr std::size_t longest_path = 65536;
    std::array<char, 4096> block{};
    for (;;) {
        const ssize_t count = ::read(answer_, block.data(), block.size());
        if (count < 0)
            return errno != EAGAIN && errno != EINTR;
        if (count == 0)
            return true;
        if (text_.size() < longest_path)
            text_.append(block.data(), static_cast<std::size_t>(count));
    }
}

std::optional<fs::path> FileDialogue::take_answer()
{
    if (process_ == 0 || !has_ended())
        return std::nullopt;
    int status = 0;
    ::waitpid(std::exchange(process_, 0), &status, 0);
    ::close(answer_);
    if (text_.ends_with('\n'))
        text_.pop_back();
    if (const std::string failure = failure_of(status); !failure.empty())
        throw Failure(program_ + ' ' + failure + ": " + hint);
    const bool was_chosen = WEXITSTATUS(status) == 0 && !text_.empty();
    return was_chosen ? std::optional{fs::path{text_}} : std::nullopt;
}

}
