#include "core/bytes/picture_cache.hpp"

#include <algorithm>
#include <new>

namespace kfast {

/// When numbers begin again, sets of the picture before are kept apart from older ones.
void PictureCache::begin_picture()
{
    if (++picture_ != 0)
        return;
    for (std::size_t place = 0; place != used_; place += set_at(place).words)
        set_at(place).picture = set_at(place).picture == max_picture ? 1 : 0;
    picture_ = 2;
}

/// After the last set comes the first one.
std::size_t PictureCache::next_place(std::size_t place) const
{
    const std::size_t next = place + set_at(place).words;
    return next < used_ ? next : 0;
}

const std::uint32_t* PictureCache::find(const Name& name)
{
    if (used_ == 0)
        return nullptr;
    std::size_t place = found_;
    do {
        Set& set = set_at(place);
        if (set.name == name) {
            set.picture = picture_;
            found_ = place;
            return words_of(place);
        }
        place = next_place(place);
    } while (place != found_);
    return nullptr;
}

void PictureCache::begin(const Name& name, Incoming incoming)
{
    name_ = name;
    incoming_ =
        name == failed_ ? Incoming::beside_others : incoming; // it would replace others for nothing again
    end_ = used_;
    is_incoming_ = reserve(head_words);
    if (!is_incoming_)
        return;
    new (memory_ + end_) Set{name, 0, picture_};
    end_ += head_words;
}

std::uint32_t* PictureCache::add(std::size_t count)
{
    is_incoming_ = is_incoming_ && reserve(count);
    if (!is_incoming_)
        return nullptr;
    end_ += count;
    return memory_ + end_ - count;
}

const std::uint32_t* PictureCache::end(bool is_complete)
{
    if (!is_incoming_)
        failed_ = name_;
    const bool is_kept = is_incoming_ && is_complete && end_ - used_ <= max_words;
    is_incoming_ = false;
    if (!is_kept)
        return nullptr;
    found_ = used_;
    set_at(found_).words = static_cast<std::uint32_t>(end_ - used_) & max_words;
    used_ = end_;
    return words_of(found_);
}

/// Reserves memory after the incoming set.
bool PictureCache::reserve(std::size_t count)
{
    while (size_ - end_ < count)
        if (!remove_one())
            return false;
    return true;
}

/// Removes a set that neither this picture nor the one before has wanted, or else the one to be replaced.
bool PictureCache::remove_one()
{
    if (used_ == 0)
        return false;
    std::size_t place = found_;
    std::size_t next_of_kind = used_;
    do {
        place = next_place(place);
        const Set& set = set_at(place);
        if (set.picture + 1 < picture_) {
            remove(place);
            return true;
        }
        if (set.picture != picture_ && set.name.back() == name_.back() && next_of_kind == used_)
            next_of_kind = place;
    } while (place != found_);
    if (incoming_ != Incoming::replaces_next || next_of_kind == used_)
        return false;
    remove(next_of_kind);
    return true;
}

void PictureCache::remove(std::size_t place)
{
    const std::size_t words = set_at(place).words;
    std::copy(memory_ + place + words, memory_ + end_, memory_ + place);
    used_ -= words;
    end_ -= words;
    if (found_ > place)
        found_ -= words;
    if (found_ >= used_)
        found_ = 0;
}

std::size_t PictureCache::bytes_in_use() const
{
    std::size_t words = 0;
    for (std::size_t place = 0; place != used_; place += set_at(place).words)
        words += set_at(place).picture == picture_ ? set_at(place).words : 0U;
    return words * 4;
}

}
