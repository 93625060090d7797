#include "firmware/settings/board_record.hpp"

#include "firmware/chip/span_writer.hpp"
#include "firmware/settings/controller_facts.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>

namespace kfast {
namespace {

constexpr std::array<std::byte, 4> magic{std::byte{'K'}, std::byte{'F'}, std::byte{'B'}, std::byte{'S'}};
constexpr std::uint32_t panel_version = 1;
constexpr std::uint32_t beam_version = 2;

constexpr std::size_t header_bytes = magic.size() + 2 + 2;
constexpr std::size_t bytes_around_fields = header_bytes + 4;

// What version 1 has.
constexpr std::size_t panel_version_pins = 8;
constexpr BusKind last_bus_of_panels = BusKind::parallel_8;
constexpr ControlAction last_action_of_panels = ControlAction::input;

constexpr std::uint32_t bgr = 1;
constexpr std::uint32_t inverted = 2;
constexpr std::uint32_t tearing_effect = 4;

constexpr std::uint32_t laser = 1;

class Writer : public SpanWriter {
public:
    using SpanWriter::SpanWriter;

    template <class E>
    void number_of(E value)
    {
        u8(static_cast<std::uint32_t>(value));
    }
    void text(const StoredName& name) { bytes(std::as_bytes(std::span{name.bytes})); }
};

/// Reads fields one after another and remembers whether each of them had a meaning.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_{bytes} {}

    bool is_valid() const { return is_valid_; }

    std::uint32_t u8() { return bytes_.u8(); }
    int u16() { return static_cast<int>(bytes_.u16()); }
    std::int16_t i16() { return static_cast<std::int16_t>(bytes_.u16()); }
    std::uint32_t u32() { return bytes_.u32(); }
    /// One of the enumerators 0 … last.
    template <class E>
    E one_of(E last)
    {
        const std::uint32_t value = u8();
        is_valid_ = is_valid_ && value <= static_cast<std::uint32_t>(last);
        return static_cast<E>(value);
    }
    /// One of the enumerators that `names` lists in their order.
    template <class E, std::size_t count>
    E one_named(const std::array<std::string_view, count>&)
    {
        return one_of(static_cast<E>(count - 1));
    }
    StoredName text()
    {
        StoredName name;
        for (char& letter : name.bytes)
            letter = static_cast<char>(u8());
        return name;
    }

private:
    ByteReader bytes_;
    bool is_valid_ = true;
};

void write_panel(const PanelSettings& panel, Writer& writer)
{
    writer.number_of(panel.controller);
    writer.number_of(panel.rotation);
    writer.u8((panel.bgr ? bgr : 0) | (panel.inverted ? inverted : 0) |
              (panel.tearing_effect ? tearing_effect : 0));
    writer.u8(panel.brightness);
    for (const int number : {panel.glass.width, panel.glass.height, panel.column, panel.row})
        writer.u16(static_cast<std::uint32_t>(number));
}

PanelSettings read_panel(Reader& reader)
{
    PanelSettings panel;
    panel.controller = reader.one_named<Controller>(controller_names);
    panel.rotation = reader.one_of(Rotation::three_quarters);
    const std::uint32_t flags = reader.u8();
    panel.bgr = (flags & bgr) != 0;
    panel.inverted = (flags & inverted) != 0;
    panel.tearing_effect = (flags & tearing_effect) != 0;
    panel.brightness = static_cast<std::uint8_t>(reader.u8());
    for (int* number : {&panel.glass.width, &panel.glass.height, &panel.column, &panel.row})
        *number = reader.u16();
    return panel;
}

void write_control(const Control& control, Writer& writer)
{
    writer.number_of(control.kind);
    writer.number_of(control.action);
    writer.u8(control.pin);
    writer.u8(0);
    writer.text(control.name);
}

Control read_control(Reader& reader, ControlAction last_action)
{
    Control control;
    control.kind = reader.one_of(ControlKind::knob);
    control.action = reader.one_of(last_action);
    control.pin = static_cast<Pin>(reader.u8());
    static_cast<void>(reader.u8());
    control.name = reader.text();
    return control;
}

void write_beam(const BeamProfile& beam, Writer& writer)
{
    writer.u32(beam.rate);
    writer.u16(beam.lit_step);
    writer.u16(beam.travel_step);
    for (const std::uint8_t number : {beam.corner_dwell, beam.lit_dwell, beam.arrival_dwell, beam.leave_dwell,
                                      beam.light_delay, beam.min_refresh})
        writer.u8(number);
    writer.u16(beam.resolution);
    writer.number_of(beam.brightness);
    writer.u8(beam.is_laser ? laser : 0);
    for (const std::int16_t number : {beam.park.x, beam.park.y})
        writer.u16(static_cast<std::uint16_t>(number));
}

BeamProfile read_beam(Reader& reader)
{
    BeamProfile beam;
    beam.rate = reader.u32();
    for (std::uint16_t* number : {&beam.lit_step, &beam.travel_step})
        *number = static_cast<std::uint16_t>(reader.u16());
    for (std::uint8_t* number : {&beam.corner_dwell, &beam.lit_dwell, &beam.arrival_dwell, &beam.leave_dwell,
                                 &beam.light_delay, &beam.min_refresh})
        *number = static_cast<std::uint8_t>(reader.u8());
    beam.resolution = static_cast<std::uint16_t>(reader.u16());
    beam.brightness = reader.one_of(BeamBrightness::by_speed);
    beam.is_laser = (reader.u8() & laser) != 0;
    for (std::int16_t* number : {&beam.park.x, &beam.park.y})
        *number = reader.i16();
    return beam;
}

/// Whether version 1 cannot hold the settings.
bool is_about_beam(const BoardSettings& settings)
{
    const bool has_pin = std::ranges::any_of(std::span{settings.pins}.subspan(panel_version_pins),
                                             [](Pin pin) { return pin != no_pin; });
    const bool has_action = std::ranges::any_of(
        settings.controls, [](const Control& control) { return control.action > last_action_of_panels; });
    return settings.bus > last_bus_of_panels || has_pin || has_action || settings.beam != BeamProfile{};
}

BoardSettings read_fields(Reader& reader, std::uint32_t version)
{
    const bool has_beam = version == beam_version;
    BoardSettings settings;
    settings.panel = read_panel(reader);
    settings.bus = reader.one_of(has_beam ? static_cast<BusKind>(bus_names.size() - 1) : last_bus_of_panels);
    settings.i2c_address = static_cast<std::uint8_t>(reader.u8());
    for (Pin& pin : std::span{settings.pins}.first(panel_version_pins))
        pin = static_cast<Pin>(reader.u8());
    settings.bus_clock = reader.u32();
    settings.clip = reader.text();
    for (Control& control : settings.controls)
        control = read_control(reader, has_beam ? static_cast<ControlAction>(control_action_names.size() - 1)
                                                : last_action_of_panels);
    if (!has_beam)
        return settings;
    for (Pin& pin : std::span{settings.pins}.subspan(panel_version_pins))
        pin = static_cast<Pin>(reader.u8());
    settings.beam = read_beam(reader);
    return settings;
}

std::uint32_t checksum(std::span<const std::byte> bytes)
{
    Crc32 crc;
    crc.add(bytes);
    return crc.value();
}

std::size_t fields_of(std::uint32_t version)
{
    return version == panel_version ? panel_record_fields : beam_record_fields;
}

/// The version of the record that `bytes` begin with; 0 if they do not begin with a whole one.
std::uint32_t version_of(std::span<const std::byte> bytes)
{
    if (bytes.size() < header_bytes || !std::ranges::equal(bytes.first(magic.size()), magic))
        return 0;
    ByteReader reader{bytes.subspan(magic.size())};
    const std::uint32_t version = reader.u16();
    const std::size_t fields = fields_of(version);
    if (version == 0 || version > beam_version || reader.u16() != fields ||
        bytes.size() < bytes_around_fields + fields)
        return 0;
    ByteReader sum{bytes.subspan(header_bytes + fields)};
    return sum.u32() == checksum(bytes.first(header_bytes + fields)) ? version : 0;
}

}

BoardRecord board_record(const BoardSettings& settings)
{
    const std::uint32_t version = is_about_beam(settings) ? beam_version : panel_version;
    BoardRecord record{bytes_around_fields + fields_of(version)};
    std::ranges::copy(magic, record.begin());
    Writer writer{std::span{record}.subspan(magic.size())};
    writer.u16(version);
    writer.u16(static_cast<std::uint32_t>(fields_of(version)));
    write_panel(settings.panel, writer);
    writer.number_of(settings.bus);
    writer.u8(settings.i2c_address);
    for (const Pin pin : std::span{settings.pins}.first(panel_version_pins))
        writer.u8(pin);
    writer.u32(settings.bus_clock);
    writer.text(settings.clip);
    for (const Control& control : settings.controls)
        write_control(control, writer);
    if (version == beam_version) {
        for (const Pin pin : std::span{settings.pins}.subspan(panel_version_pins))
            writer.u8(pin);
        write_beam(settings.beam, writer);
    }
    writer.u32(checksum(std::span{record}.first(record.size() - 4)));
    return record;
}

std::optional<BoardSettings> read_board_record(std::span<const std::byte> bytes)
{
    const std::uint32_t version = version_of(bytes);
    if (version == 0)
        return std::nullopt;
    Reader reader{bytes.subspan(header_bytes)};
    const BoardSettings settings = read_fields(reader, version);
    return reader.is_valid() ? std::optional{settings} : std::nullopt;
}

}
