#include "host/preview/files/editor.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ; // NOLINT: POSIX declares it nowhere

namespace kfast {
namespace {

constexpr std::array keys_that_end{SIGINT, SIGQUIT};

constexpr const char* other_editor = "set KFAST_EDITOR to another one";

std::string in_quotation_marks(const std::string& editor) { return '"' + editor + '"'; }

/// Keys end the program that is started, whether or not this one is spared from them.
class EndedByKeys {
public:
    EndedByKeys()
    {
        sigset_t ending{};
        ::sigemptyset(&ending);
        for (const int number : keys_that_end)
            ::sigaddset(&ending, number);
        ::posix_spawnattr_init(&attributes_);
        ::posix_spawnattr_setsigdefault(&attributes_, &ending);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
    }
    ~EndedByKeys() { ::posix_spawnattr_destroy(&attributes_); }
    EndedByKeys(const EndedByKeys&) = delete;
    EndedByKeys& operator=(const EndedByKeys&) = delete;

    const posix_spawnattr_t* attributes() const { return &attributes_; }

private:
    posix_spawnattr_t attributes_{};
};

pid_t started(const std::string& editor, const TextLine& at)
{
    std::string shell = "sh";
    std::string option = "-c";
    std::string command = editor_command(editor, at);
    std::array<char*, 4> arguments{shell.data(), option.data(), command.data(), nullptr};
    const EndedByKeys ended_by_keys;
    pid_t process = 0;
    if (const int error = ::posix_spawn(&process, "/bin/sh", nullptr, ended_by_keys.attributes(),
                                        arguments.data(), environ))
        throw Failure("the editor " + in_quotation_marks(editor) +
                      " cannot be started: " + std::strerror(error));
    return process;
}

/// How an editor ended that found nothing to do; empty if it went well.
std::string failure_of(const std::string& editor, int status)
{
    constexpr int not_found = 127; // of a shell
    if (WIFSIGNALED(status) || WEXITSTATUS(status) == 0)
        return "";
    const int code = WEXITSTATUS(status);
    return "the editor " + in_quotation_marks(editor) +
           (code == not_found ? " is not there: " : " failed with status " + std::to_string(code) + ": ") +
           other_editor;
}

int status_at_end(pid_t process)
{
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR)
        continue;
    return status;
}

/// While it lives, keys that end programs are for the editor alone.
class SparedFromKeys {
public:
    SparedFromKeys()
    {
        for (std::size_t i = 0; i < keys_that_end.size(); ++i)
            before_[i] = std::signal(keys_that_end[i], SIG_IGN);
    }
    ~SparedFromKeys()
    {
        for (std::size_t i = 0; i < keys_that_end.size(); ++i)
            std::signal(keys_that_end[i], before_[i]);
    }
    SparedFromKeys(const SparedFromKeys&) = delete;
    SparedFromKeys& operator=(const SparedFromKeys&) = delete;

private:
    std::array<void (*)(int), keys_that_end.size()> before_{};
};

bool has_terminal() { return ::isatty(STDIN_FILENO) != 0 && ::tcgetpgrp(STDIN_FILENO) == ::getpgrp(); }

}

EditorBeside::~EditorBeside()
{
    for (const Running& running : running_)
        if (running.has_terminal)
            status_at_end(running.process);
}

void EditorBeside::open(const TextLine& at)
{
    const std::string editor = chosen_editor();
    const bool wants_terminal = takes_terminal(editor);
    if (wants_terminal && !has_terminal())
        throw Failure(
            "the editor " + in_quotation_marks(editor) +
            " needs a terminal: start the preview in one, or set KFAST_EDITOR to one with a window");
    if (wants_terminal && std::ranges::any_of(running_, &Running::has_terminal))
        throw Failure("an editor is open in the terminal: end it first");
    running_.push_back({started(editor, at), editor, wants_terminal});
}

std::string EditorBeside::take_failure()
{
    std::string failure;
    std::erase_if(running_, [&failure](const Running& running) {
        int status = 0;
        if (::waitpid(running.process, &status, WNOHANG) == 0)
            return false;
        failure = failure_of(running.editor, status);
        return true;
    });
    return failure;
}

void edit_in_terminal(const TextLine& at)
{
    const std::string editor = chosen_editor();
    int status = 0;
    {
        const SparedFromKeys spared;
        status = status_at_end(started(editor, at));
    }
    if (const std::string failure = failure_of(editor, status); !failure.empty())
        throw Failure(failure);
}

}
