#include "host/preview/picture_window.hpp"

#include "host/failure.hpp"
#include "host/picture/picture.hpp"
#include "host/preview/placement.hpp"

#include <SDL2_gfxPrimitives.h> // with it SDL.h
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

namespace kfast {
namespace {

constexpr int letter = 8; // pixels of a character of SDL2_gfx's font, in both directions
constexpr int line_height = 3 * letter / 2;
constexpr int status_height = 2 * letter;
constexpr int pixel_bytes = sizeof(Colour);
constexpr Size smallest_window{384, 240};

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

/// Without a display SDL falls back to drawing where nobody sees it, unless it was told to.
bool is_seen(std::string_view driver)
{
    return std::getenv("SDL_VIDEODRIVER") != nullptr || (driver != "offscreen" && driver != "dummy");
}

/// The video part of SDL, which alone knows whether there is a display.
class Video {
public:
    Video() : works_{SDL_Init(SDL_INIT_VIDEO) == 0 && is_seen(SDL_GetCurrentVideoDriver())} {}
    ~Video() { SDL_Quit(); }
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    bool works() const { return works_; }

private:
    bool works_;
};

/// Small pictures are magnified to a comfortable size, large ones shrunk to the screen.
Size first_window_size(Size picture)
{
    SDL_Rect screen{0, 0, 1024, 768};
    SDL_GetDisplayUsableBounds(0, &screen);
    const Size most{screen.w * 3 / 4, screen.h * 3 / 4 - status_height};
    const Size wanted{std::min(most.width, std::max(2 * picture.width, smallest_window.width)),
                      std::min(most.height, std::max(2 * picture.height, smallest_window.height))};
    const Rect place = placement(picture, wanted);
    return {std::max(place.width, smallest_window.width),
            std::max(place.height, smallest_window.height) + status_height};
}

std::optional<PreviewKey> pressed(SDL_Keycode code)
{
    switch (code) {
    case SDLK_SPACE:
        return PreviewKey::play_pause;
    case SDLK_n:
        return PreviewKey::next_key;
    case SDLK_p:
        return PreviewKey::previous_key;
    case SDLK_RIGHT:
        return PreviewKey::next_frame;
    case SDLK_LEFT:
        return PreviewKey::previous_frame;
    case SDLK_UP:
        return PreviewKey::faster;
    case SDLK_DOWN:
        return PreviewKey::slower;
    case SDLK_v:
        return PreviewKey::reverse;
    case SDLK_c:
        return PreviewKey::next_clip;
    case SDLK_b:
        return PreviewKey::previous_clip;
    case SDLK_i:
        return PreviewKey::next_input;
    case SDLK_PLUS:
    case SDLK_EQUALS: // where + is typed with shift
    case SDLK_KP_PLUS:
        return PreviewKey::more_input;
    case SDLK_MINUS:
    case SDLK_KP_MINUS:
        return PreviewKey::less_input;
    case SDLK_t:
        return PreviewKey::travel;
    case SDLK_h:
        return PreviewKey::help;
    case SDLK_q:
    case SDLK_ESCAPE:
        return PreviewKey::quit;
    default:
        return std::nullopt;
    }
}

std::optional<PreviewKey> asked(const SDL_Event& event)
{
    if (event.type == SDL_QUIT)
        return PreviewKey::quit;
    return event.type == SDL_KEYDOWN ? pressed(event.key.keysym.sym) : std::nullopt;
}

class SdlWindow : public PictureWindow {
public:
    SdlWindow(std::unique_ptr<Video> video, const std::string& title, Size picture, Size window)
        : video_{std::move(video)}, window_{owned(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED,
                                                                   SDL_WINDOWPOS_CENTERED, window.width,
                                                                   window.height, SDL_WINDOW_RESIZABLE))},
          renderer_{owned(SDL_CreateRenderer(window_.get(), -1, 0))},
          texture_{owned(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGBA32,
                                           SDL_TEXTUREACCESS_STREAMING, picture.width, picture.height))},
          picture_{picture}
    {
    }

    void draw(const Frame& frame, const std::string& status, std::span<const std::string> help) override
    {
        SDL_SetRenderDrawColor(renderer_.get(), 40, 40, 44, 255);
        SDL_RenderClear(renderer_.get());
        draw_picture(frame);
        draw_text(letter / 2, size().height - letter * 3 / 2, status);
        if (!help.empty())
            draw_help(help);
        SDL_RenderPresent(renderer_.get());
    }

    Events take_events(int milliseconds) override
    {
        Events events;
        SDL_Event event;
        events.any = SDL_WaitEventTimeout(&event, milliseconds) != 0;
        for (bool more = events.any; more; more = SDL_PollEvent(&event) != 0)
            if (const std::optional<PreviewKey> key = asked(event))
                events.keys.push_back(*key);
        return events;
    }

private:
    Size size() const
    {
        Size size;
        SDL_GetRendererOutputSize(renderer_.get(), &size.width, &size.height);
        return size;
    }

    void draw_picture(const Frame& frame)
    {
        const Picture picture = widen(frame);
        SDL_UpdateTexture(texture_.get(), nullptr, picture.pixels.data(), picture_.width * pixel_bytes);
        const Size space{size().width, std::max(1, size().height - status_height)};
        const Rect place = placement(picture_, space);
        const bool whole = place.width >= picture_.width;
        SDL_SetTextureScaleMode(texture_.get(), whole ? SDL_ScaleModeNearest : SDL_ScaleModeLinear);
        const SDL_Rect target{place.x, place.y, place.width, place.height};
        SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, &target);
    }

    void draw_text(int x, int y, const std::string& text)
    {
        const auto at = [](int value) { return static_cast<Sint16>(value); };
        stringRGBA(renderer_.get(), at(x), at(y), text.c_str(), 240, 240, 240, 255);
    }

    void draw_help(std::span<const std::string> lines)
    {
        const auto longest = std::ranges::max(lines, {}, &std::string::size).size();
        const SDL_Rect box{letter, letter, letter * (static_cast<int>(longest) + 2),
                           line_height * static_cast<int>(lines.size()) + letter * 3 / 2};
        SDL_SetRenderDrawBlendMode(renderer_.get(), SDL_BLENDMODE_BLEND);
        SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 200);
        SDL_RenderFillRect(renderer_.get(), &box);
        int y = box.y + letter;
        for (const std::string& line : lines) {
            draw_text(box.x + letter, y, line);
            y += line_height;
        }
    }

    std::unique_ptr<Video> video_;
    Owned<SDL_Window> window_;
    Owned<SDL_Renderer> renderer_;
    Owned<SDL_Texture> texture_;
    Size picture_;
};

}

std::unique_ptr<PictureWindow> PictureWindow::open(const std::string& title, Size picture)
{
    auto video = std::make_unique<Video>();
    if (!video->works())
        return nullptr;
    const Size window = first_window_size(picture);
    return std::make_unique<SdlWindow>(std::move(video), title, picture, window);
}

const char* PictureWindow::no_window() { return "there is no display for a window"; }

}
