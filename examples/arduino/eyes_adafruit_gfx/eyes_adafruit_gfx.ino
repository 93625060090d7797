// Robot eyes on a display that a library on Adafruit_GFX drives: an ST7789 of 240 x 240 pixels. An event of
// the scene is told.
#include "robot_eyes.h" // kfast export --header robot-eyes.kfast -o robot_eyes.h

#include <Adafruit_GFX.h>
#include <Adafruit_ST7789.h>
#include <SPI.h>
#include <kfast_player.hpp>

const int select_pin = 5, command_pin = 16, reset_pin = 17; // change them to yours

Adafruit_ST7789 tft(select_pin, command_pin, reset_pin);
static const kfast_features features = ROBOT_EYES_FEATURES; // of the player only what they need
KfastPlayer<robot_eyes_block_bytes> player;
uint16_t pixels[8 * robot_eyes_width];

#ifdef SET_LOOP_TASK_STACK_SIZE
SET_LOOP_TASK_STACK_SIZE(16 * 1024); // on an ESP32: its usual 8 KB are too few for some scenes
#endif

void draw_rectangle(int x, int y, int width, int height, uint16_t* pixels)
{
    tft.drawRGBBitmap(x, y, pixels, width, height);
}

void event_passed(KfastEvent event)
{
    if (event == "blinked")
        Serial.println("blinked");
}

void setup()
{
    Serial.begin(115200);
    tft.init(robot_eyes_width, robot_eyes_height);
    if (!player.begin(robot_eyes, robot_eyes_width, robot_eyes_height, features))
        Serial.println(player.error());
}

void loop()
{
    if (player.update(millis(), event_passed))
        player.draw(pixels, draw_rectangle);
}
