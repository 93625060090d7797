#include "firmware/board_record.hpp"

#include "firmware/span_writer.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>

namespace kfast {
namespace {

constexpr std::array<std::byte, 4> magic{std::byte{'K'}, std::byte{'F'}, std::byte{'B'}, std::byte{'S'}};
constexpr std::uint32_t record_version = 1;

constexpr std::uint32_t bgr = 1;
constexpr std::uint32_t inverted = 2;
constexpr std::uint32_t tearing_effect = 4;

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

/// Reads fields one after another and remembers whether each of them meant something.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_{bytes} {}

    bool is_right() const { return is_right_; }

    std::uint32_t u8() { return bytes_.u8(); }
    int u16() { return static_cast<int>(bytes_.u16()); }
    std::uint32_t u32() { return bytes_.u32(); }
    /// One of the enumerators 0 … last.
    template <class E>
    E one_of(E last)
    {
        const std::uint32_t value = u8();
        is_right_ = is_right_ && value <= static_cast<std::uint32_t>(last);
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
    bool is_right_ = true;
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

Control read_control(Reader& reader)
{
    Control control;
    control.kind = reader.one_of(ControlKind::knob);
    control.action = reader.one_named<ControlAction>(control_action_names);
    control.pin = static_cast<Pin>(reader.u8());
    static_cast<void>(reader.u8());
    control.name = reader.text();
    return control;
}

BoardSettings read_fields(Reader& reader)
{
    BoardSettings settings;
    settings.panel = read_panel(reader);
    settings.bus = reader.one_named<BusKind>(bus_names);
    settings.i2c_address = static_cast<std::uint8_t>(reader.u8());
    for (Pin& pin : settings.pins)
        pin = static_cast<Pin>(reader.u8());
    settings.bus_clock = reader.u32();
    settings.clip = reader.text();
    for (Control& control : settings.controls)
        control = read_control(reader);
    return settings;
}

std::uint32_t checksum(std::span<const std::byte> bytes)
{
    Crc32 crc;
    crc.add(bytes);
    return crc.value();
}

bool is_whole(std::span<const std::byte> record)
{
    ByteReader reader{record.subspan(magic.size())};
    ByteReader end{record.last(4)};
    return std::ranges::equal(record.first(magic.size()), magic) && reader.u16() == record_version &&
           reader.u16() == board_record_fields && end.u32() == checksum(record.first(record.size() - 4));
}

}

BoardRecord board_record(const BoardSettings& settings)
{
    BoardRecord record;
    std::ranges::copy(magic, record.begin());
    Writer writer{std::span{record}.subspan(magic.size())};
    writer.u16(record_version);
    writer.u16(board_record_fields);
    write_panel(settings.panel, writer);
    writer.number_of(settings.bus);
    writer.u8(settings.i2c_address);
    for (const Pin pin : settings.pins)
        writer.u8(pin);
    writer.u32(settings.bus_clock);
    writer.text(settings.clip);
    for (const Control& control : settings.controls)
        write_control(control, writer);
    writer.u32(checksum(std::span{record}.first(record.size() - 4)));
    return record;
}

std::optional<BoardSettings> read_board_record(std::span<const std::byte> bytes)
{
    if (bytes.size() < board_record_bytes || !is_whole(bytes.first(board_record_bytes)))
        return std::nullopt;
    Reader reader{bytes.subspan(8)};
    const BoardSettings settings = read_fields(reader);
    return reader.is_right() ? std::optional{settings} : std::nullopt;
}

}
