#include "host/picture/apng.hpp"

#include "core/bytes/crc32.hpp"
#include "host/file/atomic_file.hpp"
#include "host/picture/film.hpp"
#include "host/picture/picture.hpp"
#include "host/picture/png.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t signature_bytes = 8;
constexpr std::size_t word_bytes = 4;

void append(Bytes& bytes, std::span<const std::byte> more)
{
    bytes.insert(bytes.end(), more.begin(), more.end());
}

template <class Number>
void append_number(Bytes& bytes, Number number)
{
    for (int shift = 8 * static_cast<int>(sizeof number) - 8; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::byte>(number >> shift));
}

std::uint32_t word_at(std::span<const std::byte> bytes)
{
    std::uint32_t word = 0;
    for (const std::byte byte : bytes.first(word_bytes))
        word = word << 8 | std::to_integer<std::uint32_t>(byte);
    return word;
}

struct Chunk {
    std::string_view name;
    std::span<const std::byte> data;
};

/// The chunks that libpng has made.
std::vector<Chunk> chunks_of(std::span<const std::byte> png)
{
    std::vector<Chunk> chunks;
    for (auto rest = png.subspan(signature_bytes); !rest.empty();) {
        const std::size_t length = word_at(rest);
        const char* const name = reinterpret_cast<const char*>(rest.data()) + word_bytes;
        chunks.push_back({{name, word_bytes}, rest.subspan(2 * word_bytes, length)});
        rest = rest.subspan(length + 3 * word_bytes);
    }
    return chunks;
}

void append_chunk(Bytes& bytes, std::string_view name, std::span<const std::byte> data)
{
    append_number(bytes, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = bytes.size();
    append(bytes, std::as_bytes(std::span{name}));
    append(bytes, data);
    Crc32 crc;
    crc.add(std::span{bytes}.subspan(begin));
    append_number(bytes, crc.value());
}

class ApngEncoder {
public:
    explicit ApngEncoder(const FilmLimit& limit) : limit_{limit} {}

    void add(const Picture& picture, const Rect& area, const FilmDelay& delay)
    {
        const Bytes png = encoded_png(picture);
        if (frames_ == 0)
            head_ = first_chunks(png);
        add_control(area, delay);
        for (const Chunk& chunk : chunks_of(png))
            if (chunk.name == "IDAT")
                add_data(chunk.data);
        ++frames_;
        limit_.require(head_.size() + body_.size(), "animated PNG");
    }

    Bytes finished(bool is_endless)
    {
        Bytes file = std::move(head_);
        Bytes control;
        append_number(control, frames_);
        append_number(control, std::uint32_t{is_endless ? 0U : 1U}); // 0 plays for ever
        append_chunk(file, "acTL", control);
        append(file, body_);
        append_chunk(file, "IEND", {});
        return file;
    }

private:
    /// The signature and the header, which is valid for all pictures.
    static Bytes first_chunks(std::span<const std::byte> png)
    {
        Bytes head{png.begin(), png.begin() + signature_bytes};
        append_chunk(head, "IHDR", chunks_of(png).front().data);
        return head;
    }

    void add_control(const Rect& area, const FilmDelay& delay)
    {
        Bytes control;
        append_number(control, sequence_++);
        for (const int each : {area.width, area.height, area.x, area.y})
            append_number(control, static_cast<std::uint32_t>(each));
        append_number(control, delay.numerator);
        append_number(control, delay.denominator);
        append_number(control, std::uint16_t{0}); // stays, and is drawn over the previous picture
        append_chunk(body_, "fcTL", control);
    }

    /// The first picture is also the one of viewers without animation.
    void add_data(std::span<const std::byte> data)
    {
        if (frames_ == 0)
            return append_chunk(body_, "IDAT", data);
        Bytes numbered;
        append_number(numbered, sequence_++);
        append(numbered, data);
        append_chunk(body_, "fdAT", numbered);
    }

    FilmLimit limit_;
    Bytes head_;
    Bytes body_;
    std::uint32_t frames_ = 0;
    std::uint32_t sequence_ = 0;
};

/// Holds a picture back until it is known for how long it is shown.
class ApngFilm {
public:
    ApngFilm(std::uint32_t frame_rate, const FilmLimit& limit) : frame_rate_{frame_rate}, encoder_{limit} {}

    void show(Picture picture, std::int64_t ticks)
    {
        const std::optional<Rect> changed =
            is_begun_ ? changed_part(picture_, picture) : Rect{0, 0, picture.size.width, picture.size.height};
        if (!changed && film_delay(ticks_ + ticks, frame_rate_).is_exact) {
            ticks_ += ticks;
            return;
        }
        flush();
        area_ = changed.value_or(Rect{0, 0, 1, 1}); // none may be empty
        picture_ = std::move(picture);
        ticks_ = ticks;
        is_begun_ = true;
    }

    Bytes finished(bool is_endless)
    {
        flush();
        return encoder_.finished(is_endless);
    }

private:
    void flush()
    {
        if (is_begun_)
            encoder_.add(part(picture_, area_), area_, film_delay(ticks_, frame_rate_));
    }

    std::uint32_t frame_rate_;
    ApngEncoder encoder_;
    Picture picture_;
    Rect area_;
    std::int64_t ticks_ = 0;
    bool is_begun_ = false;
};

}

void write_apng(const std::filesystem::path& target, FrameSource& source, const Timeline& timeline,
                const ProgressCallback& on_progress, const FilmLimit& limit)
{
    const std::vector<FilmMoment> moments = film_moments(timeline);
    ApngFilm film{timeline.frame_rate, limit};
    for (std::size_t done = 0; done < moments.size(); ++done) {
        on_progress(done, moments.size());
        film.show(widen(source.show(moments[done].time)), moments[done].end - moments[done].begin);
    }
    write_file(target, film.finished(timeline.stretch.loop != Loop::once));
}

}
