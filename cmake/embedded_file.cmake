# Sets RESULT to the source NAME made from TEMPLATE, in which @BYTES@ stands for the bytes of FILE as escapes of a string
# literal, and @OTHER@ for the variable OTHER of the caller.
function(kfast_embedded_file RESULT TEMPLATE FILE NAME)
    file(READ ${FILE} HEX HEX)
    string(REGEX REPLACE "(..)" "\\\\x\\1" BYTES "${HEX}")
    configure_file(${TEMPLATE} ${NAME} @ONLY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${FILE})
    set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${NAME} PROPERTIES
        COMPILE_OPTIONS -Wno-overlength-strings) # more than every compiler must take; ours do
    set(${RESULT} ${CMAKE_CURRENT_BINARY_DIR}/${NAME} PARENT_SCOPE)
endfunction()
