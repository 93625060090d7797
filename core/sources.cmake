# Shared by the host library and the device images, which compile the core for their own processor.
set(KFAST_CORE_SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/angle.cpp
    ${CMAKE_CURRENT_LIST_DIR}/canvas_map.cpp
    ${CMAKE_CURRENT_LIST_DIR}/coverage_row.cpp
    ${CMAKE_CURRENT_LIST_DIR}/crc32.cpp
    ${CMAKE_CURRENT_LIST_DIR}/edge_budget.cpp
    ${CMAKE_CURRENT_LIST_DIR}/edge_list.cpp
    ${CMAKE_CURRENT_LIST_DIR}/live_strokes.cpp
    ${CMAKE_CURRENT_LIST_DIR}/object_view.cpp
    ${CMAKE_CURRENT_LIST_DIR}/packed_drawing.cpp
    ${CMAKE_CURRENT_LIST_DIR}/player.cpp
    ${CMAKE_CURRENT_LIST_DIR}/scene_view.cpp
    ${CMAKE_CURRENT_LIST_DIR}/segment.cpp
    ${CMAKE_CURRENT_LIST_DIR}/stroke_outline.cpp
    ${CMAKE_CURRENT_LIST_DIR}/stroke_style.cpp
    ${CMAKE_CURRENT_LIST_DIR}/sweep.cpp
    ${CMAKE_CURRENT_LIST_DIR}/velocity_law.cpp)
