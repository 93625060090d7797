#pragma once

#include "core/pose/scene_state.hpp"
#include "core/scene/scene_view.hpp"
#include "host/player/received_drawing.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast::fit {

/// How drawings go up and down between top and bottom.
enum class Bustle : std::uint8_t {
    waves, ///< one for every eight points, of random height: a lively plot
    noise, ///< at every point: hardly anything is harder to draw
};

/// A drawing that may come to the input `number` of the scene: all the points that it takes, in as many
/// strokes, from the left to the right of its default drawing, or of the canvas where that has no extent.
/// A different one for each `frame`, always the same.
ReceivedDrawing busy_drawing(const SceneView& scene, std::uint32_t number, Bustle bustle, int frame);

/// Sets a player's inputs to the worst case.
class BusyInputs {
public:
    /// Frames in which the slowest input goes there and back.
    static constexpr int turn = 64;

    /// `player` has the default inputs, and must outlive it.
    explicit BusyInputs(SceneState& player);

    /// Numbers go there and back, each faster than the one before; drawings wave (Bustle::waves); texts
    /// change with every frame, from as many of the character with most points as there may be to as many of
    /// the next one.
    void put(int frame);
    /// Sets all numbers to `place`.
    void put_all(Time place);
    /// Sets all drawings to noise.
    void put_noise(int frame);
    void put_default();

private:
    /// The values of a text of the scene, alternately.
    struct LongText {
        std::uint32_t input;
        std::array<std::string, 2> texts;
        std::string default_text;
    };

    static std::vector<LongText> long_texts(const SceneView& scene);

    bool is(InputType type, std::uint32_t input) const { return player_.scene().input(input).type == type; }
    bool is_drawing(std::uint32_t input) const { return is(InputType::drawing, input); }
    bool is_number(std::uint32_t input) const { return is(InputType::number, input); }
    void put_drawing(std::uint32_t input, Bustle bustle, int frame);
    void put_texts(int frame);

    SceneState& player_;
    std::vector<LongText> texts_;
    std::vector<ReceivedDrawing> default_drawings_; ///< of each input; empty for numbers
};

}
