/* KFAST for C, and for everything that can call C: a compiled scene on a display that something else drives.
 *
 * A player is in memory that you lend, and hands out rectangles of finished pixels. There is no heap, no
 * clock and no thread behind it. A NULL where a pointer is needed is an error like any other, so that a
 * player that could not be made may be used without harm. docs/library.md shows a whole program; kfast.hpp is
 * the same in C++. */
#ifndef KFAST_H
#define KFAST_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
namespace kfast {
struct StrokeFeature;
struct TweenFeature;
struct BoneFeature;
struct BackboneFeature;
struct DepthFeature;
struct WireFeature;
struct PathFeature;
struct SmoothFeature;
struct TextFeature;
struct DrawingFeature;
struct TrimFeature;
struct SpringFeature;
}
typedef const kfast::StrokeFeature kfast_stroke_code;
typedef const kfast::TweenFeature kfast_tween_code;
typedef const kfast::BoneFeature kfast_bone_code;
typedef const kfast::BackboneFeature kfast_backbone_code;
typedef const kfast::DepthFeature kfast_depth_code;
typedef const kfast::WireFeature kfast_wire_code;
typedef const kfast::PathFeature kfast_path_code;
typedef const kfast::SmoothFeature kfast_smooth_code;
typedef const kfast::TextFeature kfast_text_code;
typedef const kfast::DrawingFeature kfast_drawing_code;
typedef const kfast::TrimFeature kfast_trim_code;
typedef const kfast::SpringFeature kfast_spring_code;
extern "C" {
#else
typedef const struct kfast_stroke_code kfast_stroke_code;
typedef const struct kfast_tween_code kfast_tween_code;
typedef const struct kfast_bone_code kfast_bone_code;
typedef const struct kfast_backbone_code kfast_backbone_code;
typedef const struct kfast_depth_code kfast_depth_code;
typedef const struct kfast_wire_code kfast_wire_code;
typedef const struct kfast_path_code kfast_path_code;
typedef const struct kfast_smooth_code kfast_smooth_code;
typedef const struct kfast_text_code kfast_text_code;
typedef const struct kfast_drawing_code kfast_drawing_code;
typedef const struct kfast_trim_code kfast_trim_code;
typedef const struct kfast_spring_code kfast_spring_code;
#endif

typedef enum kfast_error {
    KFAST_OK,
    KFAST_TRUNCATED,           /* the bytes end before the scene does */
    KFAST_BAD_MAGIC,           /* not a compiled scene */
    KFAST_UNSUPPORTED_VERSION, /* compiled for another version of the format */
    KFAST_BAD_CHECKSUM,        /* the bytes were damaged on the way */
    KFAST_BAD_SCENE,           /* a value in the scene is out of its range, or refers to nothing */
    KFAST_BLOCK_TOO_SMALL,     /* less memory was lent than the scene needs */
    KFAST_BUFFER_TOO_SMALL,    /* the buffer for pixels does not hold a row of the panel */
    KFAST_BAD_PANEL_SIZE,      /* a side of the panel is not 1 to 4096 pixels long */
    KFAST_NO_SUCH_CLIP,        /* the scene has no clip of this name */
    KFAST_NULL_POINTER,        /* a pointer is NULL: a player that was not made, memory that was not lent */
    KFAST_NO_SUCH_INPUT,       /* the scene has no input of this name and kind */
    KFAST_DRAWING_TOO_LARGE,   /* the input takes fewer strokes or points */
    KFAST_TOO_SLOW,            /* a picture of the scene takes longer than a second on a Pico */
    /* The scene needs a feature that is not among those of kfast_create_with, in their order. */
    KFAST_NEEDS_STROKES,
    KFAST_NEEDS_TWEENS,
    KFAST_NEEDS_BONES,
    KFAST_NEEDS_BACKBONES,
    KFAST_NEEDS_DEPTH,
    KFAST_NEEDS_WIRES,
    KFAST_NEEDS_PATHS,
    KFAST_NEEDS_SMOOTH,
    KFAST_NEEDS_TEXTS,
    KFAST_NEEDS_DRAWINGS,
    KFAST_NEEDS_TRIMS,
    KFAST_NEEDS_SPRINGS
} kfast_error;

/* The name of an error and what it means, for people. */
const char* kfast_error_text(kfast_error error);

/* A scene that plays: in the lent block, as long as that stays where it is. */
typedef struct kfast_player kfast_player;

/* Bytes that kfast_create() must be lent for a panel of this size, for every time of the scene. 0 if the
 * scene or the size is not valid; kfast_create() returns the reason. */
size_t kfast_block_bytes(const void* scene, size_t scene_bytes, int width, int height);

/* Makes a player for the scene that `kfast compile` or `kfast export` wrote, at its beginning. The scene and
 * the block must stay where they are as long as the player is used; there is nothing to give back. The block
 * need not be aligned. Unless the result is KFAST_OK, *player is NULL. */
kfast_error kfast_create(kfast_player** player, void* block, size_t block_bytes, const void* scene,
                         size_t scene_bytes, int width, int height);

/* The code of what only some scenes need. */
/* NOLINTBEGIN(readability-redundant-declaration): the core has them in C++ */
extern kfast_stroke_code kfast_strokes;     /* lines and outlines, drawn with a pen */
extern kfast_tween_code kfast_tweens;       /* drawings that change from key to key */
extern kfast_bone_code kfast_bones;         /* skeletons, and drawings that they carry */
extern kfast_backbone_code kfast_backbones; /* drawings that bend along a line */
extern kfast_depth_code kfast_depth;        /* rotate-x, rotate-y and z */
extern kfast_wire_code kfast_wires;         /* wire frames */
extern kfast_path_code kfast_paths;         /* items that follow a path */
extern kfast_smooth_code kfast_smooth;      /* tracks that go smoothly through their keys */
extern kfast_text_code kfast_texts;         /* texts among the inputs */
extern kfast_drawing_code kfast_drawings;   /* drawings among the inputs */
extern kfast_trim_code kfast_trims;         /* strokes that are drawn in part, or dashed */
extern kfast_spring_code kfast_springs;     /* velocity laws that spring or bounce */
/* NOLINTEND(readability-redundant-declaration) */

/* Which of them a program has; NULL is left out. `kfast export --header` writes what a scene needs:
 *
 *     static const kfast_features features = ROBOT_EYES_FEATURES; */
typedef struct kfast_features {
    kfast_stroke_code* strokes;
    kfast_tween_code* tweens;
    kfast_bone_code* bones;
    kfast_backbone_code* backbones;
    kfast_depth_code* depth;
    kfast_wire_code* wires;
    kfast_path_code* paths;
    kfast_smooth_code* smooth;
    kfast_text_code* texts;
    kfast_drawing_code* drawings;
    kfast_trim_code* trims;
    kfast_spring_code* springs;
} kfast_features;

/* As kfast_create(), with these features alone, which are copied: a linker that leaves out what nothing
 * refers to (-ffunction-sections -fdata-sections -Wl,--gc-sections) leaves out the others, if neither
 * kfast_create() nor kfast_block_bytes() is called anywhere. A scene that needs more is refused. */
kfast_error kfast_create_with(kfast_player** player, void* block, size_t block_bytes, const void* scene,
                              size_t scene_bytes, int width, int height, const kfast_features* features);

/* As kfast_block_bytes(), for kfast_create_with(); also 0 if the scene needs more. */
size_t kfast_block_bytes_with(const void* scene, size_t scene_bytes, int width, int height,
                              const kfast_features* features);

/* What times count from, and what kfast_update() plays: a clip of the scene, or with NULL the whole scene
 * again, as at first. If there is no such clip, nothing changes. */
kfast_error kfast_choose_clip(kfast_player* player, const char* name);

/* Times are in 1/1024 frame; KFAST_FRAME * 12 is the 13th frame. */
#define KFAST_FRAME INT32_C(1024)

/* Sets an input of the scene, such as where the eyes look, from the next kfast_show() or kfast_update() on:
 * to `value` in 1/1000 of what the scene counts it in (500 is 0.5), clamped to the input's range. At first
 * inputs have the default values that the scene gives them. If there is no such input, nothing changes. */
kfast_error kfast_set_input(kfast_player* player, const char* name, int32_t value);

/* Sets a text that is an input of the scene, in UTF-8, from the next kfast_show() or kfast_update() on.
 * Characters that the scene has no letters for are left out, and so are those beyond the maximum of the
 * input. At first a text is the default one. If there is no such input, nothing changes. */
kfast_error kfast_set_text(kfast_player* player, const char* name, const char* text);

/* A point of a drawing, in 1/16 pixel of the objects that show it; y points down. */
typedef struct kfast_point {
    int16_t x;
    int16_t y;
} kfast_point;

/* Sets a drawing among the inputs of the scene, such as a curve that is measured, from the next kfast_show()
 * or kfast_update() on: to as many strokes as `strokes`, of stroke_points[0], stroke_points[1], ... points,
 * which are one after another in `points`. A stroke is closed if it ends where it begins. All is copied. No
 * strokes are the empty drawing. If there is no such drawing, or if it takes fewer, nothing changes. */
kfast_error kfast_set_drawing(kfast_player* player, const char* name, const kfast_point* points,
                              const uint16_t* stroke_points, size_t strokes);

/* Computes the picture at this time. Any time is allowed: the loop of the scene or clip decides what it
 * represents. */
kfast_error kfast_show(kfast_player* player, int32_t time);

/* As kfast_show(), after that many milliseconds; rounded down to 1/1024 frame. */
kfast_error kfast_show_after(kfast_player* player, uint32_t milliseconds);

/* An event of the scene that is passed: the bytes of its name in UTF-8, with no 0 after them. */
typedef void (*kfast_event_passed)(const char* name, size_t bytes, void* user);

/* Plays by a clock of yours, one whole frame of the scene after another: computes the picture for when it
 * shows this many milliseconds, and reports the events that were passed since the call before (event_passed
 * may be NULL). The first call, and the first one after kfast_choose_clip(), is the beginning. The clock may
 * run over 2^32. Returns 1 if there is something to draw, 0 if the frame is the same and nothing was set. */
int kfast_update(kfast_player* player, uint32_t milliseconds, kfast_event_passed event_passed, void* user);

/* Whether what kfast_update() plays has reached its end, as a clip does that plays once: 1 or 0. */
int kfast_finished(const kfast_player* player);

/* Whether the picture is drawn with coarser curves, or not wholly, because the block has no room for all of
 * its outlines: 1 or 0. kfast info and kfast fit report it beforehand. */
int kfast_is_coarse(const kfast_player* player);

/* Takes the pixels of one rectangle: its rows from the top down, each of them starting on a byte. They are
 * gone after the call. */
typedef void (*kfast_draw_rectangle)(int x, int y, int width, int height, const void* pixels, void* user);

/* Hands out the rectangles in which the picture differs from what was drawn before, in any format; at
 * first, and after kfast_redraw(), that is the whole panel. Where pixels share bytes, rectangles begin and
 * end in columns that are multiples of 2 (rgb444, grey4) or 8 (mono1, mono1_dithered), or end with the panel:
 * the rest of the last byte of a row then means nothing.
 *
 * The buffer is where the pixels are drawn; the larger, the fewer the calls. KFAST_OK, or
 * KFAST_BUFFER_TOO_SMALL with nothing drawn: it must hold a row of the panel, and for rgb565 and rgb565_be a
 * byte more if it begins at an odd address, for their pixels are at even ones.
 *
 *     rgb565          2 bytes a pixel, little-endian, red in the highest 5 bits
 *     rgb565_be       the same with the high byte first, as LCDs on SPI take it
 *     rgb444          2 pixels in 3 bytes: red, green, blue in 4 bits each, the first in the high nibble
 *     rgb666          3 bytes a pixel: red, green, blue, each in the high 6 bits
 *     grey4           2 pixels a byte, the left one in the high nibble; 15 is white
 *     mono1           8 pixels a byte, the leftmost in the highest bit; 1 is lit, from half brightness on
 *     mono1_dithered  the same, but as many pixels are lit as the brightness says */
kfast_error kfast_draw_rgb565(kfast_player* player, void* buffer, size_t buffer_bytes,
                              kfast_draw_rectangle draw_rectangle, void* user);
kfast_error kfast_draw_rgb565_be(kfast_player* player, void* buffer, size_t buffer_bytes,
                                 kfast_draw_rectangle draw_rectangle, void* user);
kfast_error kfast_draw_rgb444(kfast_player* player, void* buffer, size_t buffer_bytes,
                              kfast_draw_rectangle draw_rectangle, void* user);
kfast_error kfast_draw_rgb666(kfast_player* player, void* buffer, size_t buffer_bytes,
                              kfast_draw_rectangle draw_rectangle, void* user);
kfast_error kfast_draw_grey4(kfast_player* player, void* buffer, size_t buffer_bytes,
                             kfast_draw_rectangle draw_rectangle, void* user);
kfast_error kfast_draw_mono1(kfast_player* player, void* buffer, size_t buffer_bytes,
                             kfast_draw_rectangle draw_rectangle, void* user);
kfast_error kfast_draw_mono1_dithered(kfast_player* player, void* buffer, size_t buffer_bytes,
                                      kfast_draw_rectangle draw_rectangle, void* user);

/* The display shows something else now: the next drawing hands out the whole panel. */
kfast_error kfast_redraw(kfast_player* player);

#ifdef __cplusplus
}
#endif

#endif
