#include "host/compile/reported_compile.hpp"
#include "host/file/input_file.hpp"
#include "host/picture/player_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/preview/playback/preview_playback.hpp"
#include "host/preview/terminal/borrowed_terminal.hpp"
#include "host/program/failure.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <string_view>

// kfast-first-look SCENE.kfast LOOPS: plays a scene text in the terminal, as `kfast preview --terminal` does,
// with what is compiled within a minute. Without a terminal, it prints the first frame.

namespace {

using kfast::BorrowedTerminal;
using kfast::Keyboard;
using kfast::PreviewKey;
using Seconds = kfast::PreviewPlayback::Seconds;

struct Arguments {
    std::string file;
    int loops = 0;
};

Arguments read_arguments(int count, char** texts)
{
    Arguments arguments;
    if (count == 3) {
        const std::string_view loops = texts[2];
        const auto [end, error] = std::from_chars(loops.begin(), loops.end(), arguments.loops);
        if (error == std::errc{} && end == loops.end() && arguments.loops > 0) {
            arguments.file = texts[1];
            return arguments;
        }
    }
    throw kfast::Failure("usage: kfast-first-look SCENE.kfast LOOPS", kfast::ExitStatus::wrong_usage);
}

std::vector<std::byte> compile_file(const std::string& file)
{
    const kfast::SourceText source{file, kfast::read_input(file, kfast::scene_input)};
    kfast::CompiledText compiled = kfast::compile_and_report(source);
    if (!compiled.bytes)
        throw kfast::Failure(file + ": " + kfast::counted(compiled.errors, "error"));
    return std::move(*compiled.bytes);
}

/// Plays the scene, one picture above the other, until it has played often enough or a key quits.
class Film {
public:
    Film(const kfast::SceneView& scene, int loops)
        : source_{scene, scene.canvas(), kfast::Fit::none, kfast::PixelFormat::rgb565},
          timeline_{kfast::timeline_of(scene)},
          frames_{timeline_.frame_count() * loops}
    {
    }

    void play()
    {
        Keyboard keyboard;
        BorrowedTerminal terminal{keyboard};
        Seconds begin = kfast::steady_now();
        const Seconds frame_length{1000.0 / timeline_.frame_rate};
        for (int frame = 0; frame < frames_ && !quits_ && !terminal.is_to_end();
             frame = std::max(frame + 1, static_cast<int>((kfast::steady_now() - begin) / frame_length))) {
            const Seconds before = kfast::steady_now();
            if (terminal.stop_if_asked()) {
                begin += kfast::steady_now() - before;
                lines_ = 0;
            }
            draw(frame % timeline_.frame_count());
            wait(keyboard, begin + frame_length * (frame + 1));
        }
    }

    std::string text_of(int frame)
    {
        return kfast::terminal_picture(widen(source_.show(timeline_.frame_time(frame))));
    }

private:
    void draw(int frame)
    {
        const std::string text = text_of(frame);
        const kfast::Size size = kfast::terminal_size();
        kfast::write_to_terminal(kfast::way_back(lines_, size_, size) + text);
        size_ = size;
        lines_ = std::count(text.begin(), text.end(), '\n');
    }

    void wait(Keyboard& keyboard, Seconds until)
    {
        const Seconds patience = until - kfast::steady_now();
        if (patience <= Seconds{0})
            return;
        for (const PreviewKey key : keyboard.pressed(patience))
            quits_ = quits_ || key == PreviewKey::quit || key == PreviewKey::leave;
    }

    kfast::PlayerSource source_;
    kfast::Timeline timeline_;
    int frames_;
    bool quits_ = false;
    kfast::Size size_{};       ///< of the terminal when it was drawn last
    std::ptrdiff_t lines_ = 0; ///< of the picture that was drawn last
};

void show(const Arguments& arguments)
{
    const std::vector<std::byte> bytes = compile_file(arguments.file);
    const kfast::Result<kfast::SceneView> scene = kfast::SceneView::parse(bytes);
    if (!scene)
        throw kfast::Failure(arguments.file + ": its compiled scene contradicts itself");
    Film film{*scene, arguments.loops};
    if (kfast::can_play_in_terminal())
        film.play();
    else
        kfast::write_to_terminal(film.text_of(0));
}

}

int main(int count, char** arguments)
{
    try {
        show(read_arguments(count, arguments));
    } catch (const kfast::Failure& failure) {
        std::cerr << "kfast-first-look: " << failure.what() << '\n';
        return static_cast<int>(failure.status());
    }
}
