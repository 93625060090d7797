#include "host/preview/files/file_dialogue.hpp"

#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;

/// A PATH in which there are only programs of this test.
class Desktop {
public:
    Desktop() { ::setenv("PATH", (folder / "").c_str(), 1); }
    ~Desktop() { ::setenv("PATH", before_.c_str(), 1); }
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    void install(const char* name, const std::string& script) const
    {
        std::ofstream{folder / name} << "#!/bin/sh\n" << script << '\n';
        fs::permissions(folder / name, fs::perms::owner_all);
    }

    TemporaryFolder folder;

private:
    std::string before_ = std::getenv("PATH");
};

std::optional<fs::path> answer(FileDialogue& dialogue)
{
    std::optional<fs::path> answer;
    while (dialogue.is_asking() && !answer) {
        answer = dialogue.take_answer();
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return answer;
}

}

TEST_CASE("without a dialogue the remedy is told")
{
    const Desktop desktop;
    FileDialogue dialogue;
    CHECK_THROWS_WITH_AS(dialogue.ask("."),
                         "there is no file dialogue: install zenity or kdialog, or drop the file here, or "
                         "give it on the command "
                         "line",
                         Failure);
    CHECK(!dialogue.is_asking());
}

TEST_CASE("zenity and kdialog are asked, and begin in the folder of the scene")
{
    for (const char* const name : {"zenity", "kdialog"}) {
        const Desktop desktop;
        desktop.install(name, "echo \"$@\" > \"$0.arguments\"; echo '/tmp/a b  c.kfast'");
        FileDialogue dialogue;
        dialogue.ask(desktop.folder / "scenes");
        CHECK(answer(dialogue) == fs::path{"/tmp/a b  c.kfast"});
        CHECK(!dialogue.is_asking());
        const std::string arguments = content(desktop.folder / (std::string{name} + ".arguments").c_str());
        CHECK(arguments.find((desktop.folder / "scenes/").string()) != std::string::npos);
    }
}

TEST_CASE("a dialogue that is cancelled answers nothing, and can be asked again")
{
    const Desktop desktop;
    desktop.install("zenity", "exit 1");
    FileDialogue dialogue;
    for (int i = 0; i < 2; ++i) {
        dialogue.ask("");
        CHECK(!answer(dialogue));
    }
}

TEST_CASE("a dialogue that fails is told, with what helps")
{
    const Desktop desktop;
    FileDialogue dialogue;
    desktop.install("kdialog", "exit 5");
    dialogue.ask("");
    CHECK_THROWS_WITH_AS(answer(dialogue),
                         "kdialog failed with status 5: drop the file here, or give it on the command line",
                         Failure);
    CHECK(!dialogue.is_asking());
    desktop.install("zenity", "kill -ABRT $$");
    dialogue.ask("");
    CHECK_THROWS_WITH_AS(answer(dialogue),
                         "zenity was ended by signal 6: drop the file here, or give it on the command line",
                         Failure);
    std::ofstream{desktop.folder / "zenity"} << "#!/no/such/program\n";
    CHECK_THROWS_AS(dialogue.ask(""), Failure);
    CHECK(!dialogue.is_asking());
}

TEST_CASE("nobody waits for a dialogue, and it ends with the preview")
{
    const Desktop desktop;
    desktop.install("zenity", "exec /bin/sleep 1000");
    FileDialogue dialogue;
    dialogue.ask("");
    CHECK(!dialogue.take_answer());
    CHECK(dialogue.is_asking());
}

}
