# Installs what is written with the command's own words: manual pages, completions and files for editors. KFAST is the
# command, PYTHON runs scripts, BUILD is a folder to write to; DATA and MANUAL are where the files go, within the prefix.
cmake_minimum_required(VERSION 3.25)

if(NOT EXISTS ${KFAST})
    message(STATUS "Without manual pages, completions and files for editors: there is no ${KFAST} to write them")
    return()
endif()

function(kfast_written_by FILE)
    execute_process(COMMAND ${KFAST} ${ARGN} OUTPUT_FILE ${FILE} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(install_here FOLDER)
    if(NOT IS_ABSOLUTE ${FOLDER})
        set(FOLDER ${CMAKE_INSTALL_PREFIX}/${FOLDER})
    endif()
    file(INSTALL ${ARGN} DESTINATION ${FOLDER})
endfunction()

string(RANDOM LENGTH 16 NAME) # installations may run at the same time
set(WRITTEN ${BUILD}/written_files/${NAME})

execute_process(COMMAND ${KFAST} man ${WRITTEN}/man OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB SECTIONS ${WRITTEN}/man/man*)
foreach(SECTION ${SECTIONS})
    file(GLOB PAGES ${SECTION}/*)
    execute_process(COMMAND gzip -9n ${PAGES} COMMAND_ERROR_IS_FATAL ANY) # as Debian wants them
    install_here(${MANUAL} ${SECTION})
endforeach()

kfast_written_by(${WRITTEN}/kfast completions bash)
install_here(${DATA}/bash-completion/completions ${WRITTEN}/kfast)
kfast_written_by(${WRITTEN}/_kfast completions zsh)
string(REGEX MATCH "/usr$" IS_DEBIANS ${CMAKE_INSTALL_PREFIX}) # packages have a folder of their own there
if(IS_DEBIANS)
    install_here(${DATA}/zsh/vendor-completions ${WRITTEN}/_kfast)
else()
    install_here(${DATA}/zsh/site-functions ${WRITTEN}/_kfast)
endif()
kfast_written_by(${WRITTEN}/kfast.fish completions fish)
install_here(${DATA}/fish/vendor_completions.d ${WRITTEN}/kfast.fish)

execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/../scripts/make_editor_files.py ${KFAST} ${WRITTEN}/editors
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
install_here(${DATA}/kfast ${WRITTEN}/editors)

file(REMOVE_RECURSE ${WRITTEN})
