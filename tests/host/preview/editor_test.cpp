#include "host/preview/files/editor.hpp"

#include "host/program/failure.hpp"
#include "tests/host/preview/watched_preview.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <utility>

namespace kfast::test {
namespace {

/// Editors that are set while this lives; empty ones are not.
struct Editors {
    Editors(const char* own, const char* visual, const char* editor)
    {
        ::setenv("KFAST_EDITOR", own, 1);
        ::setenv("VISUAL", visual, 1);
        ::setenv("EDITOR", editor, 1);
    }
    ~Editors()
    {
        for (const char* const name : {"KFAST_EDITOR", "VISUAL", "EDITOR"})
            ::unsetenv(name);
    }
    Editors(const Editors&) = delete;
};

struct FakeEditor : Editor {
    explicit FakeEditor(std::vector<TextLine>& opened) : opened_{opened} {}
    void open(const TextLine& at) override { opened_.push_back(at); }
    std::string take_failure() override { return std::exchange(failure_, {}); }

    std::vector<TextLine>& opened_;
    std::string failure_;
};

std::string failure_of(Editor& editor, const TextLine& at)
{
    try {
        editor.open(at);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "";
}

}

TEST_CASE("an editor gets the line in its own way, and a file with a quote is one word")
{
    const TextLine at{"/tmp/my 'eyes'.kfast", 17};
    const std::string file = "'/tmp/my '\\''eyes'\\''.kfast'";
    CHECK(editor_command("vim", at) == "vim +17 " + file);
    CHECK(editor_command("/usr/bin/nano -w", at) == "/usr/bin/nano -w +17 " + file);
    CHECK(editor_command("emacs", at) == "emacs +17 " + file);
    CHECK(editor_command("code", at) == "code -g " + file + ":17");
    CHECK(editor_command("code --wait", at) == "code --wait -g " + file + ":17");
    CHECK(editor_command("my-editor", at) == "my-editor " + file);
    CHECK(editor_command("my-editor --at={line} {file}", at) == "my-editor --at=17 " + file);
}

TEST_CASE("editors that take the terminal are known")
{
    CHECK(takes_terminal("vim"));
    CHECK(takes_terminal("/usr/bin/nano -w"));
    CHECK(takes_terminal("emacs -nw"));
    for (const char* const name :
         {"editor", "/usr/bin/sensible-editor", "/usr/bin/vim.tiny", "vim.basic -n", "nvi"})
        CHECK_MESSAGE(takes_terminal(name), name);
    CHECK_FALSE(takes_terminal("emacs"));
    CHECK_FALSE(takes_terminal("code -w"));
    CHECK_FALSE(takes_terminal("whatever"));
}

TEST_CASE("KFAST_EDITOR goes before VISUAL before EDITOR, and without any there is a remedy")
{
    CHECK((Editors{"code", "vim", "nano"}, chosen_editor()) == "code");
    CHECK((Editors{"", "vim", "nano"}, chosen_editor()) == "vim");
    CHECK((Editors{"", "", "nano"}, chosen_editor()) == "nano");
    const Editors none{"", "", ""};
    EditorBeside editor;
    CHECK(failure_of(editor, {"a", 1}) ==
          "no editor is set: set KFAST_EDITOR, VISUAL or EDITOR, as in EDITOR=nano");
}

TEST_CASE("an editor that is not there, or fails, is reported once")
{
    const Editors missing{"/no/such/program", "", ""};
    EditorBeside editor;
    CHECK(failure_of(editor, {"a", 1}).empty());
    std::string failure;
    for (int i = 0; i < 1000 && failure.empty(); ++i) {
        failure = editor.take_failure();
        ::usleep(10'000);
    }
    CHECK(failure == "the editor \"/no/such/program\" is not there: set KFAST_EDITOR to another one");
    CHECK(editor.take_failure().empty());
}

TEST_CASE("an editor in the terminal is ended by the key that the preview is spared from")
{
    const Editors killed{"kill -INT $$; exit 3; true {file}", "", ""};
    CHECK_NOTHROW(edit_in_terminal({"a", 1}));
}

TEST_CASE("the text is opened where the selected object stands, or at its first mistake")
{
    std::vector<TextLine> opened;
    Preview preview;
    preview.viewer.let_edit(std::make_unique<FakeEditor>(opened));
    preview.press({PreviewKey::edit, PreviewKey::next_item, PreviewKey::edit});
    const fs::path file = preview.folder / "lamp.kfast";
    CHECK(opened == std::vector<TextLine>{{file, 1}, {file, 9}});
    CHECK(preview.viewer.notice() == "line 9 is opened in the editor");
    CHECK(preview.viewer.selected_line() == TextLine{file, 9});
    preview.replace(replaced(moving, "rect 12", "rectangle 12"));
    preview.wait();
    preview.press({PreviewKey::edit});
    CHECK(opened.back() == TextLine{file, 7});
    const fs::path dropped = preview.folder / "dropped.kfast";
    write(dropped, "kfast 1\ncanvas 16 16\nobjekt lamp\n");
    preview.viewer.open(dropped, preview.now);
    preview.press({PreviewKey::edit});
    CHECK(opened.back() == TextLine{dropped, 3});
}

TEST_CASE("without an editor, and of a compiled scene, the reason is shown why nothing opens")
{
    Preview preview;
    preview.press({PreviewKey::edit});
    CHECK(preview.viewer.notice().find("from a window or a terminal") != std::string::npos);
    const auto compiled = open_scene(preview.folder / "lamp.kfast");
    const std::vector<std::byte>& bytes = compiled->scene.bytes;
    write(preview.folder / "lamp.kfb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    std::vector<TextLine> opened;
    preview.viewer.let_edit(std::make_unique<FakeEditor>(opened));
    preview.viewer.open(preview.folder / "lamp.kfb", preview.now);
    preview.press({PreviewKey::edit});
    CHECK(preview.viewer.notice() == "lamp.kfb is compiled: edit the text that it was made from");
    CHECK(opened.empty());
}

TEST_CASE("what is unfolded stays so when the file is saved, and other files begin folded")
{
    Preview preview;
    preview.press({PreviewKey::quantities});
    CHECK(preview.viewer.unfolded_table().rows.size() == 4);
    preview.press({PreviewKey::quantities});
    CHECK(preview.viewer.unfolded_table().rows.size() == 2);
    preview.press({PreviewKey::previous_item, PreviewKey::quantities});
    REQUIRE(preview.viewer.selected_name() == "lamp");
    CHECK(preview.viewer.unfolded_table().rows.back().name == "shape");
    preview.replace(std::string{moving} + "object new fill=red { rect 0 0 1 1 }\n");
    preview.wait();
    REQUIRE(preview.viewer.unfolded_table().rows.size() == 4);
    CHECK(preview.viewer.unfolded_table().rows.back().is_quantity);
    preview.viewer.open(preview.folder / "lamp.kfast", preview.now);
    CHECK(preview.viewer.unfolded_table().rows.size() == 3);
}

TEST_CASE("playing as a board is shown with its name, and goes on when the file is saved")
{
    Preview preview;
    preview.press({PreviewKey::board_speed});
    CHECK(preview.viewer.status() == "frame 0  0.000 s  playing  as on pico");
    preview.wait();
    CHECK(preview.viewer.status().find("  as on pico: 10 fps") != std::string::npos);
    preview.replace(replaced(moving, "rect 12", "rect 11"));
    preview.wait();
    CHECK(preview.viewer.status().find("  as on pico: ") != std::string::npos);
    preview.press({PreviewKey::board_speed});
    CHECK(preview.viewer.status().find("as on") == std::string::npos);
}

}
