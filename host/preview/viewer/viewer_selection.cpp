#include "host/preview/viewer/viewer_selection.hpp"

#include "host/preview/viewer/viewer.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <utility>

namespace kfast {

std::optional<ItemName> name_of(std::optional<std::size_t> item, const TimeTable& table)
{
    const auto row = std::ranges::find(table.rows, item, &TimeRow::item);
    if (row == table.rows.end())
        return std::nullopt;
    const auto before =
        std::count_if(table.rows.begin(), row, [&](const TimeRow& other) { return other.name == row->name; });
    return ItemName{row->name, static_cast<std::size_t>(before)};
}

std::optional<std::size_t> item_of(const ItemName& name, const TimeTable& table)
{
    std::size_t before = 0;
    for (const TimeRow& row : table.rows)
        if (row.name == name.name && before++ == name.occurrence)
            return row.item;
    return std::nullopt;
}

std::vector<ItemName> names_of(const std::set<std::size_t>& items, const TimeTable& table)
{
    std::vector<ItemName> names;
    for (const std::size_t item : items)
        if (const auto name = name_of(item, table))
            names.push_back(*name);
    return names;
}

std::set<std::size_t> items_of(const std::vector<ItemName>& names, const TimeTable& table)
{
    std::set<std::size_t> items;
    for (const ItemName& name : names)
        if (const auto item = item_of(name, table))
            items.insert(*item);
    return items;
}

std::optional<std::size_t> item_beside(std::optional<std::size_t> item, std::ptrdiff_t rows,
                                       const TimeTable& table)
{
    const auto count = static_cast<std::ptrdiff_t>(table.rows.size());
    const auto here = std::ranges::find(table.rows, item, &TimeRow::item) - table.rows.begin();
    const std::ptrdiff_t next = (here + rows + count + 1) % (count + 1);
    if (next == count)
        return std::nullopt;
    return table.rows[static_cast<std::size_t>(next)].item;
}

// The functions of a viewer for the object that is selected.

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
