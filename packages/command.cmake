# What belongs to the command: firmware for boards, texts to read, and what the command itself writes for shells and editors.
include(${PROJECT_SOURCE_DIR}/cmake/firmware_images.cmake)
kfast_install_firmware(${KFAST_BOARD_BUILDS}/pico OPTIONAL)

set(TEXTS ${CMAKE_INSTALL_DATADIR}/doc/kfast)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/NOTICE
    DESTINATION ${TEXTS} COMPONENT kfast)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs ${PROJECT_SOURCE_DIR}/examples DESTINATION ${TEXTS} COMPONENT kfast)

# They are written by a command that runs on the computer that builds it: for another one, by the one that is built beside
# it, if it is.
set(KFAST_WRITER $<TARGET_FILE:kfast>)
if(CMAKE_CROSSCOMPILING)
    set(KFAST_WRITER ${KFAST_BOARD_BUILDS}/host/bin/kfast)
endif()
find_program(KFAST_PYTHON3 python3)
if(KFAST_PYTHON3)
    file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/install_written_files.cmake CONTENT
"set(KFAST ${KFAST_WRITER})
set(PYTHON ${KFAST_PYTHON3})
set(DATA ${CMAKE_INSTALL_DATADIR})
set(MANUAL ${CMAKE_INSTALL_MANDIR})
set(BUILD ${CMAKE_CURRENT_BINARY_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/install_written_files.cmake)
")
    install(SCRIPT ${CMAKE_CURRENT_BINARY_DIR}/install_written_files.cmake COMPONENT kfast)
endif()

# What starts the command of the tar that needs no installation: scripts/portable_tar.py.
if(NOT KFAST_SANITIZE) # whose libraries are not linked statically
    add_executable(kfast_launcher portable/launcher.c)
    target_compile_definitions(kfast_launcher PRIVATE _GNU_SOURCE)
    target_link_options(kfast_launcher PRIVATE -static)
endif()
