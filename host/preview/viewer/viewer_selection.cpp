// What a viewer does with the object that is selected.

#include "host/preview/viewer/viewer.hpp"

#include "host/program/failure.hpp"

#include <utility>

namespace kfast {

std::string_view Viewer::selected_name() const
{
    const TimeRow* const row = time_table().row_of(view_.selected);
    return row == nullptr ? std::string_view{} : row->name;
}

std::optional<ItemFacts> Viewer::selected_facts()
{
    return view_.selected ? std::optional{shown_.layers->facts(*playback_, *view_.selected)} : std::nullopt;
}

std::optional<TextLine> Viewer::selected_line() const
{
    const SceneFile& scene = shown_.scene->scene;
    if (!view_.selected || *view_.selected >= scene.item_places.size())
        return std::nullopt;
    const SourceSpan& place = scene.item_places[*view_.selected];
    return TextLine{shown_.scene->file, line_column(scene.text, place.offset).line};
}

TextLine Viewer::line_to_edit() const
{
    const std::filesystem::path& tried = reader_.tried();
    if (const auto mistake = line_of_mistake(errors(), tried))
        return {tried, *mistake};
    const OpenedScene& scene = *shown_.scene;
    if (!scene.scene.was_text)
        throw Failure(scene.file.filename().string() + " is compiled: edit the text that it was made from");
    return selected_line().value_or(TextLine{scene.file});
}

void Viewer::edit()
{
    notice_.clear();
    try {
        if (editor_ == nullptr)
            throw Failure("an editor is opened from a window or a terminal alone");
        const TextLine line = line_to_edit();
        editor_->open(line);
        notify("line " + std::to_string(line.line) + " is opened in the editor");
    } catch (const Failure& failure) {
        notify(failure.what());
    }
}

void Viewer::fold(std::size_t item)
{
    if (view_.unfolded.erase(item) == 0)
        view_.unfolded.insert(item);
}

void Viewer::fold_selected()
{
    if (view_.selected)
        return fold(*view_.selected);
    if (!std::exchange(view_.unfolded, {}).empty())
        return;
    for (const TimeRow& row : time_table().rows)
        view_.unfolded.insert(row.item);
}

}
