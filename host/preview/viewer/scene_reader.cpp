#include "host/preview/viewer/scene_reader.hpp"

#include <exception>
#include <sstream>
#include <utility>

namespace kfast {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream rest{text};
    for (std::string line; std::getline(rest, line);)
        lines.push_back(line);
    return lines;
}

}

SceneReader::SceneReader(Opener opener, const OpenedScene& first)
    : opener_{std::move(opener)}, tried_{first.file}, errors_{lines_of(first.mistakes)}
{
    if (!errors_.empty()) {
        failed_ = Failed{first.file, first.read};
        return;
    }
    file_ = first.file;
    watch_ = first.read;
}

ReadScene SceneReader::open(const fs::path& file)
{
    FileWatch tried{{file}};
    ReadScene read_now = read(file, tried);
    if (!read_now)
        failed_ = Failed{file, std::move(tried)};
    return read_now;
}

ReadScene SceneReader::read_again()
{
    FileWatch tried;
    return read(fs::path{file_}, tried);
}

std::optional<fs::path> SceneReader::changed(Seconds now)
{
    if (failed_ && failed_->watch.has_changed(now))
        return failed_->file;
    if (watch_.has_changed(now))
        return file_;
    return std::nullopt;
}

ReadScene SceneReader::read(const fs::path& file, FileWatch& tried)
{
    errors_.clear();
    tried_ = file;
    try {
        ReadScene read_now{opener_(file), nullptr};
        read_now.layers = std::make_unique<SceneLayers>(*read_now.scene);
        failed_.reset();
        file_ = file;
        watch_ = read_now.scene->read;
        return read_now;
    } catch (const OpeningFailed& failure) {
        errors_ = lines_of(failure.what());
        tried = failure.read();
        return {};
    } catch (const std::exception& failure) { // whatever it is, what is open can go on
        errors_ = lines_of(failure.what());
        return {};
    }
}

}
