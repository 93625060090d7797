#include "host/picture/sprite_sheet.hpp"

#include "host/file/atomic_file.hpp"
#include "host/picture/film.hpp"
#include "host/picture/picture.hpp"
#include "host/picture/png.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

struct Grid {
    int columns;
    Size cell;

    Rect place(std::size_t number) const
    {
        const int index = static_cast<int>(number);
        return {index % columns * cell.width, index / columns * cell.height, cell.width, cell.height};
    }
};

Json frame_json(const Rect& place, double milliseconds)
{
    return {{"x", place.x},
            {"y", place.y},
            {"width", place.width},
            {"height", place.height},
            {"milliseconds", milliseconds}};
}

/// One pass from end to end, as if it played once, unless the way back is requested.
std::vector<FilmMoment> sheet_moments(Timeline timeline, const SpriteSheetForm& form)
{
    if (timeline.stretch.loop == Loop::ping_pong && !form.has_way_back)
        timeline.stretch.loop = Loop::once;
    return film_moments(timeline);
}

/// The loop of the pictures on the sheet.
Loop list_loop(Loop loop, const SpriteSheetForm& form)
{
    return loop == Loop::ping_pong && form.has_way_back ? Loop::repeat : loop;
}

std::string sheet_json(const std::string& image, const Picture& sheet, const Grid& grid,
                       const std::vector<FilmMoment>& moments, const Timeline& timeline, Loop loop)
{
    Json frames = Json::array();
    for (std::size_t number = 0; number < moments.size(); ++number) {
        const std::int64_t ticks = moments[number].end - moments[number].begin;
        frames.push_back(frame_json(grid.place(number), timeline.seconds(ticks) * 1000));
    }
    const Json all{{"image", image},          {"width", sheet.size.width}, {"height", sheet.size.height},
                   {"columns", grid.columns}, {"loop", loop_name(loop)},   {"frames", frames}};
    return all.dump(2) + '\n';
}

}

std::filesystem::path sprite_list_path(const std::filesystem::path& sheet)
{
    return std::filesystem::path{sheet}.replace_extension(".json");
}

SpriteSheet write_sprite_sheet(const std::filesystem::path& target, FrameSource& source,
                               const Timeline& timeline, const SpriteSheetForm& form,
                               const ProgressCallback& on_progress)
{
    const std::vector<FilmMoment> moments = sheet_moments(timeline, form);
    const int filled =
        static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(form.columns), moments.size()));
    const Grid grid{filled, source.show(moments.front().time).size};
    const Rect last = grid.place(moments.size() - 1);
    Picture sheet = plain_picture(std::int64_t{filled} * grid.cell.width, std::int64_t{last.y} + last.height,
                                  {}, "the sheet");
    for (std::size_t done = 0; done < moments.size(); ++done) {
        on_progress(done, moments.size());
        const Rect place = grid.place(done);
        put(widen(source.show(moments[done].time)), sheet, place.x, place.y);
    }
    const std::string json = sheet_json(target.filename().string(), sheet, grid, moments, timeline,
                                        list_loop(timeline.stretch.loop, form));
    AtomicFile list{sprite_list_path(target)};
    AtomicFile image{target};
    list.write(std::as_bytes(std::span{json}));
    image.write(encoded_png(sheet));
    list.finish();
    image.finish();
    list.commit();
    image.commit();
    return {moments.size(), sheet.size};
}

}
