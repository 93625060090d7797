#include "host/preview/window/picture_window.hpp"

#include "host/file/program_file.hpp"
#include "host/preview/painter/raster_painter.hpp"
#include "host/program/failure.hpp"

#include <SDL.h>
#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <optional>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace kfast {

namespace {

constexpr int pixel_bytes = sizeof(Colour);
constexpr Size smallest_window{320, 240};

struct Destroy {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};

template <class T>
using Owned = std::unique_ptr<T, Destroy>;

template <class T>
Owned<T> owned(T* made)
{
    if (made == nullptr)
        throw Failure(std::string("cannot open a window: ") + SDL_GetError() + ": try --terminal");
    return Owned<T>{made};
}

/// Without a display SDL falls back to invisible drawing, unless it was requested.
bool is_seen(std::string_view driver)
{
    const char* wanted = std::getenv("SDL_VIDEODRIVER");
    const bool is_wanted = wanted != nullptr && *wanted != '\0';
    return is_wanted || (driver != "offscreen" && driver != "dummy");
}

/// While it lives, nothing reaches standard error: libraries of displays complain there of what they do not
/// find, one after another, and the consequence is reported by us.
class QuietErrors {
public:
    QuietErrors() : before_{::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)}
    {
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (before_ >= 0 && nowhere >= 0)
            ::dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0)
            ::close(nowhere);
    }
    ~QuietErrors()
    {
        if (before_ < 0)
            return;
        ::dup2(before_, STDERR_FILENO);
        ::close(before_);
    }
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;

private:
    int before_; ///< standard error; -1 if there is none
};

/// The video part of SDL, which alone knows whether there is a display.
class Video {
public:
    Video() : works_{start() && is_seen(SDL_GetCurrentVideoDriver())} {}
    ~Video() { SDL_Quit(); }
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    bool works() const { return works_; }

private:
    /// Drivers of the computer's graphics card are loaded by SDL where the libraries are the computer's as
    /// well.
    static bool start()
    {
        if (has_own_libraries()) {
            SDL_SetHint(SDL_HINT_RENDER_DRIVER, "software");
            SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
        }
        const QuietErrors quiet;
        return SDL_Init(SDL_INIT_VIDEO) == 0;
    }

    bool works_;
};

/// The part of a size that fits on the screen.
Size on_screen(Size wanted)
{
    SDL_Rect screen{0, 0, 1024, 768};
    SDL_GetDisplayUsableBounds(0, &screen);
    const auto side = [](int want, int min, int room) {
        return std::min(std::max(want, min), std::max(1, room * 9 / 10));
    };
    return {side(wanted.width, smallest_window.width, screen.w),
            side(wanted.height, smallest_window.height, screen.h)};
}

/// As in preview_key(); empty if the key has no name there.
std::string name_of(const SDL_Keysym& key)
{
    switch (key.sym) {
    case SDLK_SPACE:
        return "space";
    case SDLK_RIGHT:
        return "right";
    case SDLK_LEFT:
        return "left";
    case SDLK_UP:
        return "up";
    case SDLK_DOWN:
        return "down";
    case SDLK_ESCAPE:
        return "escape";
    case SDLK_RETURN:
    case SDLK_KP_ENTER:
        return "enter";
    case SDLK_TAB:
        return (key.mod & KMOD_SHIFT) != 0 ? "shift-tab" : "tab";
    case SDLK_EQUALS: // where + is typed with shift
    case SDLK_KP_PLUS:
        return "+";
    case SDLK_KP_MINUS:
        return "-";
    default:
        return key.sym > ' ' && key.sym <= 'z' && key.sym != '?' ? std::string(1, static_cast<char>(key.sym))
                                                                 : "";
    }
}

std::optional<PreviewKey> pressed(const SDL_Keysym& key)
{
    const bool is_of_desktop = (key.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0;
    return is_of_desktop ? std::nullopt : preview_key(name_of(key));
}

PointerEvent pointer(PointerEvent::Kind kind, const SDL_MouseButtonEvent& button)
{
    using Button = PointerEvent::Button;
    return {.kind = kind,
            .x = button.x,
            .y = button.y,
            .button = button.button == SDL_BUTTON_LEFT ? Button::left : Button::other};
}

PointerEvent wheel(const SDL_MouseWheelEvent& turned)
{
    PointerEvent event{PointerEvent::Kind::wheel};
    SDL_GetMouseState(&event.x, &event.y);
    event.wheel = turned.direction == SDL_MOUSEWHEEL_FLIPPED ? -turned.y : turned.y;
    return event;
}

void take(const SDL_Event& event, PictureWindow::Events& into)
{
    using Kind = PointerEvent::Kind;
    switch (event.type) {
    case SDL_QUIT:
        into.is_closed = true;
        return;
    case SDL_KEYDOWN:
        if (const std::optional<PreviewKey> key = pressed(event.key.keysym))
            into.keys.push_back(*key);
        return;
    case SDL_TEXTINPUT: // keyboards have it in different places
        if (std::string_view{event.text.text} == "?")
            into.keys.push_back(PreviewKey::help);
        return;
    case SDL_MOUSEBUTTONDOWN:
        return into.pointer.push_back(pointer(Kind::press, event.button));
    case SDL_MOUSEBUTTONUP:
        return into.pointer.push_back(pointer(Kind::release, event.button));
    case SDL_MOUSEMOTION:
        return into.pointer.push_back({Kind::move, event.motion.x, event.motion.y});
    case SDL_MOUSEWHEEL:
        return into.pointer.push_back(wheel(event.wheel));
    case SDL_DROPFILE:
        into.dropped.emplace_back(event.drop.file);
        SDL_free(event.drop.file);
        return;
    default:
        return;
    }
}

class SdlWindow : public PictureWindow {
public:
    SdlWindow(std::unique_ptr<Video> video, const std::string& title, Size size)
        : video_{std::move(video)},
          window_{owned(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                         size.width, size.height, SDL_WINDOW_RESIZABLE))},
          renderer_{owned(SDL_CreateRenderer(window_.get(), -1, 0))}
    {
        SDL_SetWindowMinimumSize(window_.get(), smallest_window.width, smallest_window.height);
    }

    void set_title(const std::string& title) override { SDL_SetWindowTitle(window_.get(), title.c_str()); }

    void draw(const std::function<void(Painter&)>& paint) override
    {
        painter_.begin(size());
        paint(painter_);
        show(painter_.drawn());
    }

    Events take_events(int milliseconds) override
    {
        Events events;
        SDL_Event event;
        events.any = SDL_WaitEventTimeout(&event, milliseconds) != 0;
        for (bool more = events.any; more; more = SDL_PollEvent(&event) != 0)
            take(event, events);
        return events;
    }

private:
    Size size() const
    {
        Size size;
        SDL_GetRendererOutputSize(renderer_.get(), &size.width, &size.height);
        return {std::max(1, size.width), std::max(1, size.height)};
    }

    void show(const Picture& picture)
    {
        if (texture_ == nullptr || texture_size_ != picture.size) {
            texture_size_ = picture.size;
            texture_ =
                owned(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STREAMING,
                                        texture_size_.width, texture_size_.height));
        }
        SDL_UpdateTexture(texture_.get(), nullptr, picture.pixels.data(), picture.size.width * pixel_bytes);
        SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr);
        SDL_RenderPresent(renderer_.get());
    }

    std::unique_ptr<Video> video_;
    Owned<SDL_Window> window_;
    Owned<SDL_Renderer> renderer_;
    Owned<SDL_Texture> texture_;
    Size texture_size_;
    RasterPainter painter_;
};

}

std::unique_ptr<PictureWindow> PictureWindow::open(const std::string& title, Size size)
{
    auto video = std::make_unique<Video>();
    if (!video->works())
        return nullptr;
    const Size window = on_screen(size);
    return std::make_unique<SdlWindow>(std::move(video), title, window);
}

bool PictureWindow::can_open() { return Video{}.works(); }

const char* PictureWindow::no_window() { return "there is no display for a window"; }

}
