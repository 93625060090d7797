# What every firmware image has in common: how the core is compiled for a CPU without an operating system.
include(${PROJECT_SOURCE_DIR}/cmake/native_program.cmake)
include(${PROJECT_SOURCE_DIR}/core/sources.cmake)
include(${PROJECT_SOURCE_DIR}/firmware/sources.cmake)

# Flash is short, so all is compiled for size but what every row of a picture, or every corner and point of a beam, goes
# through.
set(KFAST_EVERY_ROW
    player raster/coverage
    beam/beam_lines beam/beam_route beam/line_interpolator beam/nearest_neighbour beam/point_sequencer beam/point_stream
    beam/tour)
list(TRANSFORM KFAST_EVERY_ROW PREPEND ${PROJECT_SOURCE_DIR}/core/)
list(TRANSFORM KFAST_EVERY_ROW APPEND .cpp)

# What is done once for a scene or for an item of a picture.
set(KFAST_EACH_ITEM
    math/affine math/space
    parse_scene scene/input_view scene/item_view scene/scene_view scene/track_view
    prepared/key_timeline prepared/preparer prepared/prepared_scene
    pose/item_state pose/scene_state pose/object_strokes
    scene_walk tracer)
list(TRANSFORM KFAST_EACH_ITEM PREPEND ${PROJECT_SOURCE_DIR}/core/)
list(TRANSFORM KFAST_EACH_ITEM APPEND .cpp)

# What no picture waits for long, also in images that are compiled for speed.
set(KFAST_SELDOM ${KFAST_FIRMWARE_SOURCES} ${KFAST_EACH_ITEM})

set(KFAST_DEVICE_OPTIONS
    -ffreestanding -ffunction-sections -fdata-sections
    $<$<COMPILE_LANGUAGE:CXX>:-fno-exceptions>
    $<$<COMPILE_LANGUAGE:CXX>:-fno-rtti>
    $<$<COMPILE_LANGUAGE:CXX>:-fno-threadsafe-statics>
    $<$<COMPILE_LANGUAGE:CXX>:-fno-use-cxa-atexit>
    -fno-unwind-tables -fno-asynchronous-unwind-tables)

# Not among KFAST_FIRMWARE_SOURCES: a computer has these functions already.
set(KFAST_DEVICE_MEMORY ${PROJECT_SOURCE_DIR}/firmware/chip/memory.cpp)

# The compiler options that choose a CPU. Those of the A profile run in ARM state, without an MMU, and nothing is read or
# written across words then.
function(kfast_cpu_options OUT CPU)
    set(OPTIONS -mcpu=${CPU} -mthumb)
    if(CPU MATCHES "^cortex-a")
        set(OPTIONS -mcpu=${CPU} -marm -mfloat-abi=soft -mno-unaligned-access)
    endif()
    if(CPU STREQUAL cortex-m4)
        list(APPEND OPTIONS -mfloat-abi=hard -mfpu=fpv4-sp-d16)
    endif()
    set(${OUT} ${OPTIONS} PARENT_SCOPE)
endfunction()

# The core, and what else is no board's own, compiled once for a CPU: sets OUT to its objects.
function(kfast_device_objects OUT CPU)
    set(NAME kfast_${CPU})
    set(${OUT} $<TARGET_OBJECTS:${NAME}> PARENT_SCOPE)
    if(TARGET ${NAME})
        return()
    endif()
    kfast_cpu_options(CPU_OPTIONS ${CPU})
    add_library(${NAME} OBJECT ${KFAST_DEVICE_MEMORY} ${KFAST_FIRMWARE_SOURCES} ${KFAST_CORE_SOURCES})
    set_source_files_properties(${KFAST_EVERY_ROW} PROPERTIES COMPILE_OPTIONS -O2)
    set_source_files_properties(${KFAST_SELDOM} PROPERTIES COMPILE_OPTIONS -Os)
    set_source_files_properties(${KFAST_DEVICE_MEMORY} PROPERTIES
        COMPILE_OPTIONS "-fno-tree-loop-distribute-patterns;-fno-lto")
    target_compile_options(${NAME} PRIVATE ${CPU_OPTIONS} ${KFAST_DEVICE_OPTIONS})
    target_link_libraries(${NAME} PRIVATE kfast_firmware)
    kfast_compile_core_together(${NAME})
endfunction()

# kfast_device_image(<name> CPU <cpu> LINKER_SCRIPT <file> SOURCES <file>...): the core and what else is no board's own,
# and the sources of the board, compiled for the CPU and linked without any library but the compiler's own.
function(kfast_device_image NAME)
    cmake_parse_arguments(PARSE_ARGV 1 IMAGE "" "CPU;LINKER_SCRIPT" "SOURCES")
    kfast_cpu_options(CPU_OPTIONS ${IMAGE_CPU})
    kfast_device_objects(OBJECTS ${IMAGE_CPU})
    add_executable(${NAME} ${IMAGE_SOURCES} ${OBJECTS})
    target_compile_options(${NAME} PRIVATE ${CPU_OPTIONS} ${KFAST_DEVICE_OPTIONS})
    target_link_libraries(${NAME} PRIVATE kfast_firmware gcc)
    target_link_options(${NAME} PRIVATE ${CPU_OPTIONS}
        -nostartfiles -nostdlib -T ${IMAGE_LINKER_SCRIPT} -Wl,--gc-sections -Wl,--fatal-warnings)
    set_target_properties(${NAME} PROPERTIES
        LINK_DEPENDS ${IMAGE_LINKER_SCRIPT}
        RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endfunction()

# kfast_flash_files(<name> ADDRESS <where flash begins>): the image <name>.elf also as <name>.bin, the bytes of flash from
# its beginning, and as <name>.uf2, for the drive of a boot loader.
function(kfast_flash_files NAME)
    cmake_parse_arguments(PARSE_ARGV 1 FLASH "" "ADDRESS" "")
    set(IMAGE ${PROJECT_BINARY_DIR}/${NAME})
    kfast_native_program(uf2
        SOURCES
            host/flash/uf2_main.cpp host/flash/uf2.cpp host/flash/uf2_contents.cpp host/flash/flash_image.cpp
            host/file/atomic_file.cpp host/file/input_file.cpp
        HEADERS
            host/flash/uf2.hpp host/flash/uf2_contents.hpp host/flash/flash_image.hpp host/compiler/pack/byte_writer.hpp
            core/bytes/byte_reader.hpp)
    add_custom_command(
        OUTPUT ${IMAGE}.bin ${IMAGE}.uf2
        COMMAND ${CMAKE_OBJCOPY} -O binary ${IMAGE}.elf ${IMAGE}.bin
        COMMAND ${PROJECT_BINARY_DIR}/native/uf2 ${IMAGE}.bin ${FLASH_ADDRESS} ${IMAGE}.uf2
        DEPENDS ${NAME}.elf ${PROJECT_BINARY_DIR}/native/uf2
        COMMENT "Making ${NAME}.bin and ${NAME}.uf2")
    add_custom_target(${NAME}.files ALL DEPENDS ${IMAGE}.bin ${IMAGE}.uf2)
endfunction()
