# Installs what `kfast man` and `kfast completions` write. KFAST is the command, BUILD a folder to write to; DATA and MANUAL
# are where the files go, within the prefix.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${KFAST} completions --help RESULT_VARIABLE STATUS OUTPUT_QUIET ERROR_QUIET)
if(NOT STATUS EQUAL 0) # this kfast writes none
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

set(WRITTEN ${BUILD}/shell_files)
file(REMOVE_RECURSE ${WRITTEN})
file(MAKE_DIRECTORY ${WRITTEN}/man)

execute_process(COMMAND ${KFAST} man ${WRITTEN}/man OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE PAGES ${WRITTEN}/man/*.1)
execute_process(COMMAND gzip -9n ${PAGES} COMMAND_ERROR_IS_FATAL ANY) # as Debian wants them
list(TRANSFORM PAGES APPEND .gz)
install_here(${MANUAL}/man1 ${PAGES})

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
