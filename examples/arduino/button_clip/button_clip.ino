// Eyes that blink when a button is pressed, which connects its pin to ground; then they go on with all of
// the scene.
#include "robot_eyes.h" // kfast export --header robot-eyes.kfast -o robot_eyes.h

#include <SPI.h>
#include <TFT_eSPI.h>
#include <kfast_player.hpp>

const int button_pin = 14;

TFT_eSPI tft;
static const kfast_features features = ROBOT_EYES_FEATURES; // of the player only what they need
KfastPlayer<robot_eyes_block_bytes> player;
uint16_t pixels[16 * robot_eyes_width];
bool was_pressed = false;

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
    pinMode(button_pin, INPUT_PULLUP);
    tft.init();
    tft.setSwapBytes(true);
    if (!player.begin(robot_eyes, robot_eyes_width, robot_eyes_height, features))
        Serial.println(player.error());
}

void loop()
{
    const bool is_pressed = digitalRead(button_pin) == LOW;
    if (is_pressed && !was_pressed)
        player.play("blink");
    else if (player.finished())
        player.play();
    was_pressed = is_pressed;
    if (player.update(millis()))
        player.draw(pixels, draw_rectangle);
}
