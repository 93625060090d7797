# What is no template over the board: shared by the host library and the device images.
set(KFAST_FIRMWARE_SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/settings/board_record.cpp
    ${CMAKE_CURRENT_LIST_DIR}/run/controls.cpp
    ${CMAKE_CURRENT_LIST_DIR}/link/checksum.cpp
    ${CMAKE_CURRENT_LIST_DIR}/link/playback_session.cpp
    ${CMAKE_CURRENT_LIST_DIR}/link/scene_memory.cpp
    ${CMAKE_CURRENT_LIST_DIR}/link/transfer.cpp
    ${CMAKE_CURRENT_LIST_DIR}/slots/slot_directory.cpp
    ${CMAKE_CURRENT_LIST_DIR}/slots/slot_pool.cpp)
