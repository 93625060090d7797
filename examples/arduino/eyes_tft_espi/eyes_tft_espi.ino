// Robot eyes on a display that TFT_eSPI drives, of 240 x 240 pixels.
#include "robot_eyes.h" // kfast export --header robot-eyes.kfast -o robot_eyes.h

#include <SPI.h>
#include <TFT_eSPI.h> // its User_Setup.h names your display and its pins
#include <kfast_player.hpp>

TFT_eSPI tft;
static const kfast_features features = ROBOT_EYES_FEATURES; // of the player only what they need
KfastPlayer<robot_eyes_block_bytes> player;
uint16_t pixels[16 * robot_eyes_width]; // the more rows, the fewer and larger the rectangles

#ifdef SET_LOOP_TASK_STACK_SIZE
SET_LOOP_TASK_STACK_SIZE(16 * 1024); // on an ESP32: its usual 8 KB are too few for some scenes
#endif

void draw_rectangle(int x, int y, int width, int height, uint16_t* pixels)
{
    tft.pushImage(x, y, width, height, pixels);
}

void setup()
{
    Serial.begin(115200);
    tft.init();
    // Pixels lie in memory as this processor has them; the display wants the high byte first.
    tft.setSwapBytes(true);
    if (!player.begin(robot_eyes, robot_eyes_width, robot_eyes_height, features))
        Serial.println(player.error());
}

void loop()
{
    if (player.update(millis()))
        player.draw(pixels, draw_rectangle);
}
