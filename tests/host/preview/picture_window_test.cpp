#include "host/preview/window/picture_window.hpp"

#include <SDL.h>
#include <cstdlib>
#include <doctest/doctest.h>
#include <initializer_list>
#include <utility>

namespace kfast::test {
namespace {

/// A window that is nowhere to be seen, whose user is this test.
struct UnseenWindow {
    UnseenWindow()
    {
        ::setenv("SDL_VIDEODRIVER", "dummy", 1);
        window = PictureWindow::open("test", {400, 300});
        REQUIRE(window);
        while (window->take_events(1).any) {
        }
    }

    PictureWindow::Events after(SDL_Event event)
    {
        SDL_PushEvent(&event);
        return window->take_events(1000);
    }

    std::vector<PreviewKey> keys_of(SDL_Keycode key, int modifiers = KMOD_NONE)
    {
        SDL_Event event{};
        event.type = SDL_KEYDOWN;
        event.key.keysym.sym = key;
        event.key.keysym.mod = static_cast<Uint16>(modifiers);
        return after(event).keys;
    }

    std::unique_ptr<PictureWindow> window;
};

}

TEST_CASE("keys of the keyboard are those of a preview")
{
    UnseenWindow window;
    const std::initializer_list<std::pair<SDL_Keycode, PreviewKey>> keys{
        {SDLK_SPACE, PreviewKey::play_pause},
        {SDLK_RIGHT, PreviewKey::next_frame},
        {SDLK_LEFT, PreviewKey::previous_frame},
        {SDLK_UP, PreviewKey::faster},
        {SDLK_DOWN, PreviewKey::slower},
        {SDLK_ESCAPE, PreviewKey::leave},
        {SDLK_TAB, PreviewKey::next_item},
        {SDLK_PLUS, PreviewKey::more_input},
        {SDLK_EQUALS, PreviewKey::more_input},
        {SDLK_KP_PLUS, PreviewKey::more_input},
        {SDLK_MINUS, PreviewKey::less_input},
        {SDLK_KP_MINUS, PreviewKey::less_input},
        {SDLK_RETURN, PreviewKey::edit},
        {SDLK_KP_ENTER, PreviewKey::edit},
        {SDLK_h, PreviewKey::help},
        {SDLK_q, PreviewKey::quit},
        {SDLK_r, PreviewKey::read_file},
        {SDLK_n, PreviewKey::next_key},
        {SDLK_p, PreviewKey::previous_key},
        {SDLK_a, PreviewKey::all_frames}};
    for (const auto& expected : keys) {
        CAPTURE(SDL_GetKeyName(expected.first));
        CHECK(window.keys_of(expected.first) == std::vector{expected.second});
    }
    CHECK(window.keys_of(SDLK_TAB, KMOD_LSHIFT) == std::vector{PreviewKey::previous_item});
}

TEST_CASE("keys of the desktop, and others, do nothing")
{
    UnseenWindow window;
    CHECK(window.keys_of(SDLK_q, KMOD_LCTRL).empty());
    CHECK(window.keys_of(SDLK_TAB, KMOD_LALT).empty());
    CHECK(window.keys_of(SDLK_F1).empty());
    CHECK(window.keys_of(SDLK_7).empty());
    CHECK(window.keys_of(SDLK_LSHIFT).empty());
}

TEST_CASE("a question mark is the help, wherever the keyboard has it")
{
    UnseenWindow window;
    SDL_Event event{};
    event.type = SDL_TEXTINPUT;
    event.text.text[0] = '?';
    SDL_PushEvent(&event);
    CHECK(window.window->take_events(0).keys == std::vector{PreviewKey::help});
    CHECK(window.keys_of(SDLK_QUESTION).empty());
}

TEST_CASE("the mouse, files that are dropped, and the window's end are told")
{
    UnseenWindow window;
    SDL_Event event{};
    event.type = SDL_MOUSEBUTTONDOWN;
    event.button.button = SDL_BUTTON_RIGHT;
    event.button.x = 7;
    event.button.y = 9;
    const auto pressed = window.after(event).pointer;
    REQUIRE(pressed.size() == 1);
    CHECK(pressed[0].kind == PointerEvent::Kind::press);
    CHECK(pressed[0].button == PointerEvent::Button::other);
    CHECK(pressed[0].x == 7);
    CHECK(pressed[0].y == 9);

    event = {};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.y = 2;
    event.wheel.direction = SDL_MOUSEWHEEL_FLIPPED;
    const auto turned = window.after(event).pointer;
    REQUIRE(turned.size() == 1);
    CHECK(turned[0].wheel == -2);

    event = {};
    event.type = SDL_DROPFILE;
    event.drop.file = SDL_strdup("eyes.kfast");
    CHECK(window.after(event).dropped == std::vector<std::filesystem::path>{"eyes.kfast"});

    event = {};
    event.type = SDL_QUIT;
    CHECK(window.after(event).is_closed);
}

}
