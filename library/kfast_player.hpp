/* KFAST for sketches and other programs in C++11 or later: begin, update, draw.
 *
 *     static const kfast_features features = ROBOT_EYES_FEATURES;
 *     KfastPlayer<robot_eyes_block_bytes> player;
 *     std::uint16_t pixels[4096];
 *
 *     void setup() { player.begin(robot_eyes, robot_eyes_width, robot_eyes_height, features); }
 *     void loop()
 *     {
 *         if (player.update(millis()))
 *             player.draw(pixels, draw_rectangle);
 *     }
 *
 * `kfast export --header` writes robot_eyes and the constants. It uses kfast.h, which has the details. */
#ifndef KFAST_PLAYER_HPP
#define KFAST_PLAYER_HPP

#include "library/kfast.h"

#include <stddef.h>
#include <stdint.h>

/// The name of an event, to be compared; valid as long as the scene exists.
struct KfastEvent {
    const char* name; ///< UTF-8, with no 0 after it
    size_t bytes;

    bool operator==(const char* other) const
    {
        for (size_t i = 0; i < bytes; ++i)
            if (other[i] == '\0' || other[i] != name[i])
                return false;
        return other[bytes] == '\0';
    }
    bool operator!=(const char* other) const { return !(*this == other); }
};

/// Draws in one format: kfast_draw_rgb565 and the others of kfast.h.
typedef kfast_error (*kfast_draw_format)(kfast_player*, void*, size_t, kfast_draw_rectangle, void*);

/// A scene that plays in memory of its own, of which it needs `block_bytes`: the constant beside the scene.
/// Every function may be called at any time, and only returns false as long as begin() has not
/// succeeded.
template <size_t block_bytes>
class KfastPlayer {
public:
    KfastPlayer() : player_(nullptr), error_(KFAST_NULL_POINTER) {}

    /// Makes the scene ready for a panel of this size, at its beginning. The scene must stay where it is.
    /// Returns whether it can be played; error() returns why not.
    bool begin(const void* scene, size_t scene_bytes, int width, int height)
    {
        return succeeds(kfast_create(&player_, block_, sizeof block_, scene, scene_bytes, width, height));
    }
    template <size_t scene_bytes>
    bool begin(const unsigned char (&scene)[scene_bytes], int width, int height)
    {
        return begin(scene, scene_bytes, width, height);
    }
    /// The same with these features only: kfast_create_with() says what that is for.
    bool begin(const void* scene, size_t scene_bytes, int width, int height, const kfast_features& features)
    {
        return succeeds(
            kfast_create_with(&player_, block_, sizeof block_, scene, scene_bytes, width, height, &features));
    }
    template <size_t scene_bytes>
    bool begin(const unsigned char (&scene)[scene_bytes], int width, int height,
               const kfast_features& features)
    {
        return begin(scene, scene_bytes, width, height, features);
    }

    /// Plays a clip from the next update() on, or without a name the whole scene. False if there is none.
    bool play(const char* clip = nullptr) { return succeeds(kfast_choose_clip(player_, clip)); }
    /// Whether a clip that plays once has reached its end.
    bool finished() const { return kfast_finished(player_) != 0; }

    /// Whether the picture has coarser curves, or is not complete, for want of room.
    bool is_coarse() const { return kfast_is_coarse(player_) != 0; }

    /// Computes the picture for when a clock, such as millis(), shows this. Returns whether there is
    /// something to draw.
    bool update(uint32_t milliseconds) { return kfast_update(player_, milliseconds, nullptr, nullptr) != 0; }
    /// The same; also calls event_passed(KfastEvent) for each event of the scene on the way.
    template <class EventPassed>
    bool update(uint32_t milliseconds, EventPassed event_passed)
    {
        return kfast_update(player_, milliseconds, on_event<EventPassed>, &event_passed) != 0;
    }

    /// Sets an input to `value` in 1/1000 of what the scene counts it in: 500 is 0.5. False if there is none.
    bool set_input(const char* name, int32_t value)
    {
        return succeeds(kfast_set_input(player_, name, value));
    }
    /// Sets a text, in UTF-8.
    bool set_text(const char* name, const char* text)
    {
        return succeeds(kfast_set_text(player_, name, text));
    }
    /// Sets a drawing to `strokes` strokes, of stroke_points[0], stroke_points[1], ... points in 1/16 pixel;
    /// all is copied. Returns false also if the drawing takes fewer: then nothing changes.
    bool set_drawing(const char* name, const kfast_point* points, const uint16_t* stroke_points,
                     size_t strokes)
    {
        return succeeds(kfast_set_drawing(player_, name, points, stroke_points, strokes));
    }

    /// Calls draw_rectangle(int x, int y, int width, int height, Pixel* pixels) for each rectangle that has
    /// changed; the pixels are in `buffer`, which holds a row of the panel or more, and are gone after the
    /// call. Pixels are rgb565 unless you choose another format: draw<kfast_draw_mono1>(bytes,
    /// draw_rectangle). Returns false if the buffer is too small.
    template <kfast_draw_format format = kfast_draw_rgb565, class Pixel, size_t pixels, class DrawRectangle>
    bool draw(Pixel (&buffer)[pixels], DrawRectangle draw_rectangle)
    {
        return succeeds(
            format(player_, buffer, sizeof buffer, hand_out<Pixel, DrawRectangle>, &draw_rectangle));
    }

    /// The display shows something else now: the next update() and draw() hand out all of it.
    bool redraw() { return succeeds(kfast_redraw(player_)); }

    /// The error of the last function that returned false, for people; "ok" if the last one succeeded.
    const char* error() const { return kfast_error_text(error_); }

    /// For what else kfast.h can do; NULL before begin().
    kfast_player* player() { return player_; }

private:
    KfastPlayer(const KfastPlayer&); // the player is within
    KfastPlayer& operator=(const KfastPlayer&);

    bool succeeds(kfast_error error)
    {
        error_ = error;
        return error == KFAST_OK;
    }

    template <class EventPassed>
    static void on_event(const char* name, size_t bytes, void* event_passed)
    {
        const KfastEvent event = {name, bytes};
        (*static_cast<EventPassed*>(event_passed))(event);
    }

    template <class Pixel, class DrawRectangle>
    static void hand_out(int x, int y, int width, int height, const void* pixels, void* draw_rectangle)
    {
        // They are in the caller's buffer, which is no constant.
        Pixel* const own = static_cast<Pixel*>(const_cast<void*>(pixels));
        (*static_cast<DrawRectangle*>(draw_rectangle))(x, y, width, height, own);
    }

    kfast_player* player_;
    kfast_error error_;
    unsigned char block_[block_bytes];
};

#endif
