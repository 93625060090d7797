"""A board record for a vector display (firmware/settings/board_record.hpp), made here so that its layout is checked."""

import dataclasses
import struct
import zlib

NO_PIN = 255
DAC = 3
BUTTON = 1
ARM = 7
BRIGHTNESS = {"none": 0, "level": 1, "speed": 2}


@dataclasses.dataclass(frozen=True)
class Beam:
    """The scope of core/beam/beam_profile.hpp, unless told otherwise; the light is told by speed."""
    rate: int = 100_000
    lit_step: int = 384
    travel_step: int = 0
    corner_dwell: int = 0
    lit_dwell: int = 0
    arrival_dwell: int = 0
    leave_dwell: int = 0
    light_delay: int = 0
    least_refresh: int = 40
    resolution: int = 256
    brightness: str = "speed"
    is_laser: bool = False
    park: tuple = (-32768, -32768)


GALVO = Beam(rate=30_000, lit_step=655, travel_step=3277, corner_dwell=8, lit_dwell=2, arrival_dwell=6, leave_dwell=2,
             light_delay=4, least_refresh=20, resolution=128, brightness="level", is_laser=True, park=(0, 0))


def beam_record(beam, bus_clock=20_000_000, buttons=(), log=0, **pins):
    """`buttons` are pairs of pin and action, by number; `pins` those of the converters."""
    pins = {"clock": 18, "data": 19, "select": 17, "ldac": 16, "blank": 20} | pins
    fields = bytes([0, 0, 0, 255]) + struct.pack("<4H", 240, 240, 0, 0) + bytes([DAC, 0x3C])
    fields += bytes([pins["clock"], pins["data"], pins["select"], NO_PIN, NO_PIN, NO_PIN, NO_PIN, log])
    fields += struct.pack("<I", bus_clock) + bytes(24)
    controls = [bytes([BUTTON, action, pin, 0]) + bytes(24) for pin, action in buttons]
    nothing = bytes([0, 0, NO_PIN, 0]) + bytes(24)
    fields += b"".join(controls + [nothing] * (8 - len(controls)))
    fields += bytes([pins["ldac"], pins["blank"]])
    fields += struct.pack("<IHH6BHBBhh", beam.rate, beam.lit_step, beam.travel_step, beam.corner_dwell, beam.lit_dwell,
                          beam.arrival_dwell, beam.leave_dwell, beam.light_delay, beam.least_refresh, beam.resolution,
                          BRIGHTNESS[beam.brightness], beam.is_laser, *beam.park)
    record = b"KFBS" + struct.pack("<HH", 2, len(fields)) + fields
    return record + struct.pack("<I", zlib.crc32(record))
