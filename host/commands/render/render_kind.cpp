#include "host/commands/render/render_kind.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string_view>

namespace kfast {
namespace {

namespace fs = std::filesystem;

struct NamedKind {
    std::string_view ending;
    RenderKind of_moment; ///< folder if there is none
    RenderKind of_film;
};

constexpr std::array kinds{
    NamedKind{".png", RenderKind::png, RenderKind::apng},
    NamedKind{".svg", RenderKind::svg, RenderKind::svg},
    NamedKind{".apng", RenderKind::folder, RenderKind::apng},
    NamedKind{".gif", RenderKind::folder, RenderKind::gif},
    NamedKind{".mp4", RenderKind::folder, RenderKind::mp4},
    NamedKind{".webm", RenderKind::folder, RenderKind::webm},
};

[[noreturn]] void refuse(const std::string& reason) { throw CLI::ValidationError("--output", reason); }

[[noreturn]] void refuse_ending(const std::string& ending)
{
    std::string known;
    for (const NamedKind& kind : kinds)
        known.append(known.empty() ? "" : ", ").append(kind.ending);
    refuse("'" + ending + "' is no kind that there is: choose " + known +
           ", or with --all a name without an ending, or with / behind it, for a folder");
}

std::string lower(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

RenderKind kind_of_moment(const NamedKind& kind)
{
    if (kind.of_moment == RenderKind::folder)
        refuse("one frame makes a .png or an .svg: add --all for a " + std::string{kind.ending});
    return kind.of_moment;
}

void require_png(const std::string& ending, const char* what)
{
    if (ending != ".png")
        refuse(std::string{what} + " is a .png: choose such a name");
}

const NamedKind* kind_named(const std::string& ending)
{
    const auto kind = std::ranges::find(kinds, ending, &NamedKind::ending);
    return kind == kinds.end() ? nullptr : &*kind;
}

}

RenderSubject default_subject(const fs::path& output)
{
    const NamedKind* const kind = kind_named(lower(output.extension().string()));
    return kind != nullptr && kind->of_moment == RenderKind::folder ? RenderSubject::film
                                                                    : RenderSubject::moment;
}

RenderKind render_kind(const fs::path& output, RenderSubject subject)
{
    std::error_code unknown;
    const std::string ending = lower(output.extension().string());
    if (subject == RenderSubject::sprite_sheet || subject == RenderSubject::contact_sheet) {
        require_png(ending, subject == RenderSubject::sprite_sheet ? "a sheet" : "a contact sheet");
        return RenderKind::png;
    }
    const bool is_film = subject == RenderSubject::film;
    if (ending.empty() || (is_film && fs::is_directory(output, unknown)))
        return is_film ? RenderKind::folder : RenderKind::png;
    const NamedKind* const kind = kind_named(ending);
    if (kind == nullptr)
        refuse_ending(ending);
    return is_film ? kind->of_film : kind_of_moment(*kind);
}

}
