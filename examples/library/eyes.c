/* Plays two seconds of robot eyes on a display, which here is an array: eyes >frames.rgb565 */
#include "robot_eyes.h" /* kfast export --header ../robot-eyes.kfast -o robot_eyes.h */

#include <kfast.h>
#include <stdio.h>
#include <string.h>

enum { width = robot_eyes_width, height = robot_eyes_height };

static uint16_t display[height][width];
static const kfast_features features = ROBOT_EYES_FEATURES;

static void draw_rectangle(int x, int y, int columns, int rows, const void* pixels, void* user)
{
    const size_t row_bytes = (size_t)columns * sizeof(uint16_t);
    const char* row = pixels;
    (void)user;
    for (; rows > 0; --rows, ++y, row += row_bytes)
        memcpy(&display[y][x], row, row_bytes);
}

int main(void)
{
    static char block[robot_eyes_block_bytes], buffer[16 * sizeof display[0]];
    kfast_player* player;
    const kfast_error error = kfast_create_with(&player, block, sizeof block, robot_eyes, robot_eyes_bytes,
                                                width, height, &features);
    if (error != KFAST_OK)
        return fprintf(stderr, "eyes: %s\n", kfast_error_text(error)), 1;
    for (int frame = 0; frame < 60; ++frame) {
        kfast_show(player, frame * KFAST_FRAME);
        kfast_draw_rgb565(player, buffer, sizeof buffer, draw_rectangle, NULL);
        fwrite(display, sizeof display, 1, stdout);
    }
    return 0;
}
