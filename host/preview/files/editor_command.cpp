#include "host/preview/files/editor_command.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

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

/// Without options, folders and the suffix of a variant of Debian, as in vim.tiny.
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

}
