#include "host/gpio/gpio_lookup.hpp"

#include <array>
#include <cerrno>
#include <gpiod.h>
#include <system_error>
#include <utility>

/// libgpiod 1.6.
namespace kfast {

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

std::string GpioChip::name() const { return ::gpiod_chip_name(chip_); }

std::string GpioChip::label() const { return ::gpiod_chip_label(chip_); }

unsigned GpioChip::line_count() const { return ::gpiod_chip_num_lines(chip_); }

std::optional<unsigned> GpioChip::offset_of(const std::string& line) const
{
    gpiod_line* const found = ::gpiod_chip_find_line(chip_, line.c_str());
    return found == nullptr ? std::nullopt : std::optional{::gpiod_line_offset(found)};
}

std::string GpioChip::user_of(unsigned offset) const
{
    gpiod_line* const line = ::gpiod_chip_get_line(chip_, offset);
    if (line == nullptr || ::gpiod_line_update(line) != 0 || !::gpiod_line_is_used(line))
        return "";
    const char* const user = ::gpiod_line_consumer(line);
    return user == nullptr ? "the kernel" : user;
}

/// Its API sets all lines of a request at once, or one.
class GpioOutputs::Request {
public:
    Request(FoundLines found, std::span<const GpioLine> lines, GpioDrive drive) : chip_{std::move(found.chip)}
    {
        ::gpiod_line_bulk_init(&lines_);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            gpiod_line* const line = ::gpiod_chip_get_line(chip_.get(), found.offsets[i]);
            if (line == nullptr)
                throw cannot_have_lines({std::move(chip_), std::move(found.offsets)}, errno, drive);
            ::gpiod_line_bulk_add(&lines_, line);
            levels_[i] = lines[i].level ? 1 : 0;
        }
        const int flags = drive == GpioDrive::open_drain ? GPIOD_LINE_REQUEST_FLAG_OPEN_DRAIN : 0;
        if (::gpiod_line_request_bulk_output_flags(&lines_, "kfast", flags, levels_.data()) != 0)
            throw cannot_have_lines({std::move(chip_), std::move(found.offsets)}, errno, drive);
    }
    ~Request() { ::gpiod_line_release_bulk(&lines_); }
    Request(const Request&) = delete;
    Request& operator=(const Request&) = delete;

    void set(std::uint32_t which, std::uint32_t levels)
    {
        for (unsigned i = 0; i < lines_.num_lines; ++i)
            if ((which >> i & 1) != 0)
                levels_[i] = static_cast<int>(levels >> i & 1);
        if (::gpiod_line_set_value_bulk(&lines_, levels_.data()) != 0)
            throw cannot_set_lines(text_of(chip_), errno);
    }

private:
    GpioChip chip_;
    gpiod_line_bulk lines_{};
    std::array<int, max_lines> levels_{};
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
