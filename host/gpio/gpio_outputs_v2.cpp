#include "host/gpio/gpio_lookup.hpp"

#include <array>
#include <cerrno>
#include <gpiod.h>
#include <system_error>
#include <utility>

/// libgpiod 2.
namespace kfast {
namespace {

template <class T, void (*free)(T*)>
struct Free {
    void operator()(T* thing) const { free(thing); }
};

/// Owns what libgpiod returns, or null.
template <class T, void (*free)(T*)>
using Owned = std::unique_ptr<T, Free<T, free>>;

using ChipInfo = Owned<gpiod_chip_info, gpiod_chip_info_free>;
using LineInfo = Owned<gpiod_line_info, gpiod_line_info_free>;
using LineSettings = Owned<gpiod_line_settings, gpiod_line_settings_free>;
using LineConfig = Owned<gpiod_line_config, gpiod_line_config_free>;
using RequestConfig = Owned<gpiod_request_config, gpiod_request_config_free>;
using LineRequest = Owned<gpiod_line_request, gpiod_line_request_release>;

ChipInfo info_of(gpiod_chip* chip)
{
    ChipInfo info{::gpiod_chip_get_info(chip)};
    if (!info)
        throw cannot_open_chip(::gpiod_chip_get_path(chip), errno);
    return info;
}

constexpr gpiod_line_value value_of(bool level)
{
    return level ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
}

/// Returns null and sets errno if that fails.
LineRequest request(gpiod_chip* chip, std::span<const unsigned> offsets, std::span<const GpioLine> lines,
                    GpioDrive drive)
{
    const LineSettings settings{::gpiod_line_settings_new()};
    const LineConfig config{::gpiod_line_config_new()};
    const RequestConfig who{::gpiod_request_config_new()};
    if (!settings || !config || !who)
        return nullptr;
    ::gpiod_request_config_set_consumer(who.get(), "kfast");
    ::gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_OUTPUT);
    ::gpiod_line_settings_set_drive(settings.get(), drive == GpioDrive::open_drain
                                                        ? GPIOD_LINE_DRIVE_OPEN_DRAIN
                                                        : GPIOD_LINE_DRIVE_PUSH_PULL);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ::gpiod_line_settings_set_output_value(settings.get(), value_of(lines[i].level));
        if (::gpiod_line_config_add_line_settings(config.get(), &offsets[i], 1, settings.get()) != 0)
            return nullptr;
    }
    return LineRequest{::gpiod_chip_request_lines(chip, who.get(), config.get())};
}

}

GpioChip::GpioChip(const std::string& path) : chip_{::gpiod_chip_open(path.c_str())}
{
    if (chip_ == nullptr)
        throw std::system_error{errno, std::generic_category()};
}

GpioChip::GpioChip(GpioChip&& other) noexcept : chip_{std::exchange(other.chip_, nullptr)} {}

GpioChip::~GpioChip()
{
    if (chip_ != nullptr)
        ::gpiod_chip_close(chip_);
}

std::string GpioChip::name() const { return ::gpiod_chip_info_get_name(info_of(chip_).get()); }

std::string GpioChip::label() const { return ::gpiod_chip_info_get_label(info_of(chip_).get()); }

unsigned GpioChip::line_count() const
{
    return static_cast<unsigned>(::gpiod_chip_info_get_num_lines(info_of(chip_).get()));
}

std::optional<unsigned> GpioChip::offset_of(const std::string& line) const
{
    const int offset = ::gpiod_chip_get_line_offset_from_name(chip_, line.c_str());
    return offset < 0 ? std::nullopt : std::optional{static_cast<unsigned>(offset)};
}

std::string GpioChip::user_of(unsigned offset) const
{
    const LineInfo line{::gpiod_chip_get_line_info(chip_, offset)};
    if (!line || !::gpiod_line_info_is_used(line.get()))
        return "";
    const char* const user = ::gpiod_line_info_get_consumer(line.get());
    return user == nullptr ? "the kernel" : user;
}

class GpioOutputs::Request {
public:
    Request(FoundLines found, std::span<const GpioLine> lines, GpioDrive drive)
        : name_{text_of(found.chip)}, lines_{request(found.chip.get(), found.offsets, lines, drive)}
    {
        if (!lines_)
            throw cannot_have_lines(found, errno, drive);
        offsets_ = std::move(found.offsets);
    }

    void set(std::uint32_t which, std::uint32_t levels)
    {
        std::array<unsigned, max_lines> offsets{};
        std::array<gpiod_line_value, max_lines> values{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < offsets_.size(); ++i)
            if ((which >> i & 1) != 0) {
                offsets[count] = offsets_[i];
                values[count++] = value_of((levels >> i & 1) != 0);
            }
        if (::gpiod_line_request_set_values_subset(lines_.get(), count, offsets.data(), values.data()) != 0)
            throw cannot_set_lines(name_, errno);
    }

private:
    std::string name_;
    LineRequest lines_;
    std::vector<unsigned> offsets_;
};

GpioOutputs::GpioOutputs(const std::string& chip, std::span<const GpioLine> lines, GpioDrive drive)
    : request_{std::make_unique<Request>(find_lines(chip, lines), lines, drive)}
{
}

GpioOutputs::~GpioOutputs() = default;
GpioOutputs::GpioOutputs(GpioOutputs&&) noexcept = default;
GpioOutputs& GpioOutputs::operator=(GpioOutputs&&) noexcept = default;

void GpioOutputs::set(std::uint32_t which, std::uint32_t levels) { request_->set(which, levels); }

}
