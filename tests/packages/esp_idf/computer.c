/* Runs a program for ESP-IDF on a computer: writes the glass to its output after each of 20 steps of 0.1 s.
 * Pixels go out late, as by DMA: when the program waits for them. */
#include <driver/spi_master.h>
#include <esp_lcd_panel_ops.h>
#include <esp_lcd_panel_vendor.h>
#include <esp_timer.h>
#include <freertos/semphr.h>
#include <freertos/task.h>
#include <stdio.h>
#include <string.h>

enum { side = 240, steps = 20 };

void app_main(void);

static char glass[side][side][2];
static esp_lcd_panel_io_spi_config_t wires;
static struct {
    int x, y, x_end, y_end;
    const char* pixels; /* NULL: nothing is under way */
} transfer;
static int step = 0, given = 0;

static void finish_transfer(void)
{
    const size_t row_bytes = (size_t)(transfer.x_end - transfer.x) * 2;
    for (int row = transfer.y; row < transfer.y_end; ++row, transfer.pixels += row_bytes)
        memcpy(glass[row][transfer.x], transfer.pixels, row_bytes);
    transfer.pixels = NULL;
    wires.on_color_trans_done(NULL, NULL, wires.user_ctx);
}

esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x, int y, int x_end, int y_end,
                                    const void* pixels)
{
    (void)panel;
    if (transfer.pixels != NULL)
        return 1; /* the buffer was drawn over already */
    transfer.x = x, transfer.y = y, transfer.x_end = x_end, transfer.y_end = y_end, transfer.pixels = pixels;
    return ESP_OK;
}

SemaphoreHandle_t xSemaphoreCreateBinary(void) { return NULL; }

BaseType_t xSemaphoreTake(SemaphoreHandle_t semaphore, TickType_t ticks)
{
    (void)semaphore, (void)ticks;
    if (transfer.pixels != NULL)
        finish_transfer();
    return given-- > 0 ? pdTRUE : pdFALSE;
}

BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t semaphore, BaseType_t* woken)
{
    (void)semaphore;
    *woken = pdTRUE;
    ++given;
    return pdTRUE;
}

int64_t esp_timer_get_time(void) { return 7000 + INT64_C(100000) * step; }

void vTaskDelay(TickType_t ticks)
{
    (void)ticks;
    fwrite(glass, sizeof glass, 1, stdout);
    if (++step == steps)
        exit(transfer.pixels != NULL);
}

esp_err_t spi_bus_initialize(spi_host_device_t host, const spi_bus_config_t* bus, int dma)
{
    (void)host, (void)bus, (void)dma;
    return ESP_OK;
}

esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus, const esp_lcd_panel_io_spi_config_t* config,
                                   esp_lcd_panel_io_handle_t* io)
{
    (void)bus;
    wires = *config;
    *io = NULL;
    return ESP_OK;
}

esp_err_t esp_lcd_new_panel_st7789(esp_lcd_panel_io_handle_t io, const esp_lcd_panel_dev_config_t* device,
                                   esp_lcd_panel_handle_t* panel)
{
    (void)io, (void)device;
    *panel = NULL;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_reset(esp_lcd_panel_handle_t panel)
{
    (void)panel;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_init(esp_lcd_panel_handle_t panel)
{
    (void)panel;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_invert_color(esp_lcd_panel_handle_t panel, bool inverted)
{
    (void)panel, (void)inverted;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_disp_on_off(esp_lcd_panel_handle_t panel, bool on)
{
    (void)panel, (void)on;
    return ESP_OK;
}

int main(void)
{
    app_main();
    return 1; /* it never returns */
}
