"""Settings of a board with a small display and a button."""

GADGET = """board pico {
    panel st7789 135 240 column=52 row=40 rotation=90
    bus spi clock=(MHz)62.5
    pins clock=18 data=19 dc=16
    clip idle
    button 12 play blink
}
"""
