/* Robot eyes on an ST7789 of 240 x 240 pixels that esp_lcd drives by SPI. */
#include "robot_eyes.h" /* kfast export --header robot-eyes.kfast -o robot_eyes.h */

#include <driver/spi_master.h>
#include <esp_lcd_panel_io.h>
#include <esp_lcd_panel_ops.h>
#include <esp_lcd_panel_vendor.h>
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/semphr.h>
#include <freertos/task.h>
#include <kfast.h>
#include <stdint.h>
#include <stdio.h>

enum { clock_pin = 18, data_pin = 23, select_pin = 5, command_pin = 16, reset_pin = 17 };
enum { width = robot_eyes_width, height = robot_eyes_height, buffer_bytes = 24 * width * 2 };

static SemaphoreHandle_t sent; /* the pixels are on the display */

static bool notify_sent(esp_lcd_panel_io_handle_t io, esp_lcd_panel_io_event_data_t* event, void* user)
{
    BaseType_t woken = pdFALSE;
    (void)io, (void)event, (void)user;
    xSemaphoreGiveFromISR(sent, &woken);
    return woken == pdTRUE;
}

static esp_lcd_panel_handle_t started_panel(void)
{
    const spi_bus_config_t bus = {.mosi_io_num = data_pin,
                                  .miso_io_num = -1,
                                  .sclk_io_num = clock_pin,
                                  .quadwp_io_num = -1,
                                  .quadhd_io_num = -1,
                                  .max_transfer_sz = buffer_bytes};
    const esp_lcd_panel_io_spi_config_t wires = {.cs_gpio_num = select_pin,
                                                 .dc_gpio_num = command_pin,
                                                 .pclk_hz = 40 * 1000 * 1000,
                                                 .trans_queue_depth = 1,
                                                 .on_color_trans_done = notify_sent,
                                                 .lcd_cmd_bits = 8,
                                                 .lcd_param_bits = 8};
    const esp_lcd_panel_dev_config_t device = {.reset_gpio_num = reset_pin, .bits_per_pixel = 16};
    esp_lcd_panel_io_handle_t io;
    esp_lcd_panel_handle_t panel;
    ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO));
    ESP_ERROR_CHECK(esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)SPI2_HOST, &wires, &io));
    ESP_ERROR_CHECK(esp_lcd_new_panel_st7789(io, &device, &panel));
    ESP_ERROR_CHECK(esp_lcd_panel_reset(panel));
    ESP_ERROR_CHECK(esp_lcd_panel_init(panel));
    ESP_ERROR_CHECK(esp_lcd_panel_invert_color(panel, true));
    ESP_ERROR_CHECK(esp_lcd_panel_disp_on_off(panel, true));
    return panel;
}

/* esp_lcd sends pixels while the program runs on, but they are drawn over after this call: so it waits. */
static void draw_rectangle(int x, int y, int columns, int rows, const void* pixels, void* panel)
{
    ESP_ERROR_CHECK(esp_lcd_panel_draw_bitmap(panel, x, y, x + columns, y + rows, pixels));
    xSemaphoreTake(sent, portMAX_DELAY);
}

void app_main(void)
{
    static char block[robot_eyes_block_bytes];
    static uint16_t buffer[buffer_bytes / 2];
    static const kfast_features features = ROBOT_EYES_FEATURES;
    kfast_player* player;
    sent = xSemaphoreCreateBinary();
    const esp_lcd_panel_handle_t panel = started_panel();
    const kfast_error error = kfast_create_with(&player, block, sizeof block, robot_eyes, robot_eyes_bytes,
                                                width, height, &features);
    if (error != KFAST_OK)
        printf("robot_eyes: %s\n", kfast_error_text(error));
    while (error == KFAST_OK) {
        if (kfast_update(player, (uint32_t)(esp_timer_get_time() / 1000), NULL, NULL))
            kfast_draw_rgb565_be(player, buffer, sizeof buffer, draw_rectangle, panel);
        vTaskDelay(1);
    }
}
