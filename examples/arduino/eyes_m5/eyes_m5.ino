// Robot eyes on a board of M5Stack, in the left upper corner of its display. LovyanGFX takes pixels in the
// same way.
#include "robot_eyes.h" // kfast export --header robot-eyes.kfast -o robot_eyes.h

#include <M5Unified.h>
#include <kfast_player.hpp>

static const kfast_features features = ROBOT_EYES_FEATURES; // of the player only what they need
KfastPlayer<robot_eyes_block_bytes> player;
uint16_t pixels[16 * robot_eyes_width];

#ifdef SET_LOOP_TASK_STACK_SIZE
SET_LOOP_TASK_STACK_SIZE(16 * 1024); // on an ESP32: its usual 8 KB are too few for some scenes
#endif

void draw_rectangle(int x, int y, int width, int height, uint16_t* pixels)
{
    M5.Display.pushImage(x, y, width, height, reinterpret_cast<const lgfx::rgb565_t*>(pixels));
}

void setup()
{
    Serial.begin(115200);
    M5.begin();
    if (!player.begin(robot_eyes, robot_eyes_width, robot_eyes_height, features))
        Serial.println(player.error());
}

void loop()
{
    if (player.update(millis()))
        player.draw(pixels, draw_rectangle);
}
