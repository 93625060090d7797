# Sets RESULT to a source made from TEMPLATE, in which @BYTES@ stands for the bytes of FILE as escapes of a string literal.
function(kfast_embedded_file RESULT TEMPLATE FILE)
    file(READ ${FILE} HEX HEX)
    string(REGEX REPLACE "(..)" "\\\\x\\1" BYTES "${HEX}")
    get_filename_component(SOURCE ${TEMPLATE} NAME_WLE)
    configure_file(${TEMPLATE} ${SOURCE} @ONLY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${FILE})
    set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${SOURCE} PROPERTIES
        COMPILE_OPTIONS -Wno-overlength-strings) # more than every compiler must take; ours do
    set(${RESULT} ${CMAKE_CURRENT_BINARY_DIR}/${SOURCE} PARENT_SCOPE)
endfunction()
