#include "library/kfast.h"

#include "core/bytes/result.hpp"
#include "library/kfast.hpp"
#include "library/playback.hpp"

#include <array>
#include <new>
#include <type_traits>

struct kfast_player {
    kfast::Playback playback;
};

// The caller takes back the block without asking.
static_assert(std::is_trivially_destructible_v<kfast_player>);

namespace {

using kfast::Animation, kfast::Error, kfast::EventView, kfast::PixelFormat, kfast::Player, kfast::Rect,
    kfast::SceneView, kfast::Size;

constexpr kfast_error code_of(Error error)
{
    switch (error) {
    case Error::truncated:
        return KFAST_TRUNCATED;
    case Error::bad_magic:
        return KFAST_BAD_MAGIC;
    case Error::unsupported_version:
        return KFAST_UNSUPPORTED_VERSION;
    case Error::bad_checksum:
        return KFAST_BAD_CHECKSUM;
    case Error::bad_scene:
        return KFAST_BAD_SCENE;
    case Error::block_too_small:
        return KFAST_BLOCK_TOO_SMALL;
    case Error::too_slow:
        return KFAST_TOO_SLOW;
    case Error::needs_strokes:
        return KFAST_NEEDS_STROKES;
    case Error::needs_tweens:
        return KFAST_NEEDS_TWEENS;
    case Error::needs_bones:
        return KFAST_NEEDS_BONES;
    case Error::needs_backbones:
        return KFAST_NEEDS_BACKBONES;
    case Error::needs_depth:
        return KFAST_NEEDS_DEPTH;
    case Error::needs_wires:
        return KFAST_NEEDS_WIRES;
    case Error::needs_paths:
        return KFAST_NEEDS_PATHS;
    case Error::needs_smooth:
        return KFAST_NEEDS_SMOOTH;
    case Error::needs_texts:
        return KFAST_NEEDS_TEXTS;
    case Error::needs_drawings:
        return KFAST_NEEDS_DRAWINGS;
    case Error::needs_trims:
        return KFAST_NEEDS_TRIMS;
    case Error::needs_springs:
        return KFAST_NEEDS_SPRINGS;
    }
    return KFAST_BAD_SCENE;
}

kfast::Features features_of(const kfast_features& features)
{
    return {.strokes = features.strokes,
            .tweens = features.tweens,
            .bones = features.bones,
            .backbones = features.backbones,
            .depth = features.depth,
            .wires = features.wires,
            .paths = features.paths,
            .smooth = features.smooth,
            .texts = features.texts,
            .drawings = features.drawings,
            .trims = features.trims,
            .springs = features.springs};
}

/// In the order of kfast_error.
constexpr std::array error_texts{
    "ok",
    error_text(Error::truncated).data(),
    error_text(Error::bad_magic).data(),
    error_text(Error::unsupported_version).data(),
    error_text(Error::bad_checksum).data(),
    error_text(Error::bad_scene).data(),
    error_text(Error::block_too_small).data(),
    "buffer_too_small: the buffer does not hold a row of the panel",
    "bad_panel_size: a side of the panel is not 1 to 4096 pixels long",
    "no_such_clip: the scene has no clip of this name",
    "null_pointer: a pointer is NULL",
    "no_such_input: the scene has no input of this name and kind",
    "drawing_too_large: the input takes fewer strokes or points",
    error_text(Error::too_slow).data(),
    error_text(Error::needs_strokes).data(),
    error_text(Error::needs_tweens).data(),
    error_text(Error::needs_bones).data(),
    error_text(Error::needs_backbones).data(),
    error_text(Error::needs_depth).data(),
    error_text(Error::needs_wires).data(),
    error_text(Error::needs_paths).data(),
    error_text(Error::needs_smooth).data(),
    error_text(Error::needs_texts).data(),
    error_text(Error::needs_drawings).data(),
    error_text(Error::needs_trims).data(),
    error_text(Error::needs_springs).data(),
};
static_assert(error_texts.size() == KFAST_NEEDS_SPRINGS + 1 && code_of(Error::block_too_small) == 6);

/// The maximum of bytes of the block before the player: its alignment is not known before.
constexpr std::size_t widest_gap = alignof(kfast_player) - 1;

/// Where a player may be, and what is left for its animation; nothing if there is not that much.
struct Room {
    void* player = nullptr;
    std::span<std::byte> rest;

    Room(void* block, std::size_t bytes)
    {
        const std::size_t gap = -reinterpret_cast<std::uintptr_t>(block) % alignof(kfast_player);
        if (bytes < gap + sizeof(kfast_player))
            return;
        const auto aligned = std::span{static_cast<std::byte*>(block), bytes}.subspan(gap);
        player = aligned.data();
        rest = aligned.subspan(sizeof(kfast_player));
    }
};

std::span<const std::byte> bytes_of(const void* scene, std::size_t bytes)
{
    return {static_cast<const std::byte*>(scene), bytes};
}

bool is_panel(Size size)
{
    const auto is_side = [](int length) { return length >= 1 && length <= Player::max_panel; };
    return is_side(size.width) && is_side(size.height);
}

std::size_t block_bytes_for(const void* scene, std::size_t bytes, Size panel, const kfast::Features& features)
{
    if (scene == nullptr || !is_panel(panel))
        return 0;
    const auto block = Animation::block_bytes(bytes_of(scene, bytes), panel, features);
    return block ? widest_gap + sizeof(kfast_player) + *block : 0;
}

/// As kfast_create_with(), where no pointer is null.
kfast_error create_in(const Room& room, std::span<const std::byte> scene, Size panel,
                      const kfast::Features& features, kfast_player*& player)
{
    if (!is_panel(panel))
        return KFAST_BAD_PANEL_SIZE;
    const auto view = SceneView::parse(scene, features);
    if (!view)
        return code_of(view.error());
    if (room.rest.size() < Player::block_bytes(*view, panel))
        return KFAST_BLOCK_TOO_SMALL;
    player = new (room.player) kfast_player{kfast::Playback{*view, panel, room.rest}};
    return KFAST_OK;
}

/// Returns whether there was room for all of it.
bool set_strokes(kfast::InputDrawing drawing, const kfast_point* points,
                 std::span<const std::uint16_t> strokes)
{
    drawing.begin();
    for (const std::uint16_t count : strokes) {
        drawing.begin_stroke();
        for (const kfast_point point : std::span{points, count})
            if (!drawing.add({point.x, point.y})) {
                drawing.begin();
                return false;
            }
        points += count;
    }
    return true;
}

template <PixelFormat format>
kfast_error draw(kfast_player* player, void* buffer, std::size_t bytes, kfast_draw_rectangle draw_rectangle,
                 void* user)
{
    if (player == nullptr || buffer == nullptr || draw_rectangle == nullptr)
        return KFAST_NULL_POINTER;
    const auto hand_out = [=](Rect area, std::span<const std::byte> pixels) {
        draw_rectangle(area.x, area.y, area.width, area.height, pixels.data(), user);
    };
    const std::span room{static_cast<std::byte*>(buffer), bytes};
    return player->playback.draw<format>(room, hand_out) ? KFAST_OK : KFAST_BUFFER_TOO_SMALL;
}

}

const char* kfast_error_text(kfast_error error)
{
    const auto place = static_cast<std::size_t>(error);
    return place < error_texts.size() ? error_texts[place] : "unknown";
}

size_t kfast_block_bytes(const void* scene, size_t scene_bytes, int width, int height)
{
    return block_bytes_for(scene, scene_bytes, {width, height}, kfast::every_feature);
}

size_t kfast_block_bytes_with(const void* scene, size_t scene_bytes, int width, int height,
                              const kfast_features* features)
{
    return features == nullptr ? 0
                               : block_bytes_for(scene, scene_bytes, {width, height}, features_of(*features));
}

kfast_error kfast_create(kfast_player** player, void* block, size_t block_bytes, const void* scene,
                         size_t scene_bytes, int width, int height)
{
    if (player == nullptr)
        return KFAST_NULL_POINTER;
    *player = nullptr;
    if (block == nullptr || scene == nullptr)
        return KFAST_NULL_POINTER;
    return create_in({block, block_bytes}, bytes_of(scene, scene_bytes), {width, height},
                     kfast::every_feature, *player);
}

kfast_error kfast_create_with(kfast_player** player, void* block, size_t block_bytes, const void* scene,
                              size_t scene_bytes, int width, int height, const kfast_features* features)
{
    if (player == nullptr)
        return KFAST_NULL_POINTER;
    *player = nullptr;
    if (block == nullptr || scene == nullptr || features == nullptr)
        return KFAST_NULL_POINTER;
    return create_in({block, block_bytes}, bytes_of(scene, scene_bytes), {width, height},
                     features_of(*features), *player);
}

kfast_error kfast_choose_clip(kfast_player* player, const char* name)
{
    if (player == nullptr)
        return KFAST_NULL_POINTER;
    if (name != nullptr)
        return player->playback.choose_clip(name) ? KFAST_OK : KFAST_NO_SUCH_CLIP;
    player->playback.choose_scene();
    return KFAST_OK;
}

kfast_error kfast_set_input(kfast_player* player, const char* name, int32_t value)
{
    if (player == nullptr || name == nullptr)
        return KFAST_NULL_POINTER;
    return player->playback.change().set_input(name, value) ? KFAST_OK : KFAST_NO_SUCH_INPUT;
}

kfast_error kfast_set_text(kfast_player* player, const char* name, const char* text)
{
    if (player == nullptr || name == nullptr || text == nullptr)
        return KFAST_NULL_POINTER;
    return player->playback.change().set_text(name, text) ? KFAST_OK : KFAST_NO_SUCH_INPUT;
}

kfast_error kfast_set_drawing(kfast_player* player, const char* name, const kfast_point* points,
                              const uint16_t* stroke_points, size_t strokes)
{
    const bool has_strokes = points != nullptr && stroke_points != nullptr;
    if (player == nullptr || name == nullptr || (strokes != 0 && !has_strokes))
        return KFAST_NULL_POINTER;
    const auto drawing = player->playback.change().drawing(name);
    if (!drawing)
        return KFAST_NO_SUCH_INPUT;
    if (!set_strokes(*drawing, points, {stroke_points, strokes}))
        return KFAST_DRAWING_TOO_LARGE;
    player->playback.change().show_next_drawing(name);
    return KFAST_OK;
}

kfast_error kfast_show(kfast_player* player, int32_t time)
{
    if (player == nullptr)
        return KFAST_NULL_POINTER;
    player->playback.change().show({time});
    return KFAST_OK;
}

kfast_error kfast_show_after(kfast_player* player, uint32_t milliseconds)
{
    if (player == nullptr)
        return KFAST_NULL_POINTER;
    player->playback.change().show_after(milliseconds);
    return KFAST_OK;
}

int kfast_update(kfast_player* player, uint32_t milliseconds, kfast_event_passed event_passed, void* user)
{
    if (player == nullptr)
        return 0;
    return player->playback.update(milliseconds, [=](const EventView& event) {
        if (event_passed != nullptr)
            event_passed(event.name.data(), event.name.size(), user);
    });
}

int kfast_finished(const kfast_player* player) { return player != nullptr && player->playback.finished(); }

int kfast_is_coarse(const kfast_player* player)
{
    return player != nullptr && player->playback.animation().is_coarse();
}

kfast_error kfast_draw_rgb565(kfast_player* player, void* buffer, size_t buffer_bytes,
                              kfast_draw_rectangle draw_rectangle, void* user)
{
    return draw<PixelFormat::rgb565>(player, buffer, buffer_bytes, draw_rectangle, user);
}

kfast_error kfast_draw_rgb565_be(kfast_player* player, void* buffer, size_t buffer_bytes,
                                 kfast_draw_rectangle draw_rectangle, void* user)
{
    return draw<PixelFormat::rgb565_be>(player, buffer, buffer_bytes, draw_rectangle, user);
}

kfast_error kfast_draw_rgb444(kfast_player* player, void* buffer, size_t buffer_bytes,
                              kfast_draw_rectangle draw_rectangle, void* user)
{
    return draw<PixelFormat::rgb444>(player, buffer, buffer_bytes, draw_rectangle, user);
}

kfast_error kfast_draw_rgb666(kfast_player* player, void* buffer, size_t buffer_bytes,
                              kfast_draw_rectangle draw_rectangle, void* user)
{
    return draw<PixelFormat::rgb666>(player, buffer, buffer_bytes, draw_rectangle, user);
}

kfast_error kfast_draw_grey4(kfast_player* player, void* buffer, size_t buffer_bytes,
                             kfast_draw_rectangle draw_rectangle, void* user)
{
    return draw<PixelFormat::grey4>(player, buffer, buffer_bytes, draw_rectangle, user);
}

kfast_error kfast_draw_mono1(kfast_player* player, void* buffer, size_t buffer_bytes,
                             kfast_draw_rectangle draw_rectangle, void* user)
{
    return draw<PixelFormat::mono1>(player, buffer, buffer_bytes, draw_rectangle, user);
}

kfast_error kfast_draw_mono1_dithered(kfast_player* player, void* buffer, size_t buffer_bytes,
                                      kfast_draw_rectangle draw_rectangle, void* user)
{
    return draw<PixelFormat::mono1_dithered>(player, buffer, buffer_bytes, draw_rectangle, user);
}

kfast_error kfast_redraw(kfast_player* player)
{
    if (player == nullptr)
        return KFAST_NULL_POINTER;
    player->playback.change().redraw();
    return KFAST_OK;
}
