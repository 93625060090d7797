#include "host/fit/other_hardware.hpp"

#include "host/fit/display.hpp"
#include "host/picture/panel_choice.hpp"

namespace kfast::fit {

namespace {

// For boards that can be described: which costs the estimate has.
constexpr std::string_view measured = "the costs are those of its core";
constexpr std::string_view foreign = "memory is right, but speed is a guess, for it has other instructions: "
                                     "change cycles= until the milliseconds are "
                                     "those that you measure (docs/fit.md)";

// For others: the end of the sentence that begins with what it is.
constexpr std::string_view too_small = "has 8 bits and a few KiB of memory, and the player takes about 60 "
                                       "KiB of flash and 20 KiB of RAM: take a board "
                                       "of 32 bits, such as a Pico";
constexpr std::string_view same_as_pico = "has the chip of the Pico: take pico";
constexpr std::string_view linux_board =
    "runs kfast itself, with a display at its pins: kfast panel (docs/raspberry-pi.md)";

constexpr std::string_view wide_spi = "(MHz)40";

/// For estimates to begin with. Clocks of processors and memory are those of the pages that are given beside
/// them; RAM is that which a program has in one piece, also where the chip has more. The clocks of SPI are
/// only plausible, except for 40 MHz of an ESP32 (https://esp32.com/viewtopic.php?p=5483) and 32 MHz of
/// an nRF52840 (https://github.com/adafruit/Adafruit_nRF52_Arduino/pull/360). None of these boards has been
/// tried.
constexpr std::array boards{
    // https://docs.zephyrproject.org/4.1.0/boards/raspberrypi/rpi_pico2/doc/index.html
    OtherBoard{
        {"pico2 pico2w rp2350 rp2350a rp2350b raspberrypipico2", "a Pico 2 (RP2350, Cortex-M33)", measured},
        "cortex-m33 clock=(MHz)150",
        "flash=(MiB)4 ram=(KiB)520",
        "(MHz)37.5"},
    OtherBoard{{"picow picoh picowh rp2040 raspberrypipico xiaorp2040 rp2040zero", "a board with an RP2040",
                same_as_pico}},
    // https://github.com/platformio/platformio-docs/blob/develop/boards/espressif32/esp32dev.rst
    // https://docs.espressif.com/projects/esp-idf/en/latest/api-guides/memory-types.html
    OtherBoard{{"esp32 esp32wroom esp32wrover esp32dev", "an ESP32 (Xtensa LX6)", foreign},
               "cortex-m4 clock=(MHz)240 cycles=2",
               "flash=(MiB)4 ram=(KiB)320",
               wide_spi},
    // https://www.espressif.com/sites/default/files/documentation/
    // esp32-s2-wroom_esp32-s2-wroom-i_datasheet_en.pdf
    OtherBoard{{"esp32s2", "an ESP32-S2 (Xtensa LX7)", foreign},
               "cortex-m4 clock=(MHz)240 cycles=2",
               "flash=(MiB)4 ram=(KiB)320",
               wide_spi},
    // https://docs.zephyrproject.org/boards/adafruit/qt_py_esp32s3/doc/index.html
    // https://github.com/platformio/platformio-docs/blob/develop/boards/espressif32/esp32-s3-devkitc-1.rst
    OtherBoard{{"esp32s3 xiaoesp32s3 nanoesp32", "an ESP32-S3 (Xtensa LX7)", foreign},
               "cortex-m4 clock=(MHz)240 cycles=2",
               "flash=(MiB)8 ram=(KiB)320",
               wide_spi},
    // https://github.com/platformio/platformio-docs/blob/develop/boards/espressif32/esp32-c3-devkitm-1.rst
    OtherBoard{{"esp32c3 xiaoesp32c3", "an ESP32-C3 (RISC-V)", foreign},
               "cortex-m4 clock=(MHz)160 cycles=2",
               "flash=(MiB)4 ram=(KiB)320",
               wide_spi},
    // https://docs.platformio.org/en/stable/boards/espressif32/esp32-c6-devkitc-1.html
    OtherBoard{{"esp32c6", "an ESP32-C6 (RISC-V)", foreign},
               "cortex-m4 clock=(MHz)160 cycles=2",
               "flash=(MiB)8 ram=(KiB)320",
               wide_spi},
    // https://docs.platformio.org/en/latest/frameworks/esp8266-nonos-sdk.html
    OtherBoard{{"esp8266 nodemcu wemosd1 d1mini", "an ESP8266 (Xtensa L106)", foreign},
               "cortex-m4 clock=(MHz)80 cycles=2",
               "flash=(MiB)4 ram=(KiB)80",
               wide_spi},
    OtherBoard{{"arduino arduinouno uno unor3 arduinonano nano arduinomega mega mega2560 leonardo promini "
                "avr atmega328 "
                "atmega328p atmega2560 atmega32u4 attiny attiny85",
                "an Arduino with an AVR", too_small}},
    // https://docs.zephyrproject.org/boards/arduino/uno_r4/doc/index.html
    OtherBoard{{"unor4 arduinounor4 ra4m1", "an Arduino Uno R4 (RA4M1, Cortex-M4)", measured},
               "cortex-m4 clock=(MHz)48",
               "flash=(KiB)256 ram=(KiB)32",
               "(MHz)24"},
    // https://docs.zephyrproject.org/latest/boards/sparkfun/samd21_dev_breakout/doc/index.html
    OtherBoard{
        {"samd21 arduinozero zero mkrzero xiao featherm0 trinketm0", "a SAMD21 (Cortex-M0+)", measured},
        "cortex-m0+ clock=(MHz)48",
        "flash=(KiB)256 ram=(KiB)32",
        "(MHz)12"},
    // https://github.com/adafruit/Adafruit-ItsyBitsy-M4-Express-PCB
    OtherBoard{{"samd51 featherm4 itsybitsym4", "a SAMD51 (Cortex-M4)", measured},
               "cortex-m4 clock=(MHz)120",
               "flash=(KiB)512 ram=(KiB)192",
               "(MHz)24"},
    // https://github.com/platformio/platformio-docs/blob/develop/boards/nordicnrf52/nrf52840_dk.rst
    OtherBoard{{"nrf52840 nano33ble feather52840 xiaoble nicenano", "an nRF52840 (Cortex-M4)", measured},
               "cortex-m4 clock=(MHz)64",
               "flash=(MiB)1 ram=(KiB)256",
               "(MHz)32"},
    // https://github.com/platformio/platformio-docs/blob/develop/boards/nordicnrf52/calliopemini_v3.rst
    OtherBoard{{"microbit microbitv2 nrf52833", "a micro:bit (nRF52833, Cortex-M4)", measured},
               "cortex-m4 clock=(MHz)64",
               "flash=(KiB)512 ram=(KiB)128",
               "(MHz)32"},
    // https://docs.zephyrproject.org/boards/nordic/nrf5340dk/doc/index.html
    // https://elixir.bootlin.com/zephyr/v2.4.0/source/dts/arm/nordic/nrf5340_cpuapp_qkaa.dtsi
    OtherBoard{{"nrf5340 nrf53", "an nRF5340 (Cortex-M33)", measured},
               "cortex-m33 clock=(MHz)128",
               "flash=(MiB)1 ram=(KiB)512",
               "(MHz)32"},
    // https://doc.riot-os.org/boards/nucleo-u575zi-q
    OtherBoard{{"stm32u5 stm32u575", "an STM32U5 (Cortex-M33)", measured},
               "cortex-m33 clock=(MHz)160",
               "flash=(MiB)2 ram=(KiB)768",
               "(MHz)40"},
    // https://docs.zephyrproject.org/3.7.0/boards/pjrc/teensy4/doc/index.html
    // https://docs.platformio.org/en/latest/boards/teensy/teensy41.html
    OtherBoard{
        {"teensy teensy4 teensy40 teensy41 imxrt1062", "a Teensy 4 (i.MX RT1062, Cortex-M7)", measured},
        "cortex-m7 clock=(MHz)600",
        "flash=(MiB)2 ram=(KiB)512",
        "(MHz)30"},
    // https://docs.zephyrproject.org/4.0.0/boards/weact/mini_stm32h743/doc/index.html
    // https://github.com/platformio/platformio-docs/blob/develop/boards/ststm32/nucleo_h743zi.rst
    OtherBoard{{"stm32h7 stm32h743", "an STM32H743 (Cortex-M7)", measured},
               "cortex-m7 clock=(MHz)480",
               "flash=(MiB)2 ram=(KiB)512",
               "(MHz)60"},
    // https://docs.kernel.org/6.3/_sources/arm/stm32/stm32f746-overview.rst.txt
    OtherBoard{{"stm32f7 stm32f746 nucleof746zg", "an STM32F746 (Cortex-M7)", measured},
               "cortex-m7 clock=(MHz)216",
               "flash=(MiB)1 ram=(KiB)320",
               "(MHz)54"},
    // https://github.com/platformio/platformio-docs/blob/develop/boards/ststm32/disco_f407vg.rst
    OtherBoard{{"stm32f407 stm32f407vg", "an STM32F407 (Cortex-M4)", measured},
               "cortex-m4 clock=(MHz)168",
               "flash=(MiB)1 ram=(KiB)128",
               "(MHz)42"},
    // https://docs.zephyrproject.org/boards/st/nucleo_f446re/doc/index.html
    OtherBoard{{"stm32f4 stm32f446 nucleof446re", "an STM32F446 (Cortex-M4)", measured},
               "cortex-m4 clock=(MHz)180",
               "flash=(KiB)512 ram=(KiB)128",
               "(MHz)45"},
    OtherBoard{{"stm32f103 stm32f1", "an STM32F103", "is the chip of the Blue Pill: take bluepill"}},
    OtherBoard{{"stm32f411 stm32f411ce", "an STM32F411", "is the chip of the Black Pill: take blackpill"}},
    OtherBoard{{"raspberrypi raspberrypi4 raspberrypi5 raspberrypizero rpi pi pi4 pi5 pizero pizero2w",
                "a Raspberry Pi with Linux", linux_board}},
};

constexpr std::array cores{
    OtherName{"cortexm35p cortexm55 cortexm85", "a Cortex-M newer than the M33",
              "is not measured: take cortex-m33, whose instructions it has"},
    OtherName{"cortexm23 cortexm1 m23", "the Cortex-M23",
              "is not measured: take cortex-m0+, whose instructions it has"},
    OtherName{
        "xtensa lx6 lx7 xtensalx6 xtensalx7 esp32 riscv rv32 rv32imc", "a processor that is no Cortex-M",
        "is not measured: take cortex-m4 with the true clock, and change cycles= until the milliseconds are "
        "those that you measure (docs/fit.md)"},
    OtherName{"avr atmega328p", "an AVR", too_small},
    OtherName{"cortexa7 cortexa8 cortexa9 cortexa53 cortexa72 cortexr5", "a Cortex-A",
              "is not measured: play the scene on it, and see how fast that is"},
};

const OtherBoard* board_called(std::string_view name)
{
    const auto* const found =
        std::ranges::find_if(boards, [name](const OtherBoard& board) { return is_called(board.name, name); });
    return found == boards.end() ? nullptr : found;
}

/// "my-pico2"
std::string file_name_of(const OtherBoard& board)
{
    return "my-" + std::string{board.name.names.substr(0, board.name.names.find(' '))};
}

}

std::span<const OtherBoard> other_boards() { return boards; }

std::span<const OtherName> other_cores() { return cores; }

std::string board_file(const OtherBoard& board)
{
    if (board.core.empty())
        return {};
    const auto line = [](const char* begin, std::string_view rest) {
        return "    " + std::string{begin} + std::string{rest} + '\n';
    };
    return "board " + file_name_of(board) + " {\n" + line("core ", board.core) +
           line("memory ", board.memory) + line("bus spi clock=", board.spi) + line("panel ", "st7789") +
           line("bands ", "(KiB)4") +
           line("reserved ", "flash=(KiB)100 ram=(KiB)20   // of the rest of your program") + "}\n";
}

std::optional<std::string> other_board_text(std::string_view name)
{
    const OtherBoard* const board = board_called(name);
    if (board == nullptr)
        return std::nullopt;
    const std::string what{board->name.what};
    return board->core.empty() ? what + ' ' + std::string{board->name.hint}
                               : what + " is not supported yet: there is no firmware for it";
}

std::optional<std::string> other_board_advice(std::string_view name)
{
    auto text = other_board_text(name);
    if (!text)
        return std::nullopt;
    const OtherBoard& board = *board_called(name);
    if (board.core.empty())
        return text;
    const std::string file = file_name_of(board) + ".kdl";
    return *text + ". What plays there is the library, in a program of your own (docs/packages.md).\n" +
           "For an estimate write these lines into " + file + ", and take --board " + file + ";\n" +
           std::string{board.name.hint} + ".\n\n" + board_file(board);
}

std::optional<std::string> other_core_text(std::string_view name)
{
    const auto* const core =
        std::ranges::find_if(cores, [name](const OtherName& other) { return is_called(other, name); });
    return core == cores.end() ? std::nullopt
                               : std::optional{std::string{core->what} + ' ' + std::string{core->hint}};
}

namespace {

// The end of the sentence that begins with what it is.
constexpr std::string_view pages = "takes pages of 8 rows, no rectangles: take one with an SSD1306";
constexpr std::string_view not_yet =
    "has no driver yet; for an estimate describe it with the board, as panel 320 240 format=rgb565";

constexpr std::array panels{
    OtherName{"sh1106 sh1107 sh1108", "an SH1106, often sold as an SSD1306 of 1.3 inches,", pages},
    OtherName{"st7565 uc1701 pcd8544 nokia5110 ks0108", "this controller", pages},
    OtherName{"st7920", "an ST7920",
              "takes rows in words of 16 pixels, and has no driver: take one with an SSD1306"},
    OtherName{"ssd1309 ssd1305", "this controller",
              "has the commands of the SSD1306 for pictures: try ssd1306, which nobody has done yet"},
    OtherName{"epaper eink epd waveshareepaper ssd1680 ssd1681 ssd1675 uc8151 il0373 gdew", "e-paper",
              "takes a second or more for a picture, too long for animations"},
    OtherName{"ssd1331 ili9163 ili9225 ili9481 hx8357 hx8347 ra8875 ssd1963 gc9107 gc9d01", "this controller",
              not_yet},
    OtherName{"ili9486 ili9488", "an ILI9488",
              "has no driver yet, and takes 18 bits for a pixel by SPI; for an estimate describe it with the "
              "board, as "
              "panel 320 480 format=rgb666"},
    OtherName{"st7789v st7789v2 st7789vw st7789s", "an ST7789V", "is an ST7789: take st7789"},
    OtherName{"st7735s st7735r st7735b", "an ST7735S", "is an ST7735: take st7735"},
    OtherName{"ili9342 ili9342c ili9340", "an ILI9342", "has the commands of the ILI9341: try ili9341"},
    OtherName{"gc9a01a gc9a01n", "a GC9A01A", "is a GC9A01: take gc9a01"},
    OtherName{"oled oled128x64 ssd1306i2c ssd1306spi", "the OLED that most people have",
              "has an SSD1306: take ssd1306"},
    OtherName{"hub75 ws2812 ws2812b neopixel max7219 apa102", "a matrix of lights", "has no driver"},
    OtherName{"hd44780 lcd1602 lcd2004 lcd", "a display of letters", "shows no pictures"},
};

}

std::span<const OtherName> other_panels() { return panels; }

std::optional<std::string> other_panel_text(std::string_view name)
{
    const auto* const panel =
        std::ranges::find_if(panels, [name](const OtherName& other) { return is_called(other, name); });
    if (panel == panels.end())
        return std::nullopt;
    return std::string{panel->what} + ' ' + std::string{panel->hint};
}

std::optional<std::string> undriven_panel_text(std::string_view name)
{
    const Display* const display = display_named(name);
    if (display == nullptr)
        return other_panel_text(name);
    if (display->is_driven)
        return std::nullopt;
    return "kfast fit alone knows it, for it has no driver yet; its picture is that of --size " +
           std::to_string(display->size.width) + 'x' + std::to_string(display->size.height) + " --format " +
           std::string{name_of(display->format)};
}

}
