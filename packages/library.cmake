# The library for other programs. Unlike kfast_core in the command it counts nothing (core/bytes/op_counter.hpp), so it is compiled
# by itself.
include(CMakePackageConfigHelpers)
include(${PROJECT_SOURCE_DIR}/core/sources.cmake)

set(HEADERS_FOLDER ${CMAKE_INSTALL_INCLUDEDIR}/kfast) # with core/ and library/ in it, as includes are written
set(CONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/kfast)
set(PKG_CONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# kfast_installed_library(<name> SOURCES <file>... INCLUDES <folder within the installed headers>...)
function(kfast_installed_library NAME FILE)
    cmake_parse_arguments(PARSE_ARGV 2 LIBRARY "" "" "SOURCES;INCLUDES")
    add_library(kfast_installed_${NAME} STATIC ${LIBRARY_SOURCES})
    set_target_properties(kfast_installed_${NAME} PROPERTIES OUTPUT_NAME ${FILE} EXPORT_NAME ${NAME})
    target_compile_features(kfast_installed_${NAME} PUBLIC cxx_std_20)
    target_compile_options(kfast_installed_${NAME} PRIVATE -ffunction-sections -fdata-sections)
    install(TARGETS kfast_installed_${NAME} EXPORT kfast COMPONENT development
        INCLUDES DESTINATION ${LIBRARY_INCLUDES})
endfunction()

kfast_installed_library(core kfast_core SOURCES ${KFAST_CORE_SOURCES} INCLUDES ${HEADERS_FOLDER})
kfast_compile_core_together(kfast_installed_core)
kfast_installed_library(library kfast SOURCES ${PROJECT_SOURCE_DIR}/library/kfast.cpp INCLUDES ${HEADERS_FOLDER}/library)
target_link_libraries(kfast_installed_library PUBLIC kfast_installed_core)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/core ${PROJECT_SOURCE_DIR}/library DESTINATION ${HEADERS_FOLDER}
    COMPONENT development FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")

install(EXPORT kfast NAMESPACE kfast:: FILE kfast-targets.cmake DESTINATION ${CONFIG_FOLDER} COMPONENT development)
configure_package_config_file(kfast-config.cmake.in kfast-config.cmake INSTALL_DESTINATION ${CONFIG_FOLDER})
# Before version 1.0 anything may change with any version: docs/library.md.
write_basic_package_version_file(kfast-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/kfast-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/kfast-config-version.cmake
    DESTINATION ${CONFIG_FOLDER} COMPONENT development)

file(RELATIVE_PATH PREFIX_FROM_PKG_CONFIG /${PKG_CONFIG_FOLDER} /)
configure_file(kfast.pc.in kfast.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/kfast.pc DESTINATION ${PKG_CONFIG_FOLDER} COMPONENT development)
