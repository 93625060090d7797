#include "host/archive/archive.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <zip.h>
#include <zlib.h>

namespace kfast::archive {

namespace {

using namespace std::string_view_literals;

/// For zlib: its default window, with the gzip wrapper.
constexpr int gzip_window = MAX_WBITS + 16;

class Inflation {
public:
    Inflation(const std::string& name, std::string_view bytes) : name_{name}
    {
        // zlib only reads there, whatever its type says.
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream_.avail_in = static_cast<uInt>(bytes.size());
        if (inflateInit2(&stream_, gzip_window) != Z_OK)
            throw Failure(name_ + ": there is no memory to unpack it");
    }
    ~Inflation() { inflateEnd(&stream_); }
    Inflation(const Inflation&) = delete;
    Inflation& operator=(const Inflation&) = delete;

    /// Returns the content of all members, one after the other.
    std::string content(std::size_t max_bytes)
    {
        std::string all;
        do
            add_member(all, max_bytes);
        while (goes_on());
        return all;
    }

private:
    void add_member(std::string& all, std::size_t max_bytes)
    {
        for (int status = Z_OK; status != Z_STREAM_END;) {
            stream_.next_out = reinterpret_cast<Bytef*>(block_.data());
            stream_.avail_out = static_cast<uInt>(block_.size());
            status = inflate(&stream_, Z_NO_FLUSH);
            if (status == Z_BUF_ERROR)
                throw Failure(name_ + ": breaks off before its end: copy it again");
            if (status != Z_OK && status != Z_STREAM_END)
                throw Failure(name_ + ": the packed file is damaged: copy it again");
            all.append(block_.data(), block_.size() - stream_.avail_out);
            if (all.size() > max_bytes)
                throw Failure(name_ + ": holds more than " + std::to_string(max_bytes >> 20) +
                              " MB: is it the right file?");
        }
    }

    /// What follows a member and is no gzip is padding.
    bool goes_on()
    {
        const std::string_view rest{reinterpret_cast<const char*>(stream_.next_in), stream_.avail_in};
        return is_gzip(rest) && inflateReset(&stream_) == Z_OK;
    }

    const std::string& name_;
    z_stream stream_{};
    std::array<char, 65536> block_{}; ///< of all members: there may be a million empty ones
};

}

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"sv); }

std::string gunzipped(const std::string& name, std::string_view bytes, std::size_t max_bytes)
{
    return Inflation{name, bytes}.content(max_bytes);
}

namespace {

struct CloseMember {
    void operator()(zip_file_t* member) const { zip_fclose(member); }
};
using Member = std::unique_ptr<zip_file_t, CloseMember>;

zip_t* opened(const std::string& name, std::string_view bytes)
{
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source == nullptr)
        throw Failure(name + ": there is no memory to unpack it");
    zip_t* const archive = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (archive != nullptr)
        return archive;
    zip_source_free(source);
    throw Failure(name + ": the zip file is damaged, or breaks off: copy it again");
}

std::string in_words(zip_error_t* error)
{
    switch (zip_error_code_zip(error)) {
    case ZIP_ER_NOPASSWD:
    case ZIP_ER_WRONGPASSWD:
    case ZIP_ER_ENCRNOTSUPP:
        return "is encrypted: unpack it, and pack it without a password";
    case ZIP_ER_COMPNOTSUPP:
        return "is packed in a way that kfast does not know: pack it with deflate";
    default:
        return "is damaged: copy the file again";
    }
}

}

bool is_zip(std::string_view bytes)
{
    return bytes.starts_with("PK\x03\x04"sv) || bytes.starts_with("PK\x05\x06"sv);
}

void ZipFile::Close::operator()(::zip* archive) const { zip_discard(archive); }

ZipFile::ZipFile(std::string name, std::string_view bytes)
    : name_{std::move(name)}, archive_{opened(name_, bytes)}
{
    const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
    if (std::cmp_greater(count, max_members))
        throw Failure(name_ + ": holds more than " + std::to_string(max_members) +
                      " files: is it the right file?");
    for (zip_int64_t index = 0; index < count; ++index) {
        const char* const path = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(index), 0);
        members_.emplace_back(path == nullptr ? "" : path);
    }
}

bool ZipFile::has(std::string_view path) const { return std::ranges::find(members_, path) != members_.end(); }

std::string ZipFile::content(std::string_view path, std::size_t max_bytes) const
{
    const auto place = std::ranges::find(members_, path);
    const std::string called = name_ + ": " + std::string{path};
    if (place == members_.end())
        throw Failure(called + " is not in it: copy the file again, or pack it again");
    const Member member{
        zip_fopen_index(archive_.get(), static_cast<zip_uint64_t>(place - members_.begin()), 0)};
    if (!member)
        throw Failure(called + ' ' + in_words(zip_get_error(archive_.get())));

    std::string all;
    std::array<char, 65536> block{};
    while (all.size() <= max_bytes) {
        const zip_int64_t count = zip_fread(member.get(), block.data(), block.size());
        if (count < 0)
            throw Failure(called + ' ' + in_words(zip_file_get_error(member.get())));
        if (count == 0)
            return all;
        all.append(block.data(), static_cast<std::size_t>(count));
    }
    throw Failure(called + " is larger than " + std::to_string(max_bytes >> 20) +
                  " MB: is it the right file?");
}

}
