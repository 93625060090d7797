// Plays what an emulator recorded on the wires of a panel into the model of its controller, and prints the
// board's text. To the lines that begin with "F " it appends the CRC-32 of the picture that is on the glass
// then, upright: the number that `kfast hash` prints.
//
//     kfast-panel TRACE RECORD [--pictures FOLDER]
//
// RECORD holds a board record (firmware/settings/board_record.hpp), which says what panel it is. With
// --pictures each of those pictures is written, too: 0000.png and so on. A damaged trace, or a mistake on the
// wires, ends it with status 1.

#include "firmware/settings/board_record.hpp"
#include "host/picture/png.hpp"
#include "host/program/failure.hpp"
#include "host/simulator/trace.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace kfast {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    fs::path trace;
    fs::path record;
    fs::path pictures; ///< empty: none
};

/// Traces are larger than anything that a user hands in, hence no read_input().
std::string content(const fs::path& path)
{
    std::ifstream file{path, std::ios::binary};
    std::string all{std::istreambuf_iterator<char>{file}, {}};
    if (!file)
        throw Failure(path.string() + ": cannot be read");
    return all;
}

PanelSettings panel_in(const fs::path& path)
{
    const std::string record = content(path);
    const auto settings = read_board_record(std::as_bytes(std::span{record}));
    if (!settings)
        throw Failure(path.string() + ": is no board record");
    return settings->panel;
}

class ReplayPrinter {
public:
    ReplayPrinter(const ControllerModel& model, Rotation rotation, fs::path folder)
        : model_{model}, rotation_{rotation}, folder_{std::move(folder)}
    {
        if (!folder_.empty())
            fs::create_directories(folder_);
    }

    void print(std::string_view note)
    {
        std::cout << note;
        if (note.starts_with("F "))
            print_picture(seen_upright(model_.picture(), rotation_));
        std::cout << '\n';
    }

private:
    void print_picture(const Frame& picture)
    {
        char text[16];
        std::snprintf(text, sizeof text, " %08x", hash(picture));
        std::cout << text;
        std::snprintf(text, sizeof text, "%04d.png", count_++);
        if (!folder_.empty())
            write_png(folder_ / text, widen(picture));
    }

    const ControllerModel& model_;
    Rotation rotation_;
    fs::path folder_;
    int count_ = 0;
};

void replay(const Arguments& arguments)
{
    const PanelSettings panel = panel_in(arguments.record);
    const std::string bytes = content(arguments.trace);
    const auto trace = read_trace(std::as_bytes(std::span{bytes}));
    const auto model = make_controller_model(panel);
    ReplayPrinter replay_printer{*model, panel.rotation, arguments.pictures};
    TraceReplay{*model}.play(trace, [&replay_printer](std::string_view note) { replay_printer.print(note); });
}

}
}

int main(int count, char** arguments)
{
    const bool has_pictures = count == 5 && std::string_view{arguments[3]} == "--pictures";
    if (count != 3 && !has_pictures) {
        std::cerr << "usage: kfast-panel TRACE RECORD [--pictures FOLDER]\n";
        return 2;
    }
    try {
        kfast::replay({arguments[1], arguments[2], has_pictures ? arguments[4] : ""});
    } catch (const std::exception& failure) {
        std::cout.flush();
        std::cerr << "kfast-panel: " << failure.what() << '\n';
        return 1;
    }
    return 0;
}
