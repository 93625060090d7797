#include "core/raster/record.hpp"

#include "core/bytes/expects.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/pixel/pixel_coding.hpp"

#include <algorithm>

namespace kfast::raster {

namespace {

/// Copies to an address before it. Memory need not be aligned to words, where copying bytes would be slow.
void copy_borders(const Record::Border* from, std::size_t count, Record::Border* to)
{
    const auto* source = reinterpret_cast<const Halfword*>(from);
    auto* target = reinterpret_cast<Halfword*>(to);
    for (std::size_t left = count * sizeof(Record::Border) / sizeof(Halfword); left != 0; --left)
        *target++ = *source++;
}

}

Record::Record(std::span<Border> borders, std::span<std::uint8_t> counts) : borders_{borders}, counts_{counts}
{
    forget();
}

void Record::forget()
{
    std::ranges::fill(counts_, unknown);
    written_ = borders_.data();
}

void Record::begin_picture()
{
    read_end_ = written_;
    read_ = written_ = borders_.data();
    is_apart_ = false;
}

/// Makes room between what is written and what is to be read, by an even number of borders: whole words.
void Record::make_room()
{
    is_apart_ = true;
    const auto free = (borders_.data() + borders_.size() - read_end_) / 2 * 2;
    read_ = std::copy_backward(read_, read_end_, read_end_ + free);
}

void Record::pass_band(int band, std::span<const PaintStep> shown)
{
    expects(is_known(band));
    std::uint8_t& count = counts_[static_cast<std::size_t>(band)];
    count_op(Op::passed_band);
    count_op(Op::passed_border, count);
    if (read_ != written_)
        copy_borders(read_, count, written_);
    Border* const begin = written_;
    read_ += count;
    written_ += count;
    if (shown.empty())
        return;
    for (Border* border = begin; border != written_; ++border) {
        const std::uint16_t layer = shown[border->layer].partner;
        border->layer = layer & max_layer;
        if (layer > max_layer)
            count = unknown;
    }
    if (count == unknown)
        written_ = begin;
}

int Record::unknown_count(int bands) const
{
    return static_cast<int>(std::ranges::count(counts_.first(static_cast<std::size_t>(bands)), unknown));
}

std::span<const Record::Border> Record::begin_band(int band)
{
    const std::size_t count = is_known(band) ? counts_[static_cast<std::size_t>(band)] : 0U;
    const std::span<const Border> shown{read_, count};
    read_ += count;
    band_ = band;
    band_end_ = written_;
    has_capacity_ = true;
    return shown;
}

void Record::add(const Chain& chain)
{
    if (band_end_ == read_ && !is_apart_)
        make_room();
    has_capacity_ = has_capacity_ && band_end_ != read_ && chain.layer <= max_layer;
    if (!has_capacity_)
        return;
    band_end_->begin = chain.begin;
    band_end_->end = chain.end;
    band_end_->layer = chain.layer & max_layer;
    band_end_->is_border = chain.is_border ? 1 : 0;
    band_end_->rows = chain.rows & all_rows;
    ++band_end_;
}

void Record::drop_band() { counts_[static_cast<std::size_t>(band_)] = unknown; }

void Record::end_band()
{
    const auto count = band_end_ - written_;
    has_capacity_ = has_capacity_ && count < unknown;
    counts_[static_cast<std::size_t>(band_)] = has_capacity_ ? static_cast<std::uint8_t>(count) : unknown;
    if (has_capacity_)
        written_ = band_end_;
}

}
