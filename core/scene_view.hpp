#pragma once

#include "core/colour.hpp"
#include "core/kfb_limits.hpp"
#include "core/object_view.hpp"
#include "core/result.hpp"
#include "core/size.hpp"
#include "core/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A checked, borrowed look at the bytes of a compiled scene (docs/format.md).
///
/// Everything that can be wrong with the bytes is found by parse(). Every other member is total: it cannot
/// fail and does not look twice.
class SceneView {
public:
    /// `bytes` must outlive the view; more bytes than the scene has are ignored.
    /// Fails with truncated, bad_magic, unsupported_version, bad_checksum or bad_scene.
    static Result<SceneView> parse(std::span<const std::byte> bytes);

    /// The bytes of the scene itself.
    std::size_t size() const { return size_; }
    Size canvas() const { return canvas_; }
    /// Frames in 1000 seconds: 30 fps is 30000.
    std::uint32_t frame_rate() const { return frame_rate_; }
    /// At least one frame.
    Time length() const { return length_; }
    Loop loop() const { return loop_; }
    /// The most edges that any moment of the scene needs.
    std::uint32_t max_edges() const { return max_edges_; }
    /// Fills and strokes of all objects.
    std::uint32_t layers() const { return layers_; }
    std::uint32_t object_count() const { return object_count_; }

    /// `index` is less than palette_size(); 0 is the background.
    Colour colour(std::size_t index) const;
    std::size_t palette_size() const { return palette_.size() / 3; }
    ObjectCursor objects() const { return {ByteReader{objects_}, object_count_}; }
    PackedDrawing drawing(const Key& key) const { return drawing_at(drawings_, key); }

private:
    SceneView() = default;

    bool read_sections(std::span<const std::byte> bytes);
    bool check_header() const;
    bool check_objects();
    bool check_style(const ObjectStyle& style) const;
    bool check_keys(const ObjectView& object, std::uint32_t& key_points);
    bool check_drawing(const Key& key, std::uint32_t& key_points) const;

    std::size_t size_ = 0;
    Size canvas_;
    std::uint32_t frame_rate_ = 0;
    Time length_;
    Loop loop_ = Loop::repeat;
    std::uint32_t max_edges_ = 0;
    std::uint32_t layers_ = 0;
    std::uint32_t object_count_ = 0;
    std::span<const std::byte> palette_;
    std::span<const std::byte> objects_;
    std::span<const std::byte> drawings_;
};

}
