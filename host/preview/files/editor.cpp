#include "host/preview/files/editor.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ; // NOLINT: POSIX declares it nowhere

namespace kfast {

namespace {

namespace fs = std::filesystem;

/// How an editor is given a file and a line.
struct Form {
    std::string_view name;
    std::string_view arguments;
    bool takes_terminal = false;
};

constexpr std::string_view by_plus = "+{line} {file}";
constexpr std::string_view by_colon = "{file}:{line}";
constexpr std::string_view by_goto = "-g {file}:{line}";

constexpr std::array forms{
    Form{"editor", by_plus, true},
    Form{"sensible-editor", by_plus, true},
    Form{"vi", by_plus, true},
    Form{"vim", by_plus, true},
    Form{"nvi", by_plus, true},
    Form{"nvim", by_plus, true},
    Form{"view", by_plus, true},
    Form{"nano", by_plus, true},
    Form{"pico", by_plus, true},
    Form{"joe", by_plus, true},
    Form{"jed", "{file} -g {line}", true},
    Form{"kak", by_plus, true},
    Form{"ne", by_plus, true},
    Form{"mg", by_plus, true},
    Form{"zile", by_plus, true},
    Form{"mcedit", by_colon, true},
    Form{"micro", "{file} +{line}", true},
    Form{"hx", by_colon, true},
    Form{"helix", by_colon, true},
    Form{"emacs", by_plus},
    Form{"emacsclient", by_plus},
    Form{"gvim", by_plus},
    Form{"gedit", by_plus},
    Form{"xed", by_plus},
    Form{"pluma", by_plus},
    Form{"geany", "-l {line} {file}"},
    Form{"kate", "-l {line} {file}"},
    Form{"kwrite", "-l {line} {file}"},
    Form{"code", by_goto},
    Form{"code-insiders", by_goto},
    Form{"codium", by_goto},
    Form{"vscodium", by_goto},
    Form{"cursor", by_goto},
    Form{"subl", by_colon},
    Form{"zed", by_colon},
    Form{"mate", "-l {line} {file}"},
    Form{"idea", "--line {line} {file}"},
};

/// The name without options, folders and the suffix of a variant of Debian, as in vim.tiny.
std::string_view program_of(std::string_view editor)
{
    const std::size_t begin = std::min(editor.find_first_not_of(' '), editor.size());
    editor.remove_prefix(begin);
    editor = editor.substr(0, editor.find(' '));
    editor.remove_prefix(editor.rfind('/') + 1);
    return editor.substr(0, editor.find('.'));
}

const Form* form_of(std::string_view editor)
{
    const auto* const form = std::ranges::find(forms, program_of(editor), &Form::name);
    return form == forms.end() ? nullptr : form;
}

std::string quoted(const std::string& text)
{
    std::string quoted = "'";
    for (const char letter : text)
        if (letter == '\'')
            quoted += "'\\''";
        else
            quoted += letter;
    return quoted + '\'';
}

std::string replaced(std::string text, std::string_view what, const std::string& with)
{
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

}

std::string chosen_editor()
{
    for (const char* const name : {"KFAST_EDITOR", "VISUAL", "EDITOR"})
        if (const char* const editor = std::getenv(name); editor != nullptr && *editor != '\0')
            return editor;
    throw Failure("no editor is set: set KFAST_EDITOR, VISUAL or EDITOR, as in EDITOR=nano");
}

std::string editor_command(std::string_view editor, const TextLine& at)
{
    std::string command{editor};
    if (command.find("{file}") == std::string::npos) {
        const Form* const form = form_of(editor);
        command.append(" ").append(form == nullptr ? "{file}" : form->arguments);
    }
    command = replaced(std::move(command), "{line}", std::to_string(at.line));
    std::error_code unknown;
    return replaced(std::move(command), "{file}",
                    quoted(fs::absolute(at.file, unknown).lexically_normal().string()));
}

bool takes_terminal(std::string_view editor)
{
    const Form* const form = form_of(editor);
    const bool has_terminal_option =
        editor.find(" -nw") != std::string_view::npos || editor.find(" -t") != std::string_view::npos;
    return form != nullptr &&
           (form->takes_terminal || (form->name.starts_with("emacs") && has_terminal_option));
}

std::optional<std::size_t> line_of_mistake(std::span<const std::string> messages, const fs::path& file)
{
    const std::string beginning = file.string() + ':';
    for (const std::string& text : messages) {
        if (!text.starts_with(beginning))
            continue;
        std::size_t line = 0;
        const char* const end = text.data() + text.size();
        if (std::from_chars(text.data() + beginning.size(), end, line).ec == std::errc{} && line > 0)
            return line;
    }
    return std::nullopt;
}

namespace {

constexpr std::array keys_that_end{SIGINT, SIGQUIT};

constexpr const char* other_editor = "set KFAST_EDITOR to another one";

std::string in_quotation_marks(const std::string& editor) { return '"' + editor + '"'; }

/// Keys end the program that is started, whether or not this one ignores them.
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

/// The message for an editor that was not there or ended with an error; empty if it went well or was stopped.
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

/// While it lives, this program ignores the keys that end programs; the editor gets them.
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
