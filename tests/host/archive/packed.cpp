#include "tests/host/archive/packed.hpp"

#include <cstdlib>
#include <zip.h>
#include <zlib.h>

namespace kfast::test {
namespace {

void demand(bool condition)
{
    if (!condition)
        std::abort();
}

}

std::string gzipped(std::string_view content)
{
    z_stream stream{};
    demand(deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK);
    std::string packed(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    demand(deflate(&stream, Z_FINISH) == Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

std::string zipped(const Files& files, const std::string& password)
{
    zip_error_t error;
    zip_source_t* const store = zip_source_buffer_create(nullptr, 0, 0, &error);
    demand(store != nullptr);
    zip_source_keep(store);
    zip_t* const archive = zip_open_from_source(store, ZIP_TRUNCATE, &error);
    demand(archive != nullptr);
    for (const auto& [path, content] : files) {
        zip_source_t* const source = zip_source_buffer(archive, content.data(), content.size(), 0);
        const zip_int64_t index = zip_file_add(archive, path.c_str(), source, 0);
        demand(index >= 0);
        if (!password.empty())
            demand(zip_file_set_encryption(archive, static_cast<zip_uint64_t>(index), ZIP_EM_AES_256,
                                           password.c_str()) == 0);
    }
    demand(zip_close(archive) == 0);

    zip_stat_t facts;
    demand(zip_source_stat(store, &facts) == 0 && zip_source_open(store) == 0);
    std::string packed(facts.size, '\0');
    demand(zip_source_read(store, packed.data(), packed.size()) == static_cast<zip_int64_t>(packed.size()));
    zip_source_close(store);
    zip_source_free(store);
    return packed;
}

}
